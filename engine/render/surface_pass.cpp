#include "engine/render/surface_pass.h"

#include <algorithm>

namespace odontoscope {

namespace {

// Magenta occurs in no tissue, and every kind of colour vision sees it against ivory.
constexpr Colour alarm = colour_of(0xff00bf);
constexpr float alarm_opacity = 0.9f;
constexpr float wire_pixels = 1.1f;

void set_data_colours(const Program& program, const DataColours& colours) {
  const auto [low, middle, high] = stops_of(colours.of);
  program.set("data_low", linear(low));
  program.set("data_middle", linear(middle));
  program.set("data_high", linear(high));
  program.set("data_nowhere", linear(nowhere_near));
  program.set("data_reach", static_cast<float>(colours.reach));
}

/// As surface.frag's show_depth: 1 depth, 2 thickness, 0 neither.
int told_on_wall(const FramePlan& plan, const GpuPart& part) {
  if (plan.wall_thickness) return part.thicknesses ? 2 : 0;
  return plan.wall_depth && part.depths ? 1 : 0;
}

}  // namespace

GlObject make_query(const Gl& gl) {
  GLuint id = 0;
  gl.GenQueries(1, &id);
  return {gl, id, [](const Gl& table, GLuint dead) { table.DeleteQueries(1, &dead); }};
}

bool any_drawn(const Gl& gl, const GlObject& query) {
  GLuint any = 0;
  gl.GetQueryObjectuiv(query.id(), GL_QUERY_RESULT, &any);
  return any != 0;
}

void set_culling(const Gl& gl, BackFaces back_faces) {
  gl.FrontFace(GL_CCW);
  gl.CullFace(GL_BACK);
  if (back_faces == BackFaces::cull)
    gl.Enable(GL_CULL_FACE);
  else
    gl.Disable(GL_CULL_FACE);
}

SurfacePass::SurfacePass(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl),
      finished_(gl, shaders, {"surface.vert", "surface.frag", {}, {"DIRECT"}}),
      opaque_(gl, shaders, {"surface.vert", "surface.frag"}),
      opaque_wire_(gl, shaders, {"surface.vert", "surface.frag", "surface_wire.geom", {"WIRE"}}),
      peel_(gl, shaders, {"surface.vert", "surface.frag", {}, {"PEEL"}}),
      peel_wire_(gl, shaders, {"surface.vert", "surface.frag", "surface_wire.geom", {"PEEL", "WIRE"}}) {}

void SurfacePass::draw(const FramePlan& plan, const std::vector<DrawnPart>& parts, const Program& program,
                       Edges edges) const {
  const auto belongs = [&](const DrawnPart& part) { return (plan.wire || part.wire) == (edges == Edges::drawn); };
  if (std::none_of(parts.begin(), parts.end(), belongs)) return;
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_LESS);
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_STENCIL_TEST);
  set_culling(*gl_, plan.back_faces);
  set_view(program, plan);
  program.set("pixels", glm::vec2(plan.size.width, plan.size.height));
  program.set("wire_width", wire_pixels * static_cast<float>(plan.side));
  const bool tint = plan.back_faces == BackFaces::tint;
  program.set("least_back_opacity", tint ? alarm_opacity : 0.0f);
  if (plan.data_colours) set_data_colours(program, *plan.data_colours);
  const int data = !plan.data_colours ? 0 : plan.data_colours->of == DataColours::Of::distance ? 1 : 2;
  for (const DrawnPart& part : parts) {
    if (!belongs(part)) continue;
    program.set("show_data", part.part->deviations ? data : 0);
    set_section(program, plan, part.whole);
    program.set("colour", part.colour);
    program.set("back_colour", tint ? linear(alarm) : part.colour);
    program.set("opacity", part.opacity);
    program.set("normal_sign", part.inside_out ? -1.0f : 1.0f);
    program.set("show_depth", told_on_wall(plan, *part.part));
    gl_->FrontFace(part.inside_out ? GL_CW : GL_CCW);
    part.part->draw();
  }
  gl_->FrontFace(GL_CCW);
}

void SurfacePass::draw_opaque(const FramePlan& plan) const {
  opaque_.use();
  draw(plan, plan.opaque, opaque_, Edges::none);
  opaque_wire_.use();
  draw(plan, plan.opaque, opaque_wire_, Edges::drawn);
}

void SurfacePass::draw_finished(const FramePlan& plan) const {
  finished_.use();
  draw(plan, plan.opaque, finished_, Edges::none);
}

void SurfacePass::peel(const FramePlan& plan, const Layer& opaque, const Layer* before, const Layer& layer,
                       const GlObject& any_drawn) const {
  layer.begin();
  const Program& program = plan.wire ? peel_wire_ : peel_;
  program.use();
  program.set("first_layer", before ? 0 : 1);
  program.set("opaque_depth", 0);
  program.set("layer_before", 1);
  opaque.bind_depth(0);
  (before ? *before : opaque).bind_depth(1);
  gl_->BeginQuery(GL_ANY_SAMPLES_PASSED, any_drawn.id());
  draw(plan, plan.translucent, program, plan.wire ? Edges::drawn : Edges::none);
  gl_->EndQuery(GL_ANY_SAMPLES_PASSED);
}

}  // namespace odontoscope
