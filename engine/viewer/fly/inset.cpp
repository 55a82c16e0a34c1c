#include "engine/viewer/fly/inset.h"

#include <cmath>

#include "engine/navigate/screen.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

namespace {

constexpr double inset_width = 190, inset_height = 230, inset_margin = 20, inset_above = 62,
                 compass_below = 180;  // interface pixels
constexpr int inset_side = 2;          // samples a pixel along one axis: drawn once, so fine

}  // namespace

Area inset_area(const ViewPane& pane, float scale) {
  const double width = inset_width * scale, height = inset_height * scale;
  if (pane.area.width < 2.6 * width || pane.area.height < height + (inset_above + compass_below) * scale) return {};
  return {std::round(pane.area.left + pane.area.width - width - inset_margin * scale),
          std::round(pane.area.top + pane.area.height - height - inset_above * scale), std::round(width),
          std::round(height)};
}

/// A little smaller and lower than it would fit: words stand above.
Camera inset_camera(const Model& model, NamedView from, const Area& area) {
  Camera camera = fit(from, model, area.aspect(), Camera::Projection::parallel);
  constexpr double smaller = 1.16, lower = 0.07;
  camera.height_mm *= smaller;
  const glm::dvec3 shift = lower * camera.height_mm * axes_of(camera).up;
  camera.position += shift;
  camera.target += shift;
  return camera;
}

void Inset::draw(Workspace& at, NamedView from, const Target& target) {
  const Area area = inset_area(at.front(), at.layout.scale);
  const PixelSize size{static_cast<int>(area.width), static_cast<int>(area.height)};
  if (size.width < 1 || size.height < 1) return;
  if (!(picture_.size() == size) || of_ != at.state.shown || from_ != from) {
    picture_ = Framebuffer(at.gl, {size, {GL_RGBA8}});
    of_ = at.state.shown;
    from_ = from;
    Scene scene = usual_scene(of_->model, area.aspect());
    scene.camera = inset_camera(of_->model, from, area);
    scene.background = {Background::Kind::plain, colour_of(0x14181c), colour_of(0x14181c)};
    scene.occlusion.on = false;
    at.picture.draw_inset(scene, {view_of(scene.camera, of_->model, area.aspect()), {picture_.id(), 0, 0, size}},
                          inset_side);
  }
  const int left = target.left + static_cast<int>(area.left),
            bottom = target.bottom + target.size.height - static_cast<int>(area.top) - size.height;
  at.gl.BindFramebuffer(GL_READ_FRAMEBUFFER, picture_.id());
  at.gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
  at.gl.BlitFramebuffer(0, 0, size.width, size.height, left, bottom, left + size.width, bottom + size.height,
                        GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace odontoscope
