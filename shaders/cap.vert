// The section plane as a square around the model, its front towards the side that was cut away.
uniform mat4 world_to_eye;
uniform mat4 eye_to_clip;
uniform vec3 centre;
uniform vec3 across;    // half the square's side, at right angles to `along`
uniform vec3 along;
uniform vec3 normal;

invariant gl_Position;
out Vertex {
  vec3 world_position;
  vec3 eye_position;
  vec3 eye_normal;
  float wall_depth;
  vec2 data;
} to_next;

void main() {
  float u = (gl_VertexID & 1) == 0 ? -1.0 : 1.0, v = (gl_VertexID & 2) == 0 ? -1.0 : 1.0;
  vec3 position = centre + u * across + v * along;
  vec4 eye = world_to_eye * vec4(position, 1.0);
  to_next.world_position = position;
  to_next.wall_depth = -1.0;
  to_next.data = vec2(0.0);
  to_next.eye_position = eye.xyz;
  to_next.eye_normal = mat3(world_to_eye) * normal;
  gl_Position = eye_to_clip * eye;
}
