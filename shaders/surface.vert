// A structure's surface. `invariant`: passes that draw it again must meet the very same depths.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float wall_depth;   // in steps, see wall_depth.glsl
layout(location = 3) in vec2 data;          // distance from the data's own surface and their slope, see data_colour.glsl
layout(location = 4) in float wall_thickness;   // in steps below the thickest, drawn as depths are

uniform int show_depth;          // 1: the wall tells its depth; 2: its thickness
uniform mat4 world_to_eye;
uniform mat4 eye_to_clip;

invariant gl_Position;
out Vertex {
  vec3 world_position;
  vec3 eye_position;
  vec3 eye_normal;
  float wall_depth;
  vec2 data;
} to_next;

void main() {
  vec4 eye = world_to_eye * vec4(position, 1.0);
  to_next.world_position = position;
  to_next.wall_depth = show_depth == 2 ? wall_thickness : wall_depth;
  to_next.data = data;
  to_next.eye_position = eye.xyz;
  to_next.eye_normal = mat3(world_to_eye) * normal;
  gl_Position = eye_to_clip * eye;
}
