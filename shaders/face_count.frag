// One fragment's vote: red for a front face, green for a back face. DEPTH: its depth instead of 1, for a minimum.
in Vertex {
  vec3 world_position;
  vec3 eye_position;
  vec3 eye_normal;
  float wall_depth;
  vec2 data;
} from;

uniform vec4 section;

layout(location = 0) out vec2 out_vote;

void main() {
  if (dot(section.xyz, from.world_position) > section.w) discard;
#ifdef DEPTH
  out_vote = gl_FrontFacing ? vec2(gl_FragCoord.z, 1.0) : vec2(1.0, gl_FragCoord.z);
#else
  out_vote = gl_FrontFacing ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
#endif
}
