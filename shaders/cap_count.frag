// Only the stencil counts here; what is cut away must not be counted.
in Vertex {
  vec3 world_position;
  vec3 eye_position;
  vec3 eye_normal;
  float wall_depth;
  vec2 data;
} from;

uniform vec4 section;

void main() {
  if (dot(section.xyz, from.world_position) > section.w) discard;
}
