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
    throw GraphicsError(
        "picture-too-large",
        fmt::format("{} x {} samples are more than this OpenGL draws ({} a side)", width, height, most_side), remedy);
  if (width * height > most_samples)
    throw GraphicsError(
        "picture-too-large",
        fmt::format("{} x {} samples would take too much memory (at most {} in all)", width, height, most_samples),
        remedy);
}

namespace {

/// Who asks for more samples than usual wants to see each; one alone would show what it is off by.
bool casts_every_ray(const RenderOptions& options) {
  constexpr int usual_side = 2;
  return options.rays == RenderOptions::Rays::every ||
         (options.rays == RenderOptions::Rays::as_usual && options.side != usual_side);
}

bool needs_no_layers(const FramePlan& plan) {
  const bool edges =
      plan.wire || std::any_of(plan.opaque.begin(), plan.opaque.end(), [](const DrawnPart& part) { return part.wire; });
  return plan.side == 1 && !plan.occlusion.on && plan.translucent.empty() && plan.capped.empty() && !plan.cut() &&
         plan.lines.empty() && !edges;
}

void limit_to_touched(const Gl& gl, const FramePlan& plan) {
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(plan.touched.low.x, plan.touched.low.y, plan.touched.high.x - plan.touched.low.x,
             plan.touched.high.y - plan.touched.low.y);
}

CastView cast_view(const FramePlan& plan, bool every_ray) {
  const glm::vec3 film_centre(plan.view.world_to_eye * glm::vec4(plan.centre, 1));
  return {plan.view.world_to_eye, plan.view.eye_to_clip, plan.parallel, plan.size,  plan.section, plan.lamp,
          plan.touched.low,       plan.touched.high,     every_ray,     film_centre};
}

void add_volume(const GpuVolume& volume, const VolumeLook& look, FramePlan& plan) {
  touch_box(volume.low(), volume.high(), plan);
  // A film reaches beyond what it shows, and beside it is its edge.
  if (look.cast == VolumeLook::Cast::radiograph) plan.touched = {{0, 0}, {plan.size.width, plan.size.height}};
  if (look.shows_surfaces()) return;
  plan.opaque.clear();
  plan.translucent.clear();
  plan.capped.clear();
  if (look.projects()) plan.lines.clear();
}

}  // namespace

/// Is anything to be drawn that rays of a volume may end at?
bool Renderer::has_surfaces(const Work& work) {
  const FramePlan& plan = work.plan;
  return !work.volume || work.pane->hidden || work.pane->target.keep_depth ||
         work.volume_look->cast == VolumeLook::Cast::surface || !plan.opaque.empty() || !plan.translucent.empty() ||
         !plan.capped.empty() || !plan.lines.empty();
}

Renderer::Renderer(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl),
      background_(gl, shaders),
      surfaces_(gl, shaders),
      caps_(gl, shaders),
      lines_(gl, shaders),
      occlusion_(gl, shaders),
      compose_(gl, shaders),
      resolve_(gl, shaders),
      depth_(gl, shaders),
      hidden_(gl, shaders),
      volume_(gl, shaders),
      film_(gl, shaders) {}

void Renderer::draw(const GpuModel& model, const Scene& scene, std::span<const Pane> panes,
                    const RenderOptions& options, const GpuOverlay* overlay, const GpuValueGrid* values,
                    GpuVolume* volume) {
  if (volume && !scene.volume.shows_volume()) volume = nullptr;
  if (!volume && shows_film_of_model(scene, model)) return draw_film(model, scene, panes, options);
  if (volume) volume->prepare(scene.volume);
  std::vector<Work> layered;
  std::size_t samples = 0;
  for (const Pane& pane : panes) {
    refuse_undrawable(*gl_, pane.target.size, options);
    FramePlan plan = plan_frame(model, scene, pane.view, pane.target.size, options.side, overlay, values);
    if (volume) add_volume(*volume, scene.volume, plan);
    if (!volume && needs_no_layers(plan)) {
      draw_finished(plan, scene.background, pane);
      continue;
    }
    samples += static_cast<std::size_t>(plan.size.width) * static_cast<std::size_t>(plan.size.height);
    layered.push_back({.plan = std::move(plan),
                       .pane = &pane,
                       .volume = volume,
                       .volume_look = &scene.volume,
                       .every_ray = casts_every_ray(options)});
  }
  if (samples <= most_samples) return draw_in_step(layered, scene.background);
  for (Work& work : layered) draw_in_step({&work, 1}, scene.background);
}

void Renderer::begin(Work& work) {
  const FramePlan& plan = work.plan;
  const Buffers& buffers = *work.buffers;
  constexpr GLfloat nothing[4] = {0, 0, 0, 0};
  gl_->Disable(GL_SCISSOR_TEST);
  buffers.picture.bind();
  gl_->ClearBufferfv(GL_COLOR, 0, nothing);
  if (!has_surfaces(work)) return;
  limit_to_touched(*gl_, plan);
  buffers.opaque.begin();
  if (work.pane->hidden) hidden_.cover(plan.view, *work.pane->hidden, HiddenPass::Writes::depth_and_colours);
  surfaces_.draw_opaque(plan);
  if (work.volume && work.volume_look->cast == VolumeLook::Cast::surface)
    volume_.draw_surface(cast_view(plan, true), *work.volume, *work.volume_look);
  caps_.draw(plan);
  lines_.draw(plan);
  if (!plan.lines.empty()) {
    const Layer& hints = buffers.peeled[0];
    lines_.draw_hidden(plan, buffers.opaque, hints);
    compose_.draw(plan, hints, nullptr, buffers.picture);
  }
  work.more = !plan.translucent.empty();
}

void Renderer::draw_in_step(std::span<Work> works, const Background& background) {
  for (std::size_t i = 0; i < works.size(); ++i) {
    works[i].buffers = &buffers_for(works[i].plan.size, i);
    begin(works[i]);
  }
  for (int i = 0; i < most_layers; ++i) {
    for (Work& work : works) {
      if (!work.more) continue;
      limit_to_touched(*gl_, work.plan);
      surfaces_.peel(work.plan, work.buffers->opaque, work.before, work.buffers->peeled[i % 2],
                     work.buffers->any_drawn);
    }
    bool any = false;
    for (Work& work : works) {
      if (!work.more) continue;
      work.more = any_drawn(*gl_, work.buffers->any_drawn);
      keep_depth(work, work.more ? &work.buffers->peeled[i % 2] : nullptr);
      if (!work.more) continue;
      any = true;
      const Layer* previous = work.before;
      work.before = &work.buffers->peeled[i % 2];
      limit_to_touched(*gl_, work.plan);
      cast_between(work, previous, work.before);
      add_layer(work.plan, *work.buffers, *work.before);
    }
    if (!any) break;
  }
  for (Work& work : works) {
    keep_depth(work, nullptr);
    limit_to_touched(*gl_, work.plan);
    cast_between(work, work.before, nullptr);
    if (has_surfaces(work)) add_layer(work.plan, *work.buffers, work.buffers->opaque);
    gl_->Disable(GL_SCISSOR_TEST);
    resolve_.draw(work.plan, work.buffers->picture, background, work.pane->target);
  }
}

void Renderer::cast_between(const Work& work, const Layer* before, const Layer* layer) {
  if (!work.volume) return;
  if (work.volume_look->cast == VolumeLook::Cast::shaded) {
    const CastDepths depths{before ? before->depth() : 0, layer ? layer->depth() : 0, work.buffers->opaque.depth(),
                            has_surfaces(work)};
    volume_.draw_between(cast_view(work.plan, work.every_ray), *work.volume, *work.volume_look, depths,
                         work.buffers->picture);
  }
  if (!layer && work.volume_look->projects())
    volume_.draw_projection(cast_view(work.plan, work.every_ray), *work.volume, *work.volume_look,
                            work.buffers->picture);
}

void Renderer::keep_depth(Work& work, const Layer* first) const {
  if (work.pane->target.keep_depth && !work.depth_kept)
    depth_.draw(work.plan, work.buffers->opaque, first, work.pane->target);
  work.depth_kept = true;
}

void Renderer::draw_film(const GpuModel& model, const Scene& scene, std::span<const Pane> panes,
                         const RenderOptions& options) {
  for (const Pane& pane : panes) {
    refuse_undrawable(*gl_, pane.target.size, options);
    const FramePlan plan = plan_frame(model, scene, pane.view, pane.target.size, options.side);
    const Buffers& buffers = buffers_for(plan.size, 0);
    film_.draw(plan, model, scene, buffers.picture);
    resolve_.draw(plan, buffers.picture, scene.background, pane.target);
  }
}

void Renderer::draw_finished(const FramePlan& plan, const Background& background, const Pane& pane) {
  const Target& target = pane.target;
  if (target.with_depth) {
    background_.fill(background, target);
    if (pane.hidden) hidden_.cover(plan.view, *pane.hidden, HiddenPass::Writes::depth);
    surfaces_.draw_finished(plan);
    if (pane.hidden && target.keep_depth) hidden_.uncover(plan.view, *pane.hidden);
    return;
  }
  if (finished_.size() != plan.size) finished_ = Framebuffer(*gl_, {plan.size, {GL_RGBA8}, GL_DEPTH_COMPONENT32F});
  background_.fill(background, {finished_.id(), 0, 0, plan.size});
  if (pane.hidden) hidden_.cover(plan.view, *pane.hidden, HiddenPass::Writes::depth);
  surfaces_.draw_finished(plan);
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, finished_.id());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
  gl_->BlitFramebuffer(0, 0, plan.size.width, plan.size.height, target.left, target.bottom,
                       target.left + plan.size.width, target.bottom + plan.size.height, GL_COLOR_BUFFER_BIT,
                       GL_NEAREST);
}

void Renderer::add_layer(const FramePlan& plan, const Buffers& buffers, const Layer& layer) const {
  if (plan.occlusion.on) occlusion_.draw(plan, layer, buffers.occlusion);
  compose_.draw(plan, layer, plan.occlusion.on ? &buffers.occlusion : nullptr, buffers.picture);
}

const Renderer::Buffers& Renderer::buffers_for(PixelSize size, std::size_t number) {
  if (buffers_.size() <= number) buffers_.resize(number + 1);
  std::unique_ptr<Buffers>& buffers = buffers_[number];
  if (buffers && buffers->size == size) return *buffers;
  buffers.reset();
  buffers = std::make_unique<Buffers>(Buffers{Layer(*gl_, size),
                                              {Layer(*gl_, size), Layer(*gl_, size)},
                                              Framebuffer(*gl_, {size, {GL_RG32F}}),
                                              Framebuffer(*gl_, {size, {GL_RGBA16F}, GL_DEPTH_COMPONENT32F}),
                                              size,
                                              make_query(*gl_)});
  return *buffers;
}

}  // namespace odontoscope
