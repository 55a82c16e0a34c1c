// A solid's surface, for the film of what it swallows.
layout(location = 0) in vec3 position;

uniform mat4 world_to_eye;
uniform mat4 eye_to_clip;

out vec3 eye_place;
out vec3 place;

void main() {
  vec4 eye = world_to_eye * vec4(position, 1.0);
  eye_place = eye.xyz;
  place = position;
  gl_Position = eye_to_clip * eye;
}
