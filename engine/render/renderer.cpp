#include "engine/render/renderer.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/gpu/graphics_error.h"

namespace odontoscope {

void refuse_undrawable(const Gl& gl, PixelSize size, const RenderOptions& options) {
  GLint most_side = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &most_side);
  const auto width = static_cast<std::size_t>(options.side) * static_cast<std::size_t>(size.width);
  const auto height = static_cast<std::size_t>(options.side) * static_cast<std::size_t>(size.height);
  constexpr const char* remedy = "Ask for a smaller picture or fewer samples.";
  if (std::max(width, height) > static_cast<std::size_t>(most_side))
    throw GraphicsError("picture-too-large", fmt::format("{} x {} samples are more than this OpenGL draws ({} a side)", width, height, most_side), remedy);
  if (width * height > most_samples)
    throw GraphicsError("picture-too-large", fmt::format("{} x {} samples would take too much memory (at most {} in all)", width, height, most_samples), remedy);
}

namespace {

bool needs_no_layers(const FramePlan& plan) {
  const bool edges = plan.wire || std::any_of(plan.opaque.begin(), plan.opaque.end(), [](const DrawnPart& part) { return part.wire; });
  return plan.side == 1 && !plan.occlusion.on && plan.translucent.empty() && plan.capped.empty() && !plan.cut() && plan.lines.empty() && !edges;
}

}  // namespace

Renderer::Renderer(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl), background_(gl, shaders), surfaces_(gl, shaders), caps_(gl, shaders), lines_(gl, shaders), occlusion_(gl, shaders), compose_(gl, shaders), resolve_(gl, shaders) {}

void Renderer::draw(const GpuModel& model, const Scene& scene, std::span<const Pane> panes, const RenderOptions& options,
                    const GpuOverlay* overlay, const GpuValueGrid* values) {
  for (const Pane& pane : panes) {
    refuse_undrawable(*gl_, pane.target.size, options);
    draw(plan_frame(model, scene, pane.view, pane.target.size, options.side, overlay, values), scene.background, pane.target);
  }
}

void Renderer::draw(const FramePlan& plan, const Background& background, const Target& target) {
  if (needs_no_layers(plan)) return draw_finished(plan, background, target);
  const Buffers& buffers = buffers_for(plan.size);
  constexpr GLfloat nothing[4] = {0, 0, 0, 0};
  buffers.picture.bind();
  gl_->ClearBufferfv(GL_COLOR, 0, nothing);
  gl_->Enable(GL_SCISSOR_TEST);
  gl_->Scissor(plan.touched.low.x, plan.touched.low.y, plan.touched.high.x - plan.touched.low.x, plan.touched.high.y - plan.touched.low.y);
  buffers.opaque.begin();
  surfaces_.draw_opaque(plan);
  caps_.draw(plan);
  lines_.draw(plan);

  if (!plan.lines.empty()) {
    const Layer& hints = buffers.peeled[0];
    lines_.draw_hidden(plan, buffers.opaque, hints);
    compose_.draw(plan, hints, nullptr, buffers.picture);
  }
  const Layer* before = nullptr;
  for (int i = 0; i < most_layers && !plan.translucent.empty(); ++i) {
    const Layer& layer = buffers.peeled[i % 2];
    if (!surfaces_.peel(plan, buffers.opaque, before, layer)) break;
    add_layer(plan, buffers, layer);
    before = &layer;
  }
  add_layer(plan, buffers, buffers.opaque);
  gl_->Disable(GL_SCISSOR_TEST);
  resolve_.draw(plan, buffers.picture, background, target);
}

void Renderer::draw_finished(const FramePlan& plan, const Background& background, const Target& target) {
  if (target.with_depth) {
    background_.fill(background, target);
    surfaces_.draw_finished(plan);
    return;
  }
  if (finished_.size() != plan.size) finished_ = Framebuffer(*gl_, {plan.size, {GL_RGBA8}, GL_DEPTH_COMPONENT32F});
  background_.fill(background, {finished_.id(), 0, 0, plan.size});
  surfaces_.draw_finished(plan);
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, finished_.id());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
  gl_->BlitFramebuffer(0, 0, plan.size.width, plan.size.height, target.left, target.bottom, target.left + plan.size.width,
                       target.bottom + plan.size.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Renderer::add_layer(const FramePlan& plan, const Buffers& buffers, const Layer& layer) const {
  if (plan.occlusion.on) occlusion_.draw(plan, layer, buffers.occlusion);
  compose_.draw(plan, layer, plan.occlusion.on ? &buffers.occlusion : nullptr, buffers.picture);
}

const Renderer::Buffers& Renderer::buffers_for(PixelSize size) {
  if (buffers_ && buffers_->size == size) return *buffers_;
  buffers_.reset();
  buffers_ = std::make_unique<Buffers>(Buffers{Layer(*gl_, size),
                                               {Layer(*gl_, size), Layer(*gl_, size)},
                                               Framebuffer(*gl_, {size, {GL_RG32F}}),
                                               Framebuffer(*gl_, {size, {GL_RGBA16F}}),
                                               size});
  return *buffers_;
}

}  // namespace odontoscope
