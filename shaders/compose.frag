// One layer's light, its ambient part darkened by the occlusion; blended under what is already there.
uniform sampler2D light;
uniform sampler2D ambient;
uniform sampler2D occlusion;
uniform ivec2 low;            // what is drawn lies from here
uniform ivec2 high;           // to before here
uniform int occluded;
uniform float same_surface;   // metres of depth within which neighbours share their occlusion

layout(location = 0) out vec4 out_colour;

float evened_occlusion(ivec2 pixel) {
  vec2 here = texelFetch(occlusion, pixel, 0).rg;
  float sum = 0.0, weights = 0.0;
  for (int y = -2; y < 2; ++y)
    for (int x = -2; x < 2; ++x) {
      vec2 there = texelFetch(occlusion, clamp(pixel + ivec2(x, y), low, high - 1), 0).rg;
      float weight = abs(there.g - here.g) < same_surface ? 1.0 : 0.0;
      sum += weight * there.r;
      weights += weight;
    }
  return sum / max(weights, 1.0);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 own = texelFetch(light, pixel, 0);
  if (own.a == 0.0) discard;
  vec4 sky = texelFetch(ambient, pixel, 0);
  if (occluded != 0 && sky.a > 0.0) {   // without ambient light: lines and pictures, which no light makes
    float open = evened_occlusion(pixel);
    // In a narrow fissure the lamps are mostly hidden too, though less than the sky; light bounced there takes on warmth.
    sky.rgb *= pow(vec3(open), vec3(0.85, 1.0, 1.1));
    own.rgb *= mix(1.0, open, 0.55);
  }
  out_colour = vec4(own.rgb + sky.rgb, own.a);
}
