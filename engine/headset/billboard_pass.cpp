#include "engine/headset/billboard_pass.h"

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace odontoscope {

namespace {

/// From metres round the eye's own place: small numbers, so that float is exact enough.
glm::mat4 to_clip(const EyeView& eye) {
  constexpr double nearest = 0.02, farthest = 100;
  const FieldOfView& field = eye.field;
  const glm::dmat4 lens = glm::frustum(nearest * std::tan(field.left), nearest * std::tan(field.right),
                                       nearest * std::tan(field.down), nearest * std::tan(field.up), nearest, farthest);
  return glm::mat4(lens * glm::dmat4(glm::mat3_cast(glm::conjugate(eye.pose.turn))));
}

}  // namespace

BillboardPass::BillboardPass(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl), program_(gl, shaders, {"billboard.vert", "billboard.frag"}), no_vertices_(make_vertex_array(gl)) {}

void BillboardPass::draw(const Framebuffer& sheet, std::span<const SheetPiece> pieces, std::span<const Beam> beams,
                         const EyeView& eye, const Target& target, double light) const {
  if (pieces.empty() && beams.empty()) return;
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  gl_->Viewport(target.left, target.bottom, target.size.width, target.size.height);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_CULL_FACE);
  gl_->Enable(GL_BLEND);
  gl_->BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  program_.use();
  program_.set("to_clip", to_clip(eye));
  program_.set("sheet", 0);
  program_.set("light", static_cast<float>(light));
  gl_->BindVertexArray(no_vertices_.id());
  const auto rectangle = [&](const glm::dvec3& corner, const glm::dvec3& across, const glm::dvec3& down) {
    program_.set("corner", glm::vec3(corner - eye.pose.position));
    program_.set("across", glm::vec3(across));
    program_.set("down", glm::vec3(down));
    gl_->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  };
  sheet.bind_colour(0, 0);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  program_.set("sheet_counts", 1.0f);
  for (const SheetPiece& piece : pieces) {
    const glm::dvec3 across = piece.pose.turn * glm::dvec3(piece.size.x, 0, 0),
                     down = piece.pose.turn * glm::dvec3(0, -piece.size.y, 0);
    const auto on_sheet = [&](double x, double y) {
      return glm::vec2(x / sheet.size().width, 1 - y / sheet.size().height);
    };
    program_.set("sheet_from", on_sheet(piece.left, piece.top));
    program_.set("sheet_to", on_sheet(piece.left + piece.width, piece.top + piece.height));
    rectangle(piece.pose.position - 0.5 * (across + down), across, down);
  }
  program_.set("sheet_counts", 0.0f);
  for (const Beam& beam : beams) {
    const glm::dvec3 along = beam.to - beam.from, side = glm::cross(along, eye.pose.position - beam.from);
    if (!(glm::length(side) > 0)) continue;  // seen from its end
    const glm::dvec3 across = beam.width * glm::normalize(side);
    program_.set("plain", glm::vec4(glm::vec3(beam.colour) * beam.colour.a, beam.colour.a));
    rectangle(beam.from - 0.5 * across, across, along);
  }
  gl_->Disable(GL_BLEND);
  gl_->BindVertexArray(0);
}

}  // namespace odontoscope
