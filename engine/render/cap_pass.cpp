#include "engine/render/cap_pass.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace odontoscope {
namespace {

/// Size of a grain in radii of the model: some ten pixels in a picture that the model fills.
constexpr float grain_share = 0.018f;

}  // namespace

CapPass::CapPass(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl),
      count_(gl, shaders, {"surface.vert", "cap_count.frag"}),
      cover_(gl, shaders, {"cap.vert", "surface.frag", {}, {"GRAIN"}}),
      cover_plain_(gl, shaders, {"cap.vert", "surface.frag"}),
      cover_values_(gl, shaders, {"cap.vert", "cap_values.frag"}),
      no_vertices_(make_vertex_array(gl)) {}

void CapPass::draw(const FramePlan& plan) const {
  if (plan.capped.empty()) return;
  gl_->Enable(GL_STENCIL_TEST);
  gl_->Disable(GL_CULL_FACE);
  gl_->Disable(GL_BLEND);
  for (const CappedSolid& solid : plan.capped) {
    count(plan, solid);
    cover(plan, solid);
  }
  gl_->Disable(GL_STENCIL_TEST);
}

void CapPass::count(const FramePlan& plan, const CappedSolid& solid) const {
  gl_->Disable(GL_DEPTH_TEST);
  gl_->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl_->StencilFunc(GL_ALWAYS, 0, 0xff);
  gl_->StencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_DECR_WRAP);
  gl_->StencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_INCR_WRAP);
  count_.use();
  set_view(count_, plan);
  for (const GpuPart* surface : solid.surfaces) surface->draw();
  gl_->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void CapPass::cover(const FramePlan& plan, const CappedSolid& solid) const {
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_LEQUAL);
  gl_->StencilFunc(GL_NOTEQUAL, 0, 0xff);
  gl_->StencilOp(GL_ZERO, GL_ZERO, GL_ZERO);
  const glm::vec3 normal(plan.section);
  const glm::vec3 other = std::abs(normal.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 across = glm::normalize(glm::cross(other, normal));
  const Program& program = plan.cap_values ? cover_values_ : plan.cap_grain ? cover_ : cover_plain_;
  program.use();
  set_view(program, plan);
  program.set("centre", plan.centre + (plan.section.w - glm::dot(normal, plan.centre)) * normal);
  program.set("across", plan.radius * across);
  program.set("along", plan.radius * glm::cross(normal, across));
  program.set("normal", normal);
  if (plan.cap_values)
    set_values(plan);
  else
    set_material(program, plan, solid);
  gl_->BindVertexArray(no_vertices_.id());
  gl_->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void CapPass::set_material(const Program& program, const FramePlan& plan, const CappedSolid& solid) const {
  program.set("section", glm::vec4(0, 0, 0, 1));
  program.set("colour", solid.colour);
  program.set("back_colour", solid.colour);
  program.set("normal_sign", 1.0f);
  program.set("opacity", 1.0f);
  program.set("grain_size", grain_share * plan.radius);
}

void CapPass::set_values(const FramePlan& plan) const {
  const GpuValueGrid& grid = *plan.cap_values;
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->BindTexture(GL_TEXTURE_3D, grid.texture.id());
  cover_values_.set("values", 0);
  cover_values_.set("first", grid.first);
  cover_values_.set("spacing", grid.step);
  cover_values_.set("size", grid.size);
  cover_values_.set("low", static_cast<float>(plan.cap_window.low));
  cover_values_.set("high", static_cast<float>(plan.cap_window.high));
}

}  // namespace odontoscope
