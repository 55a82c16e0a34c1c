// What is written on the sheet, or one colour. The sheet's colours are encoded as the target's are, and multiplied by their opacity.
uniform sampler2D sheet;
uniform vec4 plain;        // used where `sheet_counts` is 0
uniform float sheet_counts;

in vec2 at;

layout(location = 0) out vec4 out_colour;

void main() { out_colour = mix(plain, texture(sheet, at), sheet_counts); }
