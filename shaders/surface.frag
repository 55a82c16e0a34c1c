// A lit fragment, premultiplied, with its ambient light and its depth in targets of their own.
// DIRECT: the finished picture's colour instead, opaque and uncut: a shader that discards nothing is tested for depth first.
// GRAIN: a cut material, with its texture.
// PEEL: only what lies behind the layer before and in front of the opaque surfaces. WIRE: the triangles' edges are drawn.
#include "lighting.glsl"
#include "wall_depth.glsl"
#include "data_colour.glsl"
#ifdef DIRECT
#include "tone.glsl"
#endif
#ifdef GRAIN
#include "grain.glsl"
uniform float grain_size;        // metres
#endif

in Vertex {
  vec3 world_position;
  vec3 eye_position;
  vec3 eye_normal;
  float wall_depth;
  vec2 data;
} from;
#ifdef WIRE
noperspective in vec3 edge_distance;
uniform float wire_width;
#endif

uniform vec3 colour;             // linear
uniform float opacity;
uniform vec3 back_colour;        // of triangles seen from behind
uniform float least_back_opacity;
uniform vec4 section;            // cut away where dot(section.xyz, position) > section.w
uniform int parallel;
uniform int show_depth;          // not 0: the wall tells its depth or thickness
uniform float normal_sign;       // -1 for a surface that is shown inside out
#ifdef PEEL
uniform sampler2D layer_before;
uniform sampler2D opaque_depth;
uniform int first_layer;
#endif

#ifdef DIRECT
layout(location = 0) out vec4 out_colour;
#else
layout(location = 0) out vec4 out_light;
layout(location = 1) out vec4 out_ambient;
layout(location = 2) out float out_depth;
#endif

const float roughness = 0.38;
const vec3 wire_colour = vec3(0.02, 0.025, 0.035);

void main() {
#ifndef DIRECT
  if (dot(section.xyz, from.world_position) > section.w) discard;
#endif
#ifdef PEEL
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (gl_FragCoord.z >= texelFetch(opaque_depth, pixel, 0).r) discard;
  if (first_layer == 0 && gl_FragCoord.z <= texelFetch(layer_before, pixel, 0).r) discard;
#endif
  vec3 to_eye = parallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-from.eye_position);
  vec3 normal = normal_sign * normalize(from.eye_normal);
  if (!gl_FrontFacing) normal = -normal;

  // Seen edge-on a translucent wall is looked through lengthwise, so it is denser there.
  float slant = 1.0 - abs(dot(normal, to_eye));
  float alpha = opacity + (1.0 - opacity) * 0.75 * slant * slant * slant;
  alpha = gl_FrontFacing ? alpha : max(alpha, least_back_opacity);
  vec3 base = gl_FrontFacing ? colour : back_colour;
#ifndef GRAIN
  if (show_data != 0 && gl_FrontFacing) base = colour_of_data(from.data);
  if (show_depth != 0) base = with_depth(base, from.wall_depth, fwidth(from.wall_depth));
#endif
#ifdef GRAIN
  base *= grain(from.world_position / grain_size);
#endif
#ifdef WIRE
  float nearest = min(min(edge_distance.x, edge_distance.y), edge_distance.z);
  float line = 1.0 - smoothstep(0.5 * wire_width - 0.5, 0.5 * wire_width + 0.5, nearest);
  base = mix(base, wire_colour, 0.85 * line);
  alpha = mix(alpha, 1.0, 0.8 * line);
#endif
  Reflected light = reflected(from.eye_position, normal, to_eye, base, roughness);
#ifdef DIRECT
  out_colour = vec4(encoded(clamp(shoulder(light.diffuse + light.gloss + light.ambient), 0.0, 1.0)), 1.0);
#else
  out_light = vec4(alpha * light.diffuse + light.gloss, alpha);
  out_ambient = vec4(alpha * light.ambient, alpha);
  out_depth = gl_FragCoord.z;
#endif
}
