#include "engine/render/gpu_overlay.h"

namespace odontoscope {

namespace {

GpuLines upload(const Gl& gl, const LineSet& set) {
  GpuLines lines{set.kind, set.structure, make_vertex_array(gl), make_buffer(gl),
                 static_cast<GLsizei>(set.points.size() / 2)};
  gl.BindVertexArray(lines.vertex_array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, lines.ends.id());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(set.points.size() * sizeof(glm::vec3)), set.points.data(),
                GL_STATIC_DRAW);
  for (GLuint end = 0; end < 2; ++end) {
    gl.VertexAttribPointer(end, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(glm::vec3),
                           reinterpret_cast<const void*>(end * sizeof(glm::vec3)));
    gl.VertexAttribDivisor(end, 1);
    gl.EnableVertexAttribArray(end);
  }
  gl.BindVertexArray(0);
  return lines;
}

}  // namespace

void GpuLines::draw() const {
  const Gl& gl = vertex_array.gl();
  gl.BindVertexArray(vertex_array.id());
  gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

GpuOverlay upload(const Gl& gl, const Overlay& overlay) {
  GpuOverlay uploaded;
  for (const LineSet& set : overlay.lines)
    if (set.points.size() >= 2) uploaded.lines.push_back(upload(gl, set));
  for (const SlabPart& part : overlay.slab) uploaded.slab.push_back(upload(gl, part.surface));
  return uploaded;
}

}  // namespace odontoscope
