// From linear light to what a screen shows.

/// Highlights fade into white instead of stopping at it.
vec3 shoulder(vec3 colour) {
  const float start = 0.78;
  vec3 over = max(colour - start, 0.0);
  return min(colour, start) + (1.0 - start) * (1.0 - exp(-over / (1.0 - start)));
}

vec3 encoded(vec3 colour) {
  return mix(1.055 * pow(colour, vec3(1.0 / 2.4)) - 0.055, 12.92 * colour, lessThanEqual(colour, vec3(0.0031308)));
}
