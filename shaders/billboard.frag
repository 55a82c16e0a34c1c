// What is written on the sheet, or one colour. The sheet's colours are encoded as the target's are, and multiplied by their opacity.
uniform sampler2D sheet;
uniform vec4 plain;        // used where `sheet_counts` is 0
uniform float sheet_counts;
uniform float light;

in vec2 at;

layout(location = 0) out vec4 out_colour;

void main() {
  // Four places of the pixel, each between four texels: letters stay letters where a pixel covers two or three of the sheet's.
  vec2 across = 0.25 * dFdx(at), along = 0.25 * dFdy(at);
  vec4 written = texture(sheet, at + across + along) + texture(sheet, at + across - along) + texture(sheet, at - across + along) + texture(sheet, at - across - along);
  vec4 colour = mix(plain, 0.25 * written, sheet_counts);
  out_colour = vec4(light * colour.rgb, colour.a);
}
