#include "engine/viewer/model_picture.h"

#include <chrono>
#include <utility>

#include "engine/gpu/graphics_error.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

namespace {

/// A fine picture that takes longer than the first is drawn only once nothing moves, for so long; one that takes longer
/// than the last not at all, since nothing would answer meanwhile.
constexpr double slow_picture_seconds = 0.030, still_seconds = 0.15, too_slow_seconds = 0.8;
/// Samples beyond which a picture on the screen is not refined, for the memory that it takes.
constexpr double most_screen_samples = 10e6;
/// Steps through a volume while the picture moves on a slow machine, over usual ones.
constexpr float moving_coarseness = 2;

double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ModelPicture::ModelPicture(const Gl& gl, const ShaderLibrary& shaders) : gl_(gl), renderer_(gl, shaders) {}

void ModelPicture::take(const Model& model) {
  model_ = upload(gl_, model);
  overlay_ = {};
  overlays_made_ = {};
  volume_.reset();
  values_.reset();
}

void ModelPicture::make_overlays(const ViewerState& state) {
  if (state.scene.overlays == overlays_made_) return;
  overlay_ = upload(gl_, make_overlay(state.shown->overlays, state.scene.overlays, state.shown->model));
  overlays_made_ = state.scene.overlays;
}

bool ModelPicture::upload_values(ViewerState& state) {
  if (values_) return true;
  try {
    values_ = upload(gl_, *state.shown->values, model_);
    return true;
  } catch (const GraphicsError& error) {
    state.scene.cap.shows = CapLook::Shows::material;
    state.scene.volume.shows = VolumeLook::Shows::surfaces;
    state.trouble = error.what();
    return false;
  }
}

const GpuValueGrid* ModelPicture::cap_values(ViewerState& state) {
  const bool shown = state.scene.cap.shows == CapLook::Shows::ct && state.scene.section && state.shown->values;
  return shown && upload_values(state) ? &*values_ : nullptr;
}

GpuVolume* ModelPicture::volume(ViewerState& state) {
  if (!state.scene.volume.shows_volume() || !state.shown->values || !upload_values(state)) return nullptr;
  if (!volume_) volume_.emplace(gl_, *state.shown->values, values_->field());
  return &*volume_;
}

int ModelPicture::side_for(const Workspace& at, PixelSize size, bool changed) {
  const ViewerOptions& options = at.options;
  const bool too_large =
      static_cast<double>(size.width) * size.height * options.side * options.side > most_screen_samples;
  const bool too_slow = options.coarse_when_slow && pace_.fine_picture_seconds > too_slow_seconds;
  const bool wait = options.coarse_when_slow && pace_.fine_picture_seconds > slow_picture_seconds &&
                    at.now - pace_.still_since < still_seconds;
  if (!too_large && !too_slow && !wait) return options.side;
  return changed ? 1 : drawn_.side;
}

void ModelPicture::draw(Workspace& at, PixelSize size, const Target& target) {
  if (!(picture_.size() == size)) {
    picture_ = Framebuffer(gl_, {size, {GL_RGBA8}});
    drawn_ = {};
  }
  const OtherModel* other = at.modes.other_model();
  Drawn wanted{at.state.shown, at.state.scene, at.layout.panes, other ? other->version : 0, size, drawn_.side};
  const bool changed = wanted != drawn_;
  if (changed) pace_.still_since = at.now;
  wanted.side = side_for(at, size, changed);
  if (wanted != drawn_) {
    if (!at.state.shown) {
      const GLfloat ground[4] = {0.085f, 0.1f, 0.118f, 1};
      picture_.bind();
      gl_.ClearBufferfv(GL_COLOR, 0, ground);
    } else {
      const double start = clock_seconds();
      make_overlays(at.state);
      for (const ViewPane& pane : at.layout.panes) draw_pane(at, pane, size, wanted.side);
      gl_.Finish();
      const double finer = static_cast<double>(at.options.side) / wanted.side;
      pace_.fine_picture_seconds = 0.5 * pace_.fine_picture_seconds + 0.5 * finer * finer * (clock_seconds() - start);
    }
    drawn_ = std::move(wanted);
  }
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, picture_.id());
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
  gl_.BlitFramebuffer(0, 0, size.width, size.height, target.left, target.bottom, target.left + size.width,
                      target.bottom + size.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

/// Into the kept picture. A pane of which only a part is seen is drawn whole and cut out, so that a pixel is the same
/// on either side of the line.
void ModelPicture::draw_pane(Workspace& at, const ViewPane& pane, PixelSize size, int side) {
  const auto left = static_cast<int>(pane.area.left), top = static_cast<int>(pane.area.top);
  const PixelSize pane_size{static_cast<int>(pane.area.width), static_cast<int>(pane.area.height)};
  if (pane_size.width < 1 || pane_size.height < 1) return;
  const int bottom = size.height - top - pane_size.height;
  const bool partly = pane.seen.has_value();
  if (partly && !(other_half_.size() == size)) other_half_ = Framebuffer(gl_, {size, {GL_RGBA8}});
  const Framebuffer& target = partly ? other_half_ : picture_;
  const Pane eye{view_of(pane.camera, at.model_of(pane), pane.area.aspect()), {target.id(), left, bottom, pane_size}};
  const bool moving = side < at.options.side;
  Scene scene = at.state.scene;
  if (moving && !at.modes.effects().shadows_while_moving) scene.occlusion.on = false;
  GpuVolume* const grey = pane.db ? nullptr : volume(at.state);
  if (grey) grey->set_coarseness(moving ? moving_coarseness : 1);
  const RenderOptions options{.side = side, .rays = moving ? RenderOptions::Rays::few : RenderOptions::Rays::as_usual};
  const OtherModel* other = pane.db ? at.modes.other_model() : nullptr;
  const GpuOverlay* others_edges = scene.overlays.edges && other ? other->overlay : nullptr;
  renderer_.draw(other ? *other->gpu : model_, scene, {&eye, 1}, options, other ? others_edges : &overlay_,
                 cap_values(at.state), grey);
  if (!partly) return;
  const int from = static_cast<int>(pane.seen->left), to = from + static_cast<int>(pane.seen->width);
  if (to <= from) return;
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, other_half_.id());
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, picture_.id());
  gl_.BlitFramebuffer(from, bottom, to, bottom + pane_size.height, from, bottom, to, bottom + pane_size.height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

bool ModelPicture::refining(const Workspace& at) const {
  return at.state.shown && drawn_.side < at.options.side && at.now - pace_.still_since < 1;
}

Image ModelPicture::image(ViewerState& state, const Scene& scene, const PictureOptions& options) {
  refuse_undrawable(gl_, options.size, options.render);
  return picture_of(gl_, renderer_, model_, state.shown->model, scene, options, &overlay_, cap_values(state),
                    volume(state));
}

}  // namespace odontoscope
