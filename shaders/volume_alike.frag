// Of four rays, may those between them be interpolated? They may where what these and their neighbours saw runs nearly straight, and no edge of a surface lies between.
#include "volume_ray.glsl"
#include "tone.glsl"
uniform sampler2D coarse;       // what was seen by rays `apart` samples apart
uniform float alike;            // by how much they may stray from a straight run, of 1 as a screen shows it; by twice as much they may differ
uniform int among_surfaces;     // 0: there are none, and no depths to look at
uniform sampler2D depth_from;   // as in volume.frag
uniform sampler2D depth_to;
uniform sampler2D depth_opaque;

layout(location = 0) out float out_alike;   // 1: they may

const float one_surface = 4.0;   // steps of the ray: deeper apart, two samples see different surfaces, or one sees none

float depth_in_eye_space(sampler2D depths, ivec2 at) {
  float depth = texelFetch(depths, min(at, textureSize(depths, 0) - 1), 0).r;
  if (depth >= 1.0) return -endless;
  float ndc = 2.0 * depth - 1.0;
  return parallel != 0 ? (ndc - eye_to_clip[3][2]) / eye_to_clip[2][2] : -eye_to_clip[3][2] / (ndc + eye_to_clip[2][2]);
}

/// Of all samples between the four rays, the last ones included.
bool surfaces_are_one(ivec2 first_sample, int reach) {
  vec3 low = vec3(endless), high = vec3(-endless);
  for (int y = 0; y <= reach; ++y)
    for (int x = 0; x <= reach; ++x) {
      ivec2 at = first_sample + ivec2(x, y);
      vec3 depths = vec3(depth_in_eye_space(depth_from, at), depth_in_eye_space(depth_to, at), depth_in_eye_space(depth_opaque, at));
      low = min(low, depths);
      high = max(high, depths);
    }
  return all(lessThanEqual(high - low, vec3(one_surface * stride)));
}

vec4 shown(vec4 seen) { return vec4(encoded(shoulder(max(seen.rgb, 0.0))), 0.5 * seen.a); }

vec4 shown_at(ivec2 cell) { return shown(texelFetch(coarse, clamp(cell, ivec2(0), textureSize(coarse, 0) - 1), 0)); }

/// How far what four rays in a row saw is from running straight through the middle two.
vec4 bend(vec4 a, vec4 b, vec4 c, vec4 d) { return max(abs(a - b - b + c), abs(b - c - c + d)); }

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  vec4 a = shown_at(cell), b = shown_at(cell + ivec2(1, 0)), c = shown_at(cell + ivec2(0, 1)), d = shown_at(cell + 1);
  vec4 bent = max(max(bend(shown_at(cell + ivec2(-1, 0)), a, b, shown_at(cell + ivec2(2, 0))), bend(shown_at(cell + ivec2(-1, 1)), c, d, shown_at(cell + ivec2(2, 1)))),
                  max(bend(shown_at(cell + ivec2(0, -1)), a, c, shown_at(cell + ivec2(0, 2))), bend(shown_at(cell + ivec2(1, -1)), b, d, shown_at(cell + ivec2(1, 2)))));
  bent = max(bent, abs(a + d - b - c));
  vec4 differ = max(max(a, b), max(c, d)) - min(min(a, b), min(c, d));
  bool straight = all(lessThanEqual(bent, vec4(alike))) && all(lessThanEqual(differ, vec4(2.0 * alike)));
  out_alike = straight && (among_surfaces == 0 || surfaces_are_one(apart * cell, apart)) ? 1.0 : 0.0;
}
