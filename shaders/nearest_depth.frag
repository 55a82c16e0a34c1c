// How far the nearest surface is, whether translucent or not: for a runtime that shifts the picture after the head. Lines count as surfaces.
uniform sampler2D opaque_depth;
uniform sampler2D first_depth;   // of the translucent layers
uniform int side;                // samples a pixel along one axis
uniform ivec2 corner;            // of the target's viewport
uniform ivec2 low;               // samples from here
uniform ivec2 high;              // to before here are of this frame

void main() {
  ivec2 sample0 = side * (ivec2(gl_FragCoord.xy) - corner);
  float nearest = 1.0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      ivec2 place = sample0 + ivec2(x, y);
      if (any(lessThan(place, low)) || any(greaterThanEqual(place, high))) continue;
      nearest = min(nearest, min(texelFetch(opaque_depth, place, 0).r, texelFetch(first_depth, place, 0).r));
    }
  gl_FragDepth = nearest > 0.0 ? nearest : 1.0;   // 0: what lenses hide
}
