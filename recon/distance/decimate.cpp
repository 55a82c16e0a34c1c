#include "recon/distance/decimate.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace odontoscope {
namespace {

using FloatPoint = std::array<float, 3>;

std::vector<FloatPoint> relative_points(const SurfaceMesh& surface) {
  Point3 low = surface.points.front();
  for (const Point3& p : surface.points) low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  std::vector<FloatPoint> points;
  points.reserve(surface.points.size());
  for (const Point3& p : surface.points) {
    points.push_back(
        {static_cast<float>(p.x - low.x), static_cast<float>(p.y - low.y), static_cast<float>(p.z - low.z)});
  }
  return points;
}

SurfaceMesh used_part(const SurfaceMesh& surface, const std::vector<unsigned>& of_triangles) {
  constexpr PointIndex unused = std::numeric_limits<PointIndex>::max();
  std::vector<PointIndex> number(surface.points.size(), unused);
  for (const unsigned corner : of_triangles) number[corner] = 0;
  SurfaceMesh used;
  for (std::size_t v = 0; v < number.size(); ++v) {  // points keep their order
    if (number[v] == unused) continue;
    number[v] = static_cast<PointIndex>(used.points.size());
    used.points.push_back(surface.points[v]);
  }
  for (std::size_t i = 0; i + 2 < of_triangles.size(); i += 3) {
    used.triangles.push_back({number[of_triangles[i]], number[of_triangles[i + 1]], number[of_triangles[i + 2]]});
  }
  return used;
}

}  // namespace

DecimatedSurface decimate(const SurfaceMesh& surface, const DecimateOptions& options) {
  DecimatedSurface result;
  if (surface.triangles.empty()) return result;
  const std::vector<FloatPoint> points = relative_points(surface);
  std::vector<unsigned> corners;
  corners.reserve(3 * surface.triangles.size());
  for (const Triangle& t : surface.triangles) corners.insert(corners.end(), t.begin(), t.end());

  const float scale = meshopt_simplifyScale(points.front().data(), points.size(), sizeof(FloatPoint));
  const float error =
      options.triangles ? std::numeric_limits<float>::max() : static_cast<float>(options.largest_error) / scale;
  std::vector<unsigned> kept(corners.size());
  float reached = 0;
  const std::size_t count =
      meshopt_simplify(kept.data(), corners.data(), corners.size(), points.front().data(), points.size(),
                       sizeof(FloatPoint), 3 * options.triangles.value_or(0), error, 0, &reached);
  kept.resize(count);
  result.surface = used_part(surface, kept);
  result.report = inspect(result.surface);
  result.error = static_cast<double>(reached) * static_cast<double>(scale);
  return result;
}

std::string decimation_library() {
  static_assert(MESHOPTIMIZER_VERSION >= 180, "meshopt_simplify has other arguments");
  return fmt::format("meshoptimizer {}.{}", MESHOPTIMIZER_VERSION / 1000, MESHOPTIMIZER_VERSION % 1000 / 10);
}

}  // namespace odontoscope
