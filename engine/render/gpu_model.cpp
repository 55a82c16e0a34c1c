#include "engine/render/gpu_model.h"

#include <glm/common.hpp>

namespace odontoscope {

namespace {

template <class Element>
void fill(const Gl& gl, GLenum target, const GlObject& buffer, const std::vector<Element>& data) {
  gl.BindBuffer(target, buffer.id());
  gl.BufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(Element)), data.data(), GL_STATIC_DRAW);
}

double box_volume(const std::vector<glm::vec3>& positions) {
  glm::dvec3 low(positions.front()), high(positions.front());
  for (const glm::vec3& position : positions) {
    low = glm::min(low, glm::dvec3(position));
    high = glm::max(high, glm::dvec3(position));
  }
  const glm::dvec3 size = high - low;
  return size.x * size.y * size.z;
}

}  // namespace

void GpuPart::draw() const {
  const Gl& gl = vertex_array.gl();
  gl.BindVertexArray(vertex_array.id());
  gl.DrawElements(GL_TRIANGLES, index_count, GL_UNSIGNED_INT, nullptr);
}

GpuPart upload(const Gl& gl, const ModelPart& part, double depth_step_mm) {
  GpuPart uploaded{part.structure,
                   part.solid,
                   make_vertex_array(gl),
                   make_buffer(gl),
                   make_buffer(gl),
                   make_buffer(gl),
                   static_cast<GLsizei>(part.indices.size()),
                   box_volume(part.positions),
                   static_cast<float>(part.attenuation)};
  gl.BindVertexArray(uploaded.vertex_array.id());
  fill(gl, GL_ARRAY_BUFFER, uploaded.positions, part.positions);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
  gl.EnableVertexAttribArray(0);
  fill(gl, GL_ARRAY_BUFFER, uploaded.normals, part.normals);
  gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
  gl.EnableVertexAttribArray(1);
  if (part.depths_mm.size() == part.positions.size()) {
    uploaded.depths = make_buffer(gl);
    std::vector<float> steps = part.depths_mm;
    for (float& depth : steps) depth /= static_cast<float>(depth_step_mm);
    fill(gl, GL_ARRAY_BUFFER, *uploaded.depths, steps);
    gl.VertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, sizeof(float), nullptr);
    gl.EnableVertexAttribArray(2);
  }
  if (part.thicknesses_mm.size() == part.positions.size()) {
    uploaded.thicknesses = make_buffer(gl);
    std::vector<float> steps = part.thicknesses_mm;
    const double line = thickness_line * depth_step_mm;
    for (float& step : steps) step = static_cast<float>(thickest_steps - static_cast<double>(step) / line);
    fill(gl, GL_ARRAY_BUFFER, *uploaded.thicknesses, steps);
    gl.VertexAttribPointer(4, 1, GL_FLOAT, GL_FALSE, sizeof(float), nullptr);
    gl.EnableVertexAttribArray(4);
  }
  if (part.deviations.size() == part.positions.size()) {
    uploaded.deviations = make_buffer(gl);
    fill(gl, GL_ARRAY_BUFFER, *uploaded.deviations, part.deviations);
    gl.VertexAttribPointer(3, 2, GL_FLOAT, GL_FALSE, sizeof(glm::vec2), nullptr);
    gl.EnableVertexAttribArray(3);
  }
  fill(gl, GL_ELEMENT_ARRAY_BUFFER, uploaded.indices, part.indices);
  gl.BindVertexArray(0);
  return uploaded;
}

GpuModel upload(const Gl& gl, const Model& model) {
  GpuModel uploaded;
  uploaded.origin_mm = model.origin_mm;
  uploaded.low = glm::vec3(metres_per_mm * (model.bounds_mm.low - model.origin_mm));
  uploaded.high = glm::vec3(metres_per_mm * (model.bounds_mm.high - model.origin_mm));
  uploaded.centre = glm::vec3(metres_per_mm * (model.bounds_mm.centre() - model.origin_mm));
  uploaded.radius = static_cast<float>(metres_per_mm * model.radius_mm);
  for (const ModelPart& part : model.parts)
    if (!part.indices.empty()) uploaded.parts.push_back(upload(gl, part, model.depth_step_mm));
  return uploaded;
}

}  // namespace odontoscope
