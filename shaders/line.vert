// A line as a strip of two triangles in the plane of the picture, wide enough for its rim and its round ends.
layout(location = 0) in vec3 first_end;
layout(location = 1) in vec3 second_end;

uniform mat4 world_to_eye;
uniform mat4 eye_to_clip;
uniform vec2 pixels;
uniform float half_width;    // pixels, without the rim
uniform float rim;
uniform float lift;          // towards the eye, in pixels at the line's distance
uniform int parallel;

out vec3 world_position;
flat out vec2 first_pixel;
flat out vec2 second_pixel;

/// Ahead of the near plane if positive.
float ahead(vec4 clip) { return clip.z + clip.w; }

float lifted_depth(vec3 eye) {
  float pixel = 2.0 / (eye_to_clip[1][1] * pixels.y);   // metres, or metres for each metre of distance
  vec3 nearer = parallel != 0 ? eye + vec3(0.0, 0.0, lift * pixel) : (1.0 - min(lift * pixel, 0.5)) * eye;
  vec4 clip = eye_to_clip * vec4(nearer, 1.0);
  return clamp(clip.z / clip.w, -1.0, 1.0);
}

void main() {
  vec3 a = (world_to_eye * vec4(first_end, 1.0)).xyz, b = (world_to_eye * vec4(second_end, 1.0)).xyz;
  vec4 clip_a = eye_to_clip * vec4(a, 1.0), clip_b = eye_to_clip * vec4(b, 1.0);
  float ahead_a = ahead(clip_a), ahead_b = ahead(clip_b);
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  world_position = vec3(0.0);
  first_pixel = second_pixel = vec2(-1e6);
  if (ahead_a <= 0.0 && ahead_b <= 0.0) return;
  // What lies behind the near plane is left off, lest it come back through infinity.
  float from = ahead_a < 0.0 ? ahead_a / (ahead_a - ahead_b) : 0.0, to = ahead_b < 0.0 ? ahead_a / (ahead_a - ahead_b) : 1.0;
  vec3 eye_a = mix(a, b, from), eye_b = mix(a, b, to);
  clip_a = eye_to_clip * vec4(eye_a, 1.0);
  clip_b = eye_to_clip * vec4(eye_b, 1.0);
  vec2 screen_a = 0.5 * pixels * (1.0 + clip_a.xy / max(clip_a.w, 1e-9)), screen_b = 0.5 * pixels * (1.0 + clip_b.xy / max(clip_b.w, 1e-9));

  vec2 along = screen_b - screen_a;
  float size = length(along);
  along = size > 1e-4 ? along / size : vec2(1.0, 0.0);
  vec2 aside = vec2(-along.y, along.x);
  bool at_b = (gl_VertexID & 1) != 0;
  float reach = half_width + rim;
  vec2 place = (at_b ? screen_b + reach * along : screen_a - reach * along) + ((gl_VertexID & 2) != 0 ? reach : -reach) * aside;
  // Depth is linear in the picture, and so are the rest of the line's values near enough.
  gl_Position = vec4(2.0 * place / pixels - 1.0, lifted_depth(at_b ? eye_b : eye_a), 1.0);
  world_position = mix(first_end, second_end, at_b ? to : from);
  first_pixel = screen_a;
  second_pixel = screen_b;
}
