// The grain of a cut material: noise that is fixed in space, so that it stays with the tooth when eye or plane move.
// Integers decide, so that every driver draws the same.
float grain_at(ivec3 place) {
  uvec3 p = uvec3(place);
  uint h = p.x * 0x8da6b343u ^ p.y * 0xd8163841u ^ p.z * 0xcb1ab31fu;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return float((h ^ (h >> 15)) >> 8) / 16777215.0;
}

/// 0 to 1, one half on average; smooth within cells of side 1.
float noise(vec3 at) {
  vec3 low = floor(at), part = at - low;
  ivec3 c = ivec3(low);
  vec3 t = part * part * (3.0 - 2.0 * part);
  vec4 x = mix(vec4(grain_at(c), grain_at(c + ivec3(0, 1, 0)), grain_at(c + ivec3(0, 0, 1)), grain_at(c + ivec3(0, 1, 1))),
               vec4(grain_at(c + ivec3(1, 0, 0)), grain_at(c + ivec3(1, 1, 0)), grain_at(c + ivec3(1, 0, 1)), grain_at(c + ivec3(1))), t.x);
  vec2 y = mix(x.xz, x.yw, t.y);
  return mix(y.x, y.y, t.z);
}

/// About 1: what a colour is multiplied with. `at` counts in grains; what is finer than a pixel fades.
float grain(vec3 at) {
  vec3 step = fwidth(at);
  float coarse = clamp(1.5 - 1.5 * max(step.x, max(step.y, step.z)), 0.0, 1.0);
  float fine = clamp(1.5 - 3.4 * max(step.x, max(step.y, step.z)), 0.0, 1.0);
  return 1.0 + 0.24 * coarse * (noise(at) - 0.5) + 0.2 * fine * (noise(2.27 * at + 31.7) - 0.5);
}
