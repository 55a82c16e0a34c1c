#include "engine/render/see_through.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <vector>

#include "engine/render/face_count.h"
#include "engine/scene/scene.h"

namespace odontoscope {
namespace {

/// Directions on a spiral that is as dense everywhere (Swinbank and Purser's Fibonacci grid, 2006).
glm::dvec3 direction(std::size_t i, std::size_t count) {
  const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
  const double angle = 2 * std::numbers::pi * static_cast<double>(i) / std::numbers::phi, radius = std::sqrt(1 - z * z);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

Camera camera_from(const glm::dvec3& towards_eye, const Model& model) {
  constexpr double steep = 0.9;
  Camera camera;
  camera.position = towards_eye;
  camera.target = glm::dvec3(0);
  camera.up = std::abs(towards_eye.z) > steep ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  return fit(camera, model, 1);
}

bool is_covered(const FaceCounts& counts, std::size_t at) { return counts.front[at] != 0 || counts.back[at] != 0; }

/// Covered pixels with none uncovered up to `reach` pixels along a row, then along a column.
std::vector<bool> well_inside(const FaceCounts& counts, int reach) {
  const int width = counts.size.width, height = counts.size.height;
  std::vector<bool> inside(counts.front.size());
  for (std::size_t at = 0; at < inside.size(); ++at) inside[at] = is_covered(counts, at);
  const auto shrink = [&](int lines, int length, auto place) {
    std::vector<bool> result(inside.size(), false);
    for (int line = 0; line < lines; ++line) {
      int run = 0;  // covered pixels up to here
      for (int i = 0; i < length; ++i) {
        run = inside[place(line, i)] ? run + 1 : 0;
        if (run > 2 * reach) result[place(line, i - reach)] = true;
      }
    }
    inside = std::move(result);
  };
  const auto at = [width](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  shrink(height, width, [&](int y, int x) { return at(x, y); });
  shrink(width, height, [&](int x, int y) { return at(x, y); });
  return inside;
}

}  // namespace

namespace {

void judge(const FaceCounts& faces, const std::vector<bool>& inside, SeeThrough& result) {
  ++result.cameras;
  for (int y = 0; y < faces.size.height; ++y)
    for (int x = 0; x < faces.size.width; ++x) {
      const std::size_t at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(faces.size.width) + static_cast<std::size_t>(x);
      if (!inside[at]) continue;
      ++result.inside;
      result.culled += faces.front[at] == 0 || back_is_nearest(faces, x, y);
      result.two_sided += !is_covered(faces, at);
    }
}

}  // namespace

std::vector<SeeThrough> see_through(const Gl& gl, const ShaderLibrary& shaders, const Model& closed,
                                    std::span<const Model> judged, const SeeThroughOptions& options) {
  const FaceCounter counter(gl, shaders);
  const GpuModel gpu_closed = upload(gl, closed);
  std::vector<GpuModel> gpu_judged;
  for (const Model& model : judged) gpu_judged.push_back(upload(gl, model));
  const Scene scene;  // no looks: everything shown, opaque
  const PixelSize size{options.side, options.side};
  std::vector<SeeThrough> results(judged.size());
  for (std::size_t i = 0; i < options.cameras; ++i) {
    const Camera camera = camera_from(direction(i, options.cameras), closed);
    const double seen_mm =
        2 * glm::distance(camera.position, camera.target) * std::tan(glm::radians(camera.field_of_view_deg) / 2);
    const int reach = 1 + static_cast<int>(std::ceil(options.rim_mm * options.side / seen_mm));
    const std::vector<bool> inside =
        well_inside(counter.count(gpu_closed, scene, view_of(camera, closed, 1), size), reach);
    for (std::size_t m = 0; m < judged.size(); ++m)
      judge(counter.count(gpu_judged[m], scene, view_of(camera, judged[m], 1), size), inside, results[m]);
  }
  return results;
}

}  // namespace odontoscope
