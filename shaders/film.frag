// What rays lost, as a film shows it: white where much is swallowed. Rays that are within a solid where they pass the section enter or leave there.
#include "tone.glsl"
#include "film_edge.glsl"
uniform sampler2D swallowed;   // of film_faces.frag, added up
uniform float latitude;        // attenuation that is white
uniform float middle;          // as there
uniform float least;           // for each unit of length: less is what rounding leaves over
uniform vec4 section;          // in eye space
uniform mat4 clip_to_eye;
uniform vec2 pixels;
uniform int parallel;
uniform int inverted;          // 1: dark where much is swallowed

layout(location = 0) out vec4 out_colour;

void main() {
  vec4 both = texelFetch(swallowed, ivec2(gl_FragCoord.xy), 0), far = clip_to_eye * vec4(2.0 * gl_FragCoord.xy / pixels - 1.0, 1.0, 1.0);
  vec3 place = far.xyz / far.w, begin = parallel != 0 ? vec3(place.xy, 0.0) : vec3(0.0), way = parallel != 0 ? vec3(0.0, 0.0, -1.0) : normalize(place);
  float approach = dot(section.xyz, way), sum = both.r;
  if (abs(both.g) > least && approach != 0.0) sum -= both.g * ((section.w - dot(section.xyz, begin)) / approach - middle);
  float part = clamp(sum / latitude, 0.0, 1.0);
  float shown = misses_film(begin, way) ? beside_film : inverted != 0 ? 1.0 - part : part;
  out_colour = vec4(vec3(light_shown_as(shown)), 1.0);
}
