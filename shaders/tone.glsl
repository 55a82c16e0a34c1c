// From linear light to what a screen shows.

/// Highlights fade into white instead of stopping at it.
vec3 shoulder(vec3 colour) {
  const float start = 0.78;
  vec3 over = max(colour - start, 0.0);
  return min(colour, start) + (1.0 - start) * (1.0 - exp(-over / (1.0 - start)));
}

/// The sRGB curve, fitted with square roots, which take a processor a fraction of a power's time: off by at most 0.0001.
vec3 encoded(vec3 colour) {
  vec3 root = sqrt(colour), fourth_root = sqrt(root);
  vec3 curve = 0.2544794 * fourth_root + 0.9127242 * root + (0.0356518 * root - 0.1322469) * colour - 0.0705083;
  return mix(curve, 12.92 * colour, lessThanEqual(colour, vec3(0.0031308)));
}

/// The linear light that `shoulder` and `encoded` turn into `shown`, 0 to 1 of what a screen can: for greys that must stay what they are.
float light_shown_as(float shown) {
  const float start = 0.78, nearly_all = 0.9999;
  float light = shown <= 0.04045 ? shown / 12.92 : pow((shown + 0.055) / 1.055, 2.4);
  if (light <= start) return light;
  return start - (1.0 - start) * log(1.0 - min((light - start) / (1.0 - start), nearly_all));
}
