#include "plane_raster.h"

#include <algorithm>
#include <cmath>

namespace odontoscope::test {
namespace {

/// Turns over the side of all points right of a segment; the sum over closed curves tells inside from outside. A row
/// meets a segment if one end lies below it and the other on or above it, so curves stay closed for every row.
class Parity {
 public:
  explicit Parity(const Raster& raster) : raster_(raster), flips_((raster.columns + 1) * raster.rows, 0) {}

  void add(const Point2& a, const Point2& b) {
    const Point2 &low = a.y < b.y ? a : b, &high = a.y < b.y ? b : a;
    const double from = std::ceil((low.y - raster_.y0) / raster_.step) - 1;
    for (std::size_t row = static_cast<std::size_t>(std::max(from, 0.0)); row < raster_.rows; ++row) {
      const double y = raster_.y(row);
      if (y <= low.y) continue;
      if (y > high.y) break;
      const double x = low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
      const double column = std::ceil((x - raster_.x0) / raster_.step);
      flips_[row * (raster_.columns + 1) +
             static_cast<std::size_t>(std::clamp(column, 0.0, static_cast<double>(raster_.columns)))] ^= 1;
    }
  }

  Mask mask() const {
    Mask result(raster_.size());
    for (std::size_t row = 0; row < raster_.rows; ++row) {
      std::uint8_t inside = 0;
      for (std::size_t column = 0; column < raster_.columns; ++column) {
        inside ^= flips_[row * (raster_.columns + 1) + column];
        result[raster_.index(column, row)] = inside;
      }
    }
    return result;
  }

 private:
  const Raster& raster_;
  std::vector<std::uint8_t> flips_;
};

}  // namespace

Mask inside_contours(const Raster& raster, const Slice& slice, const std::string& structure) {
  Parity parity(raster);
  for (const Contour& contour : slice.contours) {
    if (contour.structure != structure) continue;
    for (std::size_t i = 0; i < contour.points.size(); ++i)
      parity.add(contour.points[i], contour.points[(i + 1) % contour.points.size()]);
  }
  return parity.mask();
}

SurfaceSections::SurfaceSections(const SurfaceMesh& mesh, const std::vector<double>& heights)
    : mesh_(mesh), heights_(heights), crossing_(heights.size()) {
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const auto [low, high] = std::minmax({mesh.points[a].z, mesh.points[b].z, mesh.points[c].z});
    // A corner in the plane counts as below it.
    for (auto h = std::lower_bound(heights.begin(), heights.end(), low); h != heights.end() && *h < high; ++h)
      crossing_[static_cast<std::size_t>(h - heights.begin())].push_back(t);
  }
}

Mask SurfaceSections::at(const Raster& raster, std::size_t height) const {
  Parity parity(raster);
  const double z = heights_[height];
  const auto point = [&](PointIndex i, PointIndex j) {  // the same whichever triangle asks
    const Point3 &a = mesh_.points[std::min(i, j)], &b = mesh_.points[std::max(i, j)];
    const double share = (z - a.z) / (b.z - a.z);
    return Point2{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
  };
  for (const std::uint32_t t : crossing_[height]) {
    const Triangle& corners = mesh_.triangles[t];
    Point2 ends[2];
    int found = 0;
    for (int k = 0; k < 3; ++k) {
      const PointIndex i = corners[static_cast<std::size_t>(k)], j = corners[static_cast<std::size_t>((k + 1) % 3)];
      if ((mesh_.points[i].z > z) != (mesh_.points[j].z > z) && found < 2) ends[found++] = point(i, j);
    }
    if (found == 2) parity.add(ends[0], ends[1]);
  }
  return parity.mask();
}

}  // namespace odontoscope::test
