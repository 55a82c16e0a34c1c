// Letters come from an atlas of one channel; everything else from its white texel.
uniform sampler2D letters;
uniform float grey;   // 1: the texture is a grey picture, not letters

in vec2 at;
in vec4 tint;

layout(location = 0) out vec4 out_colour;

void main() {
  float texel = texture(letters, at).r;
  out_colour = grey > 0.5 ? vec4(tint.rgb * texel, tint.a) : vec4(tint.rgb, tint.a * texel);
}
