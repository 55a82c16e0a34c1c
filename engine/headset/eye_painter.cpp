#include "engine/headset/eye_painter.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "engine/headset/billboards.h"
#include "engine/headset/scale_mark.h"

namespace odontoscope {

namespace {

double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// From the projection that glm::frustum made, which is in metres of the enlarged model.
DepthRange range_of(const View& view, const Stage& stage) {
  const double a = view.eye_to_clip[2][2], b = view.eye_to_clip[3][2];
  return {stage.magnification * b / (a - 1), stage.magnification * b / (a + 1)};
}

}  // namespace

EyePainter::EyePainter(const Gl& gl, const ShaderLibrary& shaders, const Model& model, const EyeQuality& quality,
                       std::shared_ptr<const ValueGrid> values)
    : gl_(&gl),
      quality_(quality),
      renderer_(gl, shaders),
      model_(upload(gl, model)),
      values_(std::move(values)),
      low_(model_.low),
      high_(model_.high),
      ease_(gl, shaders, {"fullscreen.vert", "comfort.frag"}),
      no_vertices_(make_vertex_array(gl)) {}

void EyePainter::take(const Model& model) {
  model_ = upload(*gl_, model);
  low_ = model_.low;
  high_ = model_.high;
  volume_.reset();  // places are counted from the model's origin
  gpu_values_.reset();
}

GpuVolume* EyePainter::volume_of(const Scene& scene) {
  if (!values_ || !scene.volume.shows_volume()) return nullptr;
  if (!gpu_values_) gpu_values_ = upload(*gl_, *values_, model_);
  if (!volume_) volume_.emplace(*gl_, *values_, gpu_values_->field());
  volume_->set_coarseness(static_cast<float>(pace_.coarseness()));
  return &*volume_;
}

Depths EyePainter::draw(const Visit& visit, const HeadsetInput& input, const VisitWorld& world,
                        std::span<const EyeView> eyes, std::span<const Target> targets, const Over& over,
                        std::span<const HiddenCorners* const> hidden, double beat) {
  Scene scene = scene_of(visit, world);
  if (scene.volume.projects())
    scene.volume.cast = VolumeLook::Cast::shaded;  // greys without depth would be a box in the room
  scene.background = quality_.background;
  scene.occlusion.on = quality_.occlusion;
  show_marks(visit, input, world);
  std::vector<Pane> panes;
  Depths depths;
  masks_.resize(std::max(masks_.size(), hidden.size()));
  for (std::size_t i = 0; i < targets.size(); ++i) {
    panes.push_back(
        {view_of(visit.stage, eyes[i], world.model), targets[i], i < hidden.size() ? masked(i, *hidden[i]) : nullptr});
    depths.push_back(range_of(panes.back().view, visit.stage));
  }
  const bool dark = visit.seen.dark >= 1;
  if (!dark) {
    GpuVolume* const volume = volume_of(scene);
    const double begin = clock_seconds();
    renderer_.draw(model_, scene, panes, {quality_.side, RenderOptions::Rays::few},
                   marks_.lines.empty() ? nullptr : &marks_, nullptr, volume);
    if (volume) {
      gl_->Finish();  // the time is that of the drawing, not of the asking
      pace_.took(clock_seconds() - begin, beat > 0 ? beat : quality_.beat);
    }
  }
  if (over && !dark)
    for (std::size_t i = 0; i < targets.size(); ++i) over(eyes[i], targets[i]);
  for (std::size_t i = 0; i < targets.size(); ++i) ease(visit, eyes[i].field, targets[i]);
  return dark ? Depths{} : depths;
}

const GpuHidden* EyePainter::masked(std::size_t eye, const HiddenCorners& corners) {
  if (corners.empty()) return nullptr;
  Mask& mask = masks_[eye];
  if (mask.corners != corners) mask = {corners, upload_hidden(*gl_, corners)};
  return &mask.gpu;
}

void EyePainter::show_marks(const Visit& visit, const HeadsetInput& input, const VisitWorld& world) {
  const Model& model = world.model;
  LineSet lines{LineKind::measure, {}, {}};
  const auto in_model = [&](const glm::dvec3& place) {
    return glm::vec3(metres_per_mm * (to_model(visit.stage, place) - model.origin_mm));
  };
  for (const glm::dvec3& point : room_marks(visit, input, world)) lines.points.push_back(in_model(point));
  if (visit.seen.told > 0)
    for (const glm::dvec3& point : scale_mark(visit.stage, model, input.head.position))
      lines.points.push_back(in_model(point));
  marks_ = lines.points.empty() ? GpuOverlay{} : upload(*gl_, Overlay{{lines}, {}});
  // The renderer draws no farther than the model's box.
  model_.low = low_;
  model_.high = high_;
  for (const glm::vec3& point : lines.points) {
    model_.low = glm::min(model_.low, point);
    model_.high = glm::max(model_.high, point);
  }
}

void EyePainter::ease(const Visit& visit, const FieldOfView& field, const Target& target) const {
  constexpr double unseen = 1e-3;
  if (visit.seen.dark < unseen && visit.seen.vignette < unseen) return;
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  gl_->Viewport(target.left, target.bottom, target.size.width, target.size.height);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_CULL_FACE);
  gl_->Enable(GL_BLEND);
  gl_->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  ease_.use();
  ease_.set("dark", static_cast<float>(visit.seen.dark));
  ease_.set("vignette", static_cast<float>(visit.seen.vignette));
  ease_.set("low", glm::vec2(std::tan(field.left), std::tan(field.down)));
  ease_.set("high", glm::vec2(std::tan(field.right), std::tan(field.up)));
  ease_.set("corner", glm::vec2(target.left, target.bottom));
  ease_.set("pixels", glm::vec2(target.size.width, target.size.height));
  gl_->BindVertexArray(no_vertices_.id());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  gl_->Disable(GL_BLEND);
}

void EyePainter::mirror(const Gl& gl, const Target& eye, const Target& target) {
  const double aspect = static_cast<double>(target.size.width) / target.size.height;
  const int width = std::min(eye.size.width, static_cast<int>(std::lround(aspect * eye.size.height)));
  const int height = std::min(eye.size.height, static_cast<int>(std::lround(width / aspect)));
  const int left = eye.left + (eye.size.width - width) / 2, bottom = eye.bottom + (eye.size.height - height) / 2;
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, eye.framebuffer);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
  gl.BlitFramebuffer(left, bottom, left + width, bottom + height, target.left, target.bottom,
                     target.left + target.size.width, target.bottom + target.size.height, GL_COLOR_BUFFER_BIT,
                     GL_LINEAR);
}

}  // namespace odontoscope
