// Where the values along a pixel's ray first cross one value, from either side: lit, with its depth, as a surface is drawn.
#include "volume_ray.glsl"
#include "lighting.glsl"

uniform float iso;
uniform vec3 colour;   // linear

layout(location = 0) out vec4 out_light;
layout(location = 1) out vec4 out_ambient;
layout(location = 2) out float out_depth;

const float roughness = 0.38;

void main() {
  Ray ray = ray_of_sample();
  if (!(ray.begin < ray.end)) discard;
  int number = 0, last = int(ceil((ray.end - ray.begin) / stride));
  float before = value_at(place_at(ray, ray.begin)) - iso, crossing = endless;
  bool known = true;   // `before` is the value where step `number` begins
  while (number < last) {
    float near = ray.begin + float(number) * stride, far = min(near + stride, ray.end);
    int next = step_beyond_emptiness(ray, place_at(ray, 0.5 * (near + far)), number);
    if (next > number) {
      number = next;
      known = false;
      continue;
    }
    if (!known) before = value_at(place_at(ray, near)) - iso;
    float after = value_at(place_at(ray, far)) - iso;
    if ((before < 0.0) != (after < 0.0)) {
      bool below = before < 0.0;
      for (int halving = 0; halving < 12; ++halving) {
        float middle = 0.5 * (near + far);
        if ((value_at(place_at(ray, middle)) - iso < 0.0) == below) near = middle;
        else far = middle;
      }
      crossing = 0.5 * (near + far);
      break;
    }
    before = after;
    known = true;
    ++number;
  }
  if (crossing >= endless) discard;
  vec3 position = ray.eye_origin + crossing * ray.eye_direction, to_eye = -ray.eye_direction, slope = falling(place_at(ray, crossing));
  float steep = length(slope);
  vec3 normal = steep > 0.0 ? slope / steep : to_eye;
  if (dot(normal, to_eye) < 0.0) normal = -normal;
  vec4 clip = eye_to_clip * vec4(position, 1.0);
  float depth = 0.5 * clip.z / clip.w + 0.5;
  if (depth < 0.0 || depth >= 1.0) discard;
  Reflected light = reflected(position, normal, to_eye, colour, roughness);
  out_light = vec4(light.diffuse + light.gloss, 1.0);
  out_ambient = vec4(light.ambient, 1.0);
  out_depth = depth;
  gl_FragDepth = depth;
}
