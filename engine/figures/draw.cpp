#include "engine/figures/draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/view/offscreen.h"

namespace odontoscope::figures {
namespace {

Overlay overlay_of(const Panel& panel, const Model& model) {
  Overlay overlay;
  for (const Strokes& strokes : panel.strokes) {
    LineSet set{strokes.kind, {}, {}};
    for (const Point3& p : strokes.ends)
      set.points.emplace_back(metres_per_mm * (glm::dvec3(p.x, p.y, p.z) - model.origin_mm));
    overlay.lines.push_back(std::move(set));
  }
  return overlay;
}

}  // namespace

std::string picture_name(const Figure& figure, std::size_t panel) {
  std::string name = fmt::format("figure-{:02}", figure.number);
  if (figure.panels.size() > 1) name.push_back(static_cast<char>('a' + panel));
  name.append(".png");
  return name;
}

PixelSize panel_size(const Figure& figure, int longer_side) {
  const auto shorter = [&](double ratio) { return static_cast<int>(std::lround(longer_side * ratio)); };
  return figure.aspect >= 1 ? PixelSize{longer_side, shorter(1 / figure.aspect)}
                            : PixelSize{shorter(figure.aspect), longer_side};
}

std::vector<Image> draw(const Gl& gl, Renderer& renderer, const Figure& figure, int longer_side,
                        const RenderOptions& options) {
  std::vector<Image> images;
  for (const Panel& panel : figure.panels) {
    const Model model = make_model(panel.surfaces, panel.crease_deg);
    const GpuModel gpu_model = upload(gl, model);
    const GpuOverlay overlay = upload(gl, overlay_of(panel, model));
    images.push_back(
        picture_of(gl, renderer, gpu_model, model, panel.scene, {panel_size(figure, longer_side), options}, &overlay));
  }
  return images;
}

Image side_by_side(const std::vector<Image>& images) {
  constexpr int gap = 4;
  int width = -gap;
  for (const Image& image : images) width += image.width + gap;
  Image whole(width, images.front().height);
  std::fill(whole.rgba.begin(), whole.rgba.end(), std::uint8_t{255});
  int left = 0;
  for (const Image& image : images) {
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) whole.set_pixel(left + x, y, image.pixel(x, y));
    left += image.width + gap;
  }
  return whole;
}

}  // namespace odontoscope::figures
