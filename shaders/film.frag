// What rays lost, as a film shows it: white where much is swallowed. Rays that are within a solid where they pass the section enter or leave there.
#include "tone.glsl"
uniform sampler2D swallowed;   // of film_faces.frag, added up
uniform float latitude;        // attenuation that is white
uniform float middle;          // as there
uniform float least;           // for each unit of length: less is what rounding leaves over
uniform vec4 section;          // in eye space
uniform mat4 clip_to_eye;
uniform vec2 pixels;
uniform int parallel;
uniform int inverted;          // 1: dark where much is swallowed
uniform vec2 film;             // its width and height, square to where the eye looks; 0: no edge
uniform vec3 film_centre;      // in eye space

layout(location = 0) out vec4 out_colour;

const float beside_film = 0.16;

void main() {
  vec4 both = texelFetch(swallowed, ivec2(gl_FragCoord.xy), 0), far = clip_to_eye * vec4(2.0 * gl_FragCoord.xy / pixels - 1.0, 1.0, 1.0);
  vec3 place = far.xyz / far.w, begin = parallel != 0 ? vec3(place.xy, 0.0) : vec3(0.0), way = parallel != 0 ? vec3(0.0, 0.0, -1.0) : normalize(place);
  float approach = dot(section.xyz, way), sum = both.r;
  if (abs(both.g) > least && approach != 0.0) sum -= both.g * ((section.w - dot(section.xyz, begin)) / approach - middle);
  float part = clamp(sum / latitude, 0.0, 1.0);
  vec2 off = abs((begin + (film_centre.z - begin.z) / way.z * way - film_centre).xy);
  bool beside = film.x > 0.0 && any(greaterThan(off, 0.5 * film));
  out_colour = vec4(vec3(light_shown_as(beside ? beside_film : inverted != 0 ? 1.0 - part : part)), 1.0);
}
