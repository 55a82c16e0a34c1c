// How much of the sky a point sees, from the depths around it: obscurance summed over a spiral of samples (after McGuire,
// Mara, Luebke, "Scalable Ambient Obscurance", HPG 2012). Writes light (1: open) and the distance to the eye.
uniform sampler2D depth;
uniform mat4 eye_to_clip;
uniform mat4 clip_to_eye;
uniform vec2 pixels;
uniform ivec2 low;         // the depths from here
uniform ivec2 high;        // to before here are of this frame
uniform float reach;       // metres
uniform float strength;

layout(location = 0) out vec2 out_occlusion;

const int samples = 14;
const float turns = 5.0;
const float two_pi = 6.28318530718;
const float most_pixels = 220.0;

vec3 eye_position(ivec2 pixel, float z) {
  vec2 place = 2.0 * (vec2(pixel) + 0.5) / pixels - 1.0;
  vec4 eye = clip_to_eye * vec4(place, 2.0 * z - 1.0, 1.0);
  return eye.xyz / eye.w;
}

vec3 eye_position(ivec2 pixel) { return eye_position(pixel, texelFetch(depth, pixel, 0).r); }

/// Of the neighbours on both sides, the nearer in depth lies on the same surface. At the frame's edge there is but one.
vec3 step_along(vec3 here, ivec2 pixel, ivec2 offset) {
  vec3 ahead = eye_position(clamp(pixel + offset, low, high - 1)) - here;
  vec3 behind = here - eye_position(clamp(pixel - offset, low, high - 1));
  if (any(greaterThanEqual(pixel + offset, high))) return behind;
  if (any(lessThan(pixel - offset, low))) return ahead;
  return abs(ahead.z) < abs(behind.z) ? ahead : behind;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float z = texelFetch(depth, pixel, 0).r;
  if (z >= 1.0) {
    out_occlusion = vec2(1.0, 0.0);
    return;
  }
  vec3 here = eye_position(pixel, z);
  vec3 across = cross(step_along(here, pixel, ivec2(1, 0)) / reach, step_along(here, pixel, ivec2(0, 1)) / reach);
  vec3 normal = dot(across, across) > 0.0 ? normalize(across) : vec3(0.0, 0.0, 1.0);
  float w = eye_to_clip[2][3] * here.z + eye_to_clip[3][3];
  float disk = min(0.5 * pixels.y * reach * eye_to_clip[1][1] / w, most_pixels);

  // Sixteen turns of the spiral in a 4 x 4 block of pixels, which the 4 x 4 blur evens out.
  int turn = (pixel.x & 3) * 4 + (pixel.y & 3);
  turn = (turn * 7) & 15;
  float start = two_pi * float(turn) / 16.0;
  float sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    float part = (float(i) + 0.5 + float(turn) / 32.0) / (float(samples) + 0.5);
    float angle = start + part * turns * two_pi;
    ivec2 there = pixel + ivec2(round(part * disk * vec2(cos(angle), sin(angle))));
    if (any(lessThan(there, low)) || any(greaterThanEqual(there, high))) continue;
    vec3 towards = eye_position(there) - here;
    float squared = dot(towards, towards);
    float weight = max(1.0 - squared / (reach * reach), 0.0);
    float above = dot(towards, normal) / sqrt(squared + 1e-12 * reach * reach);
    sum += part * weight * max(above - 0.06, 0.0);
  }
  float open = max(1.0 - strength * 6.5 * sum / float(samples), 0.0);
  out_occlusion = vec2(open, -here.z);
}
