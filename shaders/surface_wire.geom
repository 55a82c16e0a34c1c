// Gives every fragment its distance in pixels to the triangle's three edges (after Baerentzen, Nielsen, Gjoel, Larsen,
// Christensen, "Single-pass wireframe rendering", 2006).
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform vec2 pixels;

in Vertex {
  vec3 world_position;
  vec3 eye_position;
  vec3 eye_normal;
  float wall_depth;
  vec2 data;
} corner[];
out Vertex {
  vec3 world_position;
  vec3 eye_position;
  vec3 eye_normal;
  float wall_depth;
  vec2 data;
} to_next;
noperspective out vec3 edge_distance;

vec2 on_screen(int i) { return 0.5 * pixels * gl_in[i].gl_Position.xy / gl_in[i].gl_Position.w; }

void main() {
  vec2 a = on_screen(0), b = on_screen(1), c = on_screen(2);
  float doubled_area = abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  vec3 heights = doubled_area / max(vec3(distance(b, c), distance(c, a), distance(a, b)), 1e-6);
  for (int i = 0; i < 3; ++i) {
    to_next.world_position = corner[i].world_position;
    to_next.wall_depth = corner[i].wall_depth;
    to_next.data = corner[i].data;
    to_next.eye_position = corner[i].eye_position;
    to_next.eye_normal = corner[i].eye_normal;
    edge_distance = vec3(0.0);
    edge_distance[i] = heights[i];
    gl_Position = gl_in[i].gl_Position;
    gl_PrimitiveID = gl_PrimitiveIDIn;
    EmitVertex();
  }
}
