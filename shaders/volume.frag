// A part of each pixel's ray through a volume, blended under what is already there.
// SHADED: emission and absorption after a transfer function. MAXIMUM, AVERAGE: of the values' places in a window. RADIOGRAPH: what is swallowed.
#include "volume_ray.glsl"
#ifdef SHADED
#include "lighting.glsl"
uniform sampler2D transfer;     // linear colour, and extinction for each unit of length
uniform sampler2D sums;         // of extinction over the values up to here
uniform vec2 transfer_range;    // the values of the first and the last entry of both
uniform int lit;
uniform float clear_slope;        // values for each unit of length: a surface for sure; flatter, the slope is noise, and light comes from all around
uniform sampler2D depth_from;   // the ray begins behind what lies here
uniform sampler2D depth_to;     // and ends at what lies here
uniform sampler2D depth_opaque; // or here
uniform int from_the_eye;       // 1: at the eye, whatever depth_from says
#else
#include "tone.glsl"
uniform float low;              // black
uniform float high;             // white
#endif
#ifdef RADIOGRAPH
uniform float attenuation;      // for each unit of length of `high`; `low` has none
uniform float latitude;         // attenuation that is white
#endif

layout(location = 0) out vec4 out_colour;

#ifdef SHADED
const float roughness = 0.45;
const float nearly_opaque = 0.998;   // what lies behind changes nothing that eight bits show
const float worth_light = 0.003;
const float least_rise = 0.0005;     // of all values: below it the differences of sums lose digits

/// Where a value stands among so many entries.
float entry_of(float value, int last) { return clamp((value - transfer_range.x) / (transfer_range.y - transfer_range.x), 0.0, 1.0) * float(last); }

vec3 colour_of(float value) { return texelFetch(transfer, ivec2(int(entry_of(value, textureSize(transfer, 0).x - 1) + 0.5), 0), 0).rgb; }

float sum_to(float value) {
  int last = textureSize(sums, 0).x - 1;
  float place = entry_of(value, last);
  int below = min(int(place), last - 1);
  return mix(texelFetch(sums, ivec2(below, 0), 0).r, texelFetch(sums, ivec2(below + 1, 0), 0).r, place - float(below));
}

/// The mean extinction of values that run straight from one to the other: however steep the transfer function is between them, nothing is missed.
float mean_extinction(float before, float after) {
  float middle = 0.5 * (before + after), half_rise = max(0.5 * abs(after - before), least_rise * (transfer_range.y - transfer_range.x));
  float low = max(middle - half_rise, transfer_range.x), high = min(middle + half_rise, transfer_range.y);
  return max(sum_to(high) - sum_to(low), 0.0) / (high - low);
}

vec3 lit_colour(Ray ray, float way, vec3 place, vec3 colour) {
  vec3 slope = falling(place);
  float steep = length(slope);
  float clarity = smoothstep(0.0, 1.0, steep / clear_slope);
  if (lit == 0) return colour;
  vec3 flat_colour = 0.6 * colour;
  if (clarity <= 0.0) return flat_colour;
  vec3 position = ray.eye_origin + way * ray.eye_direction, to_eye = -ray.eye_direction, normal = slope / steep;
  if (dot(normal, to_eye) < 0.0) normal = -normal;
  Reflected light = reflected(position, normal, to_eye, colour, roughness);
  return mix(flat_colour, light.diffuse + light.ambient + light.gloss, clarity);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Ray ray = ray_of_pixel();
  float from = ray.begin, to = min(ray.end, way_to(ray, texelFetch(depth_opaque, pixel, 0).r));
  to = min(to, way_to(ray, texelFetch(depth_to, pixel, 0).r));
  if (from_the_eye == 0) from = max(from, way_to(ray, texelFetch(depth_from, pixel, 0).r));
  bool any = from < to;   // where it does not, what a driver makes of `discard` may still run through the loop
  int number = any ? int(floor((from - ray.begin) / stride)) : 0, last = any ? int(ceil((to - ray.begin) / stride)) : 0;
  vec3 light = vec3(0.0);
  float left = 1.0, before = 0.0;
  bool known = false;   // `before` is the value where step `number` begins
  while (number < last && 1.0 - left < nearly_opaque) {
    float near = max(ray.begin + float(number) * stride, from), far = min(ray.begin + float(number + 1) * stride, to);
    ++number;
    if (near >= far) continue;
    if (!known) before = value_at(place_at(ray, near));
    float after = value_at(place_at(ray, far)), middle = 0.5 * (before + after);
    float opacity = 1.0 - exp(-mean_extinction(before, after) * (far - near));
    before = after;
    known = true;
    if (opacity <= 0.0) {
      int next = step_beyond_emptiness(ray, place_at(ray, far), number);
      known = next == number;
      number = next;
      continue;
    }
    float way = 0.5 * (near + far);
    vec3 colour = colour_of(middle);
    if (left * opacity > worth_light) colour = lit_colour(ray, way, place_at(ray, way), colour);
    light += left * opacity * colour;
    left *= 1.0 - opacity;
  }
  if (left >= 1.0) discard;
  out_colour = vec4(light, 1.0 - left);
}
#else
void main() {
  Ray ray = ray_of_pixel();
  if (!(ray.begin < ray.end)) discard;
  int number = 0, last = int(ceil((ray.end - ray.begin) / stride));
  float found = 0.0;
  while (number < last) {
    float near = ray.begin + float(number) * stride, far = min(near + stride, ray.end);
    vec3 place = place_at(ray, 0.5 * (near + far));
    int next = step_beyond_emptiness(ray, place, number);
    if (next > number) {
      number = next;
      continue;
    }
    ++number;
    float part = (value_at(place) - low) / (high - low);
#ifdef MAXIMUM
    found = max(found, part);
#endif
#ifdef AVERAGE
    found += clamp(part, 0.0, 1.0) * (far - near);
#endif
#ifdef RADIOGRAPH
    found += attenuation * part * (far - near);
#endif
  }
#ifdef AVERAGE
  found /= ray.end - ray.begin;
#endif
#ifdef RADIOGRAPH
  found /= latitude;
#endif
  out_colour = vec4(vec3(light_shown_as(clamp(found, 0.0, 1.0))), 1.0);
}
#endif
