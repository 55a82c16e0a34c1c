// The ray of a sample through a grid of values: where it runs within the grid and the section, and how it steps along.
// Lengths in the world's unit, which is the metre on the desktop and the millimetre on the page; a place in the grid is counted in values, the first one's at (0, 0, 0).
uniform mat4 eye_to_world;
uniform mat4 eye_to_clip;
uniform mat4 clip_to_eye;
uniform vec2 pixels;
uniform int apart;          // samples from a ray to the next along either side of the picture; 1: a ray for each
uniform int parallel;
uniform vec4 section;       // keeps what has dot(xyz, position) <= w
uniform vec3 first;         // where the first value's place is
uniform vec3 spacing;       // from one to the next
uniform vec3 size;          // values along each axis
uniform float stride;       // length of a step
uniform sampler3D values;
uniform sampler3D bricks;   // of a brick the distance in bricks to the next that has something to show, over 255
uniform float brick_side;   // values

struct Ray {
  vec3 eye_origin, eye_direction;
  vec3 origin, direction;   // of places in the grid, for each unit of length
  vec3 inverse;             // of the direction, each by itself
  float begin, end;
};

const float endless = 1e30;

/// The part of the ray for which origin + t * direction lies between.
void clip(float origin, float direction, float low, float high, inout Ray ray) {
  if (direction == 0.0) {
    if (origin < low || origin > high) ray.end = -endless;
    return;
  }
  float one = (low - origin) / direction, other = (high - origin) / direction;
  ray.begin = max(ray.begin, min(one, other));
  ray.end = min(ray.end, max(one, other));
}

/// The sample whose ray this fragment casts.
ivec2 sample_cast() { return apart * ivec2(gl_FragCoord.xy); }

Ray ray_of_sample() {
  vec2 place = 2.0 * (vec2(sample_cast()) + 0.5) / pixels - 1.0;
  vec4 near = clip_to_eye * vec4(place, -1.0, 1.0);
  near /= near.w;
  Ray ray;
  ray.eye_origin = parallel != 0 ? vec3(near.xy, 0.0) : vec3(0.0);
  ray.eye_direction = parallel != 0 ? vec3(0.0, 0.0, -1.0) : normalize(near.xyz);
  vec3 origin = (eye_to_world * vec4(ray.eye_origin, 1.0)).xyz, direction = mat3(eye_to_world) * ray.eye_direction;
  ray.begin = parallel != 0 ? -endless : 0.0;
  ray.end = endless;
  clip(dot(section.xyz, origin), dot(section.xyz, direction), -endless, section.w, ray);
  ray.origin = (origin - first) / spacing;
  ray.direction = direction / spacing;
  ray.inverse = 1.0 / ray.direction;
  for (int axis = 0; axis < 3; ++axis) clip(ray.origin[axis], ray.direction[axis], -0.5, size[axis] - 0.5, ray);
  return ray;
}

/// How far along the ray a window depth lies; nothing lies at depth 1.
float way_to(Ray ray, float depth) {
  if (depth >= 1.0) return endless;
  float ndc = 2.0 * depth - 1.0;
  float z = parallel != 0 ? (ndc - eye_to_clip[3][2]) / eye_to_clip[2][2] : -eye_to_clip[3][2] / (ndc + eye_to_clip[2][2]);
  return z / ray.eye_direction.z;
}

vec3 place_at(Ray ray, float way) { return ray.origin + way * ray.direction; }

float value_at(vec3 place) { return textureLod(values, (place + 0.5) / size, 0.0).r; }

/// The number of the first step that reaches out of the empty bricks around `place`, which lies in step `number` or where it begins; `number` itself if they are not empty.
int step_beyond_emptiness(Ray ray, vec3 place, int number) {
  ivec3 brick = clamp(ivec3(max(place, vec3(0.0)) / brick_side), ivec3(0), textureSize(bricks, 0) - 1);
  int far = int(255.0 * texelFetch(bricks, brick, 0).r + 0.5);
  if (far == 0) return number;
  vec3 low = vec3(brick - far + 1) * brick_side, high = vec3(brick + far) * brick_side;
  low = mix(low, vec3(-1.0), lessThanEqual(low, vec3(0.0)));
  vec3 ways = mix((mix(low, high, greaterThan(ray.direction, vec3(0.0))) - ray.origin) * ray.inverse, vec3(endless), equal(ray.direction, vec3(0.0)));
  return max(number, int(floor(min((min(ways.x, min(ways.y, ways.z)) - ray.begin) / stride, 1e8))));
}

/// In eye space, from the higher values to the lower; of no length where all are equal. From the four corners of a tetrahedron, which is as good as six neighbours.
vec3 falling(vec3 place) {
  const float aside = 0.6;   // values: as smooth as differences of neighbours
  float a = value_at(place + aside * vec3(1.0, 1.0, 1.0)), b = value_at(place + aside * vec3(1.0, -1.0, -1.0));
  float c = value_at(place + aside * vec3(-1.0, 1.0, -1.0)), d = value_at(place + aside * vec3(-1.0, -1.0, 1.0));
  return transpose(mat3(eye_to_world)) * (vec3(c + d - a - b, b + d - a - c, b + c - a - d) / (4.0 * aside * spacing));
}
