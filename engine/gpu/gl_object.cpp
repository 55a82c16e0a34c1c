#include "engine/gpu/gl_object.h"

namespace odontoscope {

GlObject make_buffer(const Gl& gl) {
  GLuint id = 0;
  gl.GenBuffers(1, &id);
  return {gl, id, [](const Gl& table, GLuint dead) { table.DeleteBuffers(1, &dead); }};
}

GlObject make_vertex_array(const Gl& gl) {
  GLuint id = 0;
  gl.GenVertexArrays(1, &id);
  return {gl, id, [](const Gl& table, GLuint dead) { table.DeleteVertexArrays(1, &dead); }};
}

GlObject make_texture(const Gl& gl) {
  GLuint id = 0;
  gl.GenTextures(1, &id);
  return {gl, id, [](const Gl& table, GLuint dead) { table.DeleteTextures(1, &dead); }};
}

GlObject make_framebuffer(const Gl& gl) {
  GLuint id = 0;
  gl.GenFramebuffers(1, &id);
  return {gl, id, [](const Gl& table, GLuint dead) { table.DeleteFramebuffers(1, &dead); }};
}

}  // namespace odontoscope
