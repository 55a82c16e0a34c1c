// From the linear supersampled picture to sRGB on the screen: mean of each pixel's samples, background, curve, encoding.
#include "tone.glsl"

uniform sampler2D picture;
uniform int side;              // samples a pixel along one axis
uniform ivec2 corner;          // of the target's viewport
uniform vec2 pixels;
uniform vec3 background_top;   // linear
uniform vec3 background_bottom;
uniform int transparent;

layout(location = 0) out vec4 out_colour;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - corner;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) sum += texelFetch(picture, side * pixel + ivec2(x, y), 0);
  sum /= float(side * side);
  if (transparent != 0) {
    vec3 colour = sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0);
    out_colour = vec4(encoded(clamp(shoulder(colour), 0.0, 1.0)), sum.a);
    return;
  }
  vec3 behind = mix(background_bottom, background_top, (float(pixel.y) + 0.5) / pixels.y);
  vec3 colour = sum.a > 0.0 ? shoulder(sum.rgb / sum.a) * sum.a : vec3(0.0);
  out_colour = vec4(encoded(clamp(colour + (1.0 - sum.a) * behind, 0.0, 1.0)), 1.0);
}
