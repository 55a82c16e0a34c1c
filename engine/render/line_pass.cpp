#include "engine/render/line_pass.h"

namespace odontoscope {

namespace {

/// Pixels; opacity of what is hidden.
struct Style {
  unsigned colour;
  float width, rim;
  float hidden;
};

// Okabe and Ito's set, but for the contours' ink.
Style style_of(LineKind kind) {
  switch (kind) {
    case LineKind::contour:
      return {0x1d3a5f, 1.3f, 0.0f, 0.0f};
    case LineKind::boundary_edge:
      return {0x0072b2, 2.6f, 0.8f, 0.35f};
    case LineKind::non_manifold_edge:
      return {0xf0e442, 2.6f, 0.8f, 0.35f};
    case LineKind::misoriented_edge:
      return {0xd55e00, 2.6f, 0.8f, 0.35f};
    case LineKind::measure:
      return {0xffffff, 2.2f, 1.2f, 0.5f};
  }
  return {0x000000, 1.0f, 0.0f, 0.0f};
}

constexpr Colour rim_colour = colour_of(0x14181f);
/// How many pixels lines are lifted towards the eye: as far as a wall that is steep to the picture rises within a
/// line's width.
constexpr float lift = 6;
/// Part of the model's radius: lines in the section's plane are not cut.
constexpr float section_slack = 1e-5f;

}  // namespace

Colour colour_of(LineKind kind) { return colour_of(style_of(kind).colour); }

LinePass::LinePass(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl),
      visible_(gl, shaders, {"line.vert", "line.frag"}),
      hidden_(gl, shaders, {"line.vert", "line.frag", {}, {"HIDDEN"}}) {}

void LinePass::draw(const FramePlan& plan, const Program& program, Lines lines) const {
  const bool hidden = lines == Lines::hidden;
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_LESS);
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_CULL_FACE);
  set_view(program, plan);
  program.set("pixels", glm::vec2(plan.size.width, plan.size.height));
  program.set("lift", lift * static_cast<float>(plan.side));
  program.set("section_slack", section_slack * plan.radius);
  program.set("rim_colour", linear(rim_colour));
  for (const DrawnLines& drawn : plan.lines) {
    const Style style = style_of(drawn.lines->kind);
    if (hidden && style.hidden == 0) continue;
    const float half = 0.5f * static_cast<float>(plan.side) * style.width;
    set_section(program, plan, drawn.whole);
    program.set("half_width", half);
    program.set("rim", static_cast<float>(plan.side) * style.rim);
    program.set("colour", linear(colour_of(style.colour)));
    program.set("opacity", hidden ? style.hidden : 1.0f);
    drawn.lines->draw();
  }
}

void LinePass::draw(const FramePlan& plan) const {
  if (plan.lines.empty()) return;
  visible_.use();
  draw(plan, visible_, Lines::visible);
}

void LinePass::draw_hidden(const FramePlan& plan, const Layer& opaque, const Layer& layer) const {
  layer.begin();
  hidden_.use();
  hidden_.set("opaque_depth", 0);
  opaque.bind_depth(0);
  draw(plan, hidden_, Lines::hidden);
}

}  // namespace odontoscope
