// A part of each sample's ray through a volume, blended under what is already there.
// SHADED: emission and absorption after a transfer function; BY_SLOPE: less where values are flat. MAXIMUM, AVERAGE: of the values' places in a window. RADIOGRAPH: what is swallowed.
#include "volume_ray.glsl"
#ifdef SHADED
#include "lighting.glsl"
uniform sampler2D transfer;     // the transfer function summed over the values up to an entry: linear colour times extinction, and extinction for each unit of length
uniform vec2 transfer_range;    // the values of the first and the last entry
uniform int lit;
uniform float clear_slope;      // values for each unit of length: a surface for sure; flatter, the slope is noise, and light comes from all around
#ifdef BY_SLOPE
uniform vec2 slopes;            // values for each unit of length: what is flatter than the first is not seen, from the second on all is
#endif
uniform int among_surfaces;     // 0: there are none, and no depths to look at
uniform sampler2D depth_from;   // the ray begins behind what lies here
uniform sampler2D depth_to;     // and ends at what lies here
uniform sampler2D depth_opaque; // or here
uniform int from_the_eye;       // 1: the ray begins at the eye, whatever depth_from says
#else
#include "tone.glsl"
uniform float low;              // black
uniform float high;             // white
#endif
#ifdef RADIOGRAPH
#include "film_edge.glsl"
uniform float attenuation;      // for each unit of length of `high`; `low` has none
uniform float latitude;         // attenuation that is white
uniform int inverted;           // 1: or black
#endif

layout(location = 0) out vec4 out_colour;

#ifdef SHADED
const float roughness = 0.45;
const float nearly_opaque = 0.998;   // what lies behind changes nothing that eight bits show
const float worth_light = 0.01;      // of all light: so much is lit at once, where its middle is,
const int lit_together = 4;          // or what comes of so many steps
const float least_rise = 0.0005;     // of all values: below it the differences of sums lose digits

/// 1 - exp(-x) for x >= 0, off by at most 0.0003, in a fraction of the time that processors take for powers.
float swallowed(float x) {
  float q = 0.25 * x, root = 1.0 + q * (1.0 + q * (0.5 + q * (1.0 / 6.0 + q / 24.0))), squared = root * root;
  return 1.0 - 1.0 / (squared * squared);
}

vec3 lit_colour(Ray ray, float way, vec3 place, vec3 colour) {
  if (lit == 0) return colour;
  vec3 slope = falling(place);
  float steep = length(slope);
  float clarity = smoothstep(0.0, 1.0, steep / clear_slope);
  vec3 flat_colour = 0.6 * colour;
  if (clarity <= 0.0) return flat_colour;
  vec3 position = ray.eye_origin + way * ray.eye_direction, to_eye = -ray.eye_direction, normal = slope / steep;
  if (dot(normal, to_eye) < 0.0) normal = -normal;
  Reflected light = reflected(position, normal, to_eye, colour, roughness);
  return mix(flat_colour, light.diffuse + light.ambient + light.gloss, clarity);
}

/// The transfer function at a value, and summed over the values up to it.
struct Summed {
  vec4 here, sum;
};

Summed summed_up_to(float value, float entries) {
  float last_entry = float(textureSize(transfer, 0).x - 1), entry = clamp((value - transfer_range.x) * entries, 0.0, last_entry), below = min(floor(entry), last_entry - 1.0);
  vec4 lower = texelFetch(transfer, ivec2(int(below), 0), 0), here = (texelFetch(transfer, ivec2(int(below) + 1, 0), 0) - lower) * entries;
  return Summed(here, lower + (entry - below) / entries * here);
}

/// Where the middle of what runs straight from one extinction to another lies, of the way.
float middle_of(float one, float other) { return one + other > 0.0 ? (one + 2.0 * other) / (3.0 * (one + other)) : 0.5; }

/// How much of the extinction counts where the values are so steep.
float share_by_slope(vec3 place) {
#ifdef BY_SLOPE
  return clamp((length(falling(place)) - slopes.x) / (slopes.y - slopes.x), 0.0, 1.0);
#else
  return 1.0;
#endif
}

vec4 seen_along(Ray ray, ivec2 at) {
  float from = ray.begin, to = ray.end;
  if (among_surfaces != 0) {
    to = min(to, min(way_to(ray, texelFetch(depth_opaque, at, 0).r), way_to(ray, texelFetch(depth_to, at, 0).r)));
    if (from_the_eye == 0) from = max(from, way_to(ray, texelFetch(depth_from, at, 0).r));
  }
  bool any = from < to;
  int number = any ? int(floor((from - ray.begin) / stride)) : 0, last = any ? int(ceil((to - ray.begin) / stride)) : 0;
  float range = transfer_range.y - transfer_range.x, last_entry = float(textureSize(transfer, 0).x - 1), entries = last_entry / range;   // for each unit of value
  float flat_rise = least_rise * range;
  vec3 light = vec3(0.0);
  float left = 1.0, before = 0.0;
  Summed before_sum = Summed(vec4(0.0), vec4(0.0));
  bool known = false;   // `before` is the value where step `number` begins
  // Light is looked for once for each turn of the outer loop: where all of a processor's lanes do what any of them does, the inner one spares them the rest.
  while (number < last && 1.0 - left < nearly_opaque) {
    vec3 colours = vec3(0.0);
    float ways = 0.0, parts = 0.0;
    int until = last;
    while (number < until && 1.0 - left < nearly_opaque && parts <= worth_light) {
      float near = max(ray.begin + float(number) * stride, from), far = max(min(ray.begin + float(number + 1) * stride, to), near);
      vec3 place = place_at(ray, known ? far : near);
      float value = value_at(place);
      Summed here = summed_up_to(value, entries);
      if (known) {
        // The mean of values that run straight from one to the other: however steep the transfer function is between them, nothing is missed.
        float rise = value - before;
        vec4 mean = abs(rise) > flat_rise ? max((here.sum - before_sum.sum) / rise, 0.0) : here.here;
        if (mean.a > 0.0) {
          if (parts == 0.0) until = min(last, number + lit_together);
          float part = left * swallowed(mean.a * share_by_slope(place_at(ray, 0.5 * (near + far))) * (far - near));
          left -= part;
          parts += part;
          colours += part / mean.a * mean.rgb;
          ways += part * mix(near, far, middle_of(before_sum.here.a, here.here.a));
        }
        ++number;
      }
      before = value;
      before_sum = here;
      int next = step_beyond_emptiness(ray, place, number);
      known = next == number;
      number = next;
    }
    if (parts > 0.0) light += parts * lit_colour(ray, ways / parts, place_at(ray, ways / parts), colours / parts);
  }
  return vec4(light, 1.0 - left);
}
#else
vec4 seen_along(Ray ray, ivec2 at) {
#ifdef RADIOGRAPH
  if (misses_film(ray.eye_origin, ray.eye_direction)) return vec4(vec3(light_shown_as(beside_film)), 1.0);
  if (!(ray.begin < ray.end)) return vec4(vec3(light_shown_as(inverted != 0 ? 1.0 : 0.0)), 1.0);
#endif
  if (!(ray.begin < ray.end)) return vec4(0.0);
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
  found = clamp(found / latitude, 0.0, 1.0);
  if (inverted != 0) found = 1.0 - found;
#endif
  return vec4(vec3(light_shown_as(clamp(found, 0.0, 1.0))), 1.0);
}
#endif

void main() { out_colour = seen_along(ray_of_sample(), sample_cast()); }
