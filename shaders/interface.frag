// Letters come from an atlas of one channel; everything else from its white texel.
uniform sampler2D letters;

in vec2 at;
in vec4 tint;

layout(location = 0) out vec4 out_colour;

void main() { out_colour = vec4(tint.rgb, tint.a * texture(letters, at).r); }
