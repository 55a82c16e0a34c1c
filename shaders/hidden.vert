// What the lenses hide, as triangles in tangents from the line of sight: at the near plane, so that nothing is drawn behind it, or as far as can be.
layout(location = 0) in vec2 tangent;

uniform mat4 eye_to_clip;
uniform int far_away;

void main() {
  gl_Position = eye_to_clip * vec4(tangent, -1.0, 1.0);
  gl_Position.z = far_away != 0 ? gl_Position.w : -gl_Position.w;
}
