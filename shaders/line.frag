// Everything within half a width of the line, round at its ends. HIDDEN: only what lies behind the opaque surfaces, faintly.
in vec3 world_position;
flat in vec2 first_pixel;
flat in vec2 second_pixel;

uniform vec3 colour;          // linear
uniform vec3 rim_colour;
uniform float half_width;     // pixels
uniform float rim;
uniform float opacity;
uniform vec4 section;
uniform float section_slack;
#ifdef HIDDEN
uniform sampler2D opaque_depth;
#endif

layout(location = 0) out vec4 out_light;
layout(location = 1) out vec4 out_ambient;
layout(location = 2) out float out_depth;

void main() {
  if (dot(section.xyz, world_position) > section.w + section_slack) discard;
#ifdef HIDDEN
  float before = texelFetch(opaque_depth, ivec2(gl_FragCoord.xy), 0).r;   // 0: what lenses hide
  if (gl_FragCoord.z <= before || before <= 0.0) discard;
#endif
  vec2 along = second_pixel - first_pixel, here = gl_FragCoord.xy - first_pixel;
  float part = clamp(dot(here, along) / max(dot(along, along), 1e-8), 0.0, 1.0);
  float off = length(here - part * along);
  if (off > half_width + rim) discard;
  out_light = vec4(opacity * (off > half_width ? rim_colour : colour), opacity);
  out_ambient = vec4(0.0);
  out_depth = gl_FragCoord.z;
}
