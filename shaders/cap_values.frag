// A section's cap that shows the grey values of a volume: what a screen shows is the value's place in the window, whatever the light.
#include "tone.glsl"

in Vertex {
  vec3 world_position;
  vec3 eye_position;
  vec3 eye_normal;
  float wall_depth;
  vec2 data;
} from;

uniform sampler3D values;
uniform vec3 first;      // where the first value's place is, metres
uniform vec3 spacing;      // from one to the next
uniform vec3 size;       // values along each axis
uniform float low;       // black
uniform float high;      // white

layout(location = 0) out vec4 out_light;
layout(location = 1) out vec4 out_ambient;   // none, so that no occlusion darkens it
layout(location = 2) out float out_depth;

void main() {
  // A value belongs to the middle of its texel.
  vec3 place = ((from.world_position - first) / spacing + 0.5) / size;
  float part = clamp((texture(values, place).r - low) / (high - low), 0.0, 1.0);
  out_light = vec4(vec3(light_shown_as(part)), 1.0);
  out_ambient = vec4(0.0);
  out_depth = gl_FragCoord.z;
}
