// A canal's wall tells how deep below the orifice it is: by its hue and by a ring every step, a millimetre in a tooth of usual size, bolder every five.
// Hues that every kind of colour vision tells apart: ivory, amber, teal, blue. Linear.
const vec3 depth_amber = vec3(0.791, 0.352, 0.060);    // at 4 steps
const vec3 depth_teal = vec3(0.061, 0.445, 0.337);     // at 9
const vec3 depth_blue = vec3(0.110, 0.150, 0.620);     // from 14 on

/// 1 on a ring of this half width at 0; never thinner than a pixel, `pixel` wide.
float ring_at(float off, float half_width, float pixel) {
  float half_drawn = max(half_width, 0.6 * pixel);
  return 1.0 - smoothstep(half_drawn - 0.5 * pixel, half_drawn + 0.5 * pixel, abs(off));
}

/// `depth`: in steps; `pixel`: how much of it a pixel spans.
vec3 with_depth(vec3 base, float depth, float pixel) {
  if (depth <= 0.0) return base;
  vec3 hue = depth < 4.0 ? mix(base, depth_amber, depth / 4.0)
           : depth < 9.0 ? mix(depth_amber, depth_teal, (depth - 4.0) / 5.0)
                         : mix(depth_teal, depth_blue, min((depth - 9.0) / 5.0, 1.0));
  hue = mix(base, hue, 0.8);
  float far = smoothstep(0.15, 0.45, pixel);            // where rings would run into each other
  float whole = round(depth), fifth = 5.0 * round(depth / 5.0);
  float ring = whole > 0.5 ? 0.75 * ring_at(depth - whole, 0.014, pixel) : 0.0;
  if (fifth > 0.5) ring = max(ring, 0.95 * ring_at(depth - fifth, 0.035, pixel));
  return mix(hue, 0.06 * hue, (1.0 - far) * ring);
}
