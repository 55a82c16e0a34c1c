#include "recon/segmentation/rasterise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/input/validate.h"
#include "recon/mesh/exact_predicates.h"

namespace odontoscope {
namespace {

/// +1 if a, b, c turn left.
int turn_of(const Point2& a, const Point2& b, const Point2& c) {
  return orientation(Point3{a.x, a.y, 0}, Point3{b.x, b.y, 0}, Point3{c.x, c.y, 0}, Point3{a.x, a.y, 1});
}

/// The first n of [0, size) whose centre `at(n)` does not lie below `value`.
template <class At>
std::size_t first_not_below(double value, double origin, double spacing, std::size_t size, const At& at) {
  auto n = static_cast<std::size_t>(std::clamp((value - origin) / spacing, 0.0, static_cast<double>(size)));
  while (n > 0 && at(n - 1) >= value) --n;
  while (n < size && at(n) < value) ++n;
  return n;
}

/// As many of the row's first centres as `is_before`; where they end is about `guess`.
template <class IsBefore>
std::size_t count_before(double guess, const VoxelGrid& grid, const IsBefore& is_before) {
  const double about = (guess - grid.origin.x) / grid.spacing[0];
  auto m =
      static_cast<std::size_t>(std::clamp(std::isfinite(about) ? about : 0.0, 0.0, static_cast<double>(grid.size[0])));
  while (m > 0 && !is_before(m - 1)) --m;
  while (m < grid.size[0] && is_before(m)) ++m;
  return m;
}

/// Every border that a row crosses toggles the last centre before it; from the end of the row on, centres are then
/// inside behind an odd number.
void toggle(VoxelBits& bits, std::size_t count, std::size_t j, std::size_t k) {
  if (count > 0) bits.toggle(count - 1, j, k);
}

void fill_rows(VoxelBits& bits, const VoxelGrid& grid, std::size_t k) {
  for (std::size_t j = 0; j < grid.size[1]; ++j) {
    bool inside = false;
    for (std::size_t i = grid.size[0]; i-- > 0;) {
      inside = inside != bits.at(i, j, k);
      if (inside != bits.at(i, j, k)) bits.toggle(i, j, k);
    }
  }
}

void toggle_edge(const Point2& a, const Point2& b, const VoxelGrid& grid, std::size_t k, VoxelBits& bits) {
  if (a.y == b.y) return;
  const Point2 &low = a.y < b.y ? a : b, &high = a.y < b.y ? b : a;
  const auto y = [&](std::size_t j) { return grid.y(j); };
  const std::size_t end = first_not_below(high.y, grid.origin.y, grid.spacing[1], grid.size[1], y);
  for (std::size_t j = first_not_below(low.y, grid.origin.y, grid.spacing[1], grid.size[1], y); j < end; ++j) {
    const double at = low.x + (grid.y(j) - low.y) / (high.y - low.y) * (high.x - low.x);
    toggle(bits,
           count_before(at, grid,
                        [&](std::size_t i) {
                          return turn_of(low, high, {grid.x(i), grid.y(j)}) > 0;
                        }),
           j, k);
  }
}

/// A triangle seen along x, corners counter-clockwise from +x on; y and z are taken for x and y.
class SeenAlongX {
 public:
  SeenAlongX(const Point3& a, const Point3& b, const Point3& c) : a_(a), b_(b), c_(c) {
    const int sense = turn_of({a.y, a.z}, {b.y, b.z}, {c.y, c.z});
    if (sense < 0) std::swap(b_, c_);
    on_edge_ = sense == 0;
  }
  bool on_edge() const { return on_edge_; }

  bool holds(double y, double z) const {
    return left_of(a_, b_, y, z) && left_of(b_, c_, y, z) && left_of(c_, a_, y, z);
  }
  /// Does the point lie before the triangle's plane along x? On it, it does not.
  bool is_behind(const Point3& p) const { return orientation(a_, b_, c_, p) < 0; }

  double x_at(double y, double z) const {
    const double u1 = b_.y - a_.y, u2 = b_.z - a_.z, v1 = c_.y - a_.y, v2 = c_.z - a_.z, area = u1 * v2 - u2 * v1;
    const double s = ((y - a_.y) * v2 - (z - a_.z) * v1) / area, t = (u1 * (z - a_.z) - u2 * (y - a_.y)) / area;
    return a_.x + s * (b_.x - a_.x) + t * (c_.x - a_.x);
  }

 private:
  /// Moved along y by less than any number, along z by less still.
  static bool left_of(const Point3& from, const Point3& to, double y, double z) {
    const int sense = turn_of({from.y, from.z}, {to.y, to.z}, {y, z});
    if (sense != 0) return sense > 0;
    if (from.z != to.z) return to.z < from.z;
    return to.y > from.y;
  }

  Point3 a_, b_, c_;
  bool on_edge_ = false;
};

void toggle_triangle(const Point3& a, const Point3& b, const Point3& c, const VoxelGrid& grid, VoxelBits& bits) {
  const SeenAlongX triangle(a, b, c);
  if (triangle.on_edge()) return;
  const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
  const auto [low_z, high_z] = std::minmax({a.z, b.z, c.z});
  const auto y = [&](std::size_t j) { return grid.y(j); };
  const auto z = [&](std::size_t k) { return grid.z(k); };
  const std::size_t first = first_not_below(low_y, grid.origin.y, grid.spacing[1], grid.size[1], y);
  for (std::size_t k = first_not_below(low_z, grid.origin.z, grid.spacing[2], grid.size[2], z);
       k < grid.size[2] && grid.z(k) <= high_z; ++k) {
    for (std::size_t j = first; j < grid.size[1] && grid.y(j) <= high_y; ++j) {
      if (!triangle.holds(grid.y(j), grid.z(k))) continue;
      const auto before = [&](std::size_t i) { return triangle.is_behind({grid.x(i), grid.y(j), grid.z(k)}); };
      toggle(bits, count_before(triangle.x_at(grid.y(j), grid.z(k)), grid, before), j, k);
    }
  }
}

std::size_t nearest_slice(double z, const VoxelGrid& grid) {
  return static_cast<std::size_t>(
      std::clamp(std::round((z - grid.origin.z) / grid.spacing[2]), 0.0, static_cast<double>(grid.size[2] - 1)));
}

}  // namespace

VoxelGrid grid_of_slices(const ContourStack& stack, double spacing_x, double spacing_y, const Point2* origin) {
  std::vector<double> heights;
  for (const Slice& slice : stack.slices) heights.push_back(slice.z);
  std::sort(heights.begin(), heights.end());
  Place place;
  place.file = stack.source;
  if (heights.size() < 2)
    throw InputError("single-slice", place, "the stack has a single slice", "Add the slices above or below it");
  const double step = (heights.back() - heights.front()) / static_cast<double>(heights.size() - 1);
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (std::abs(heights[k] - heights.front() - static_cast<double>(k) * step) <= limits::slice_unevenness * step)
      continue;
    place.z = heights[k];
    throw InputError("uneven-slices", place,
                     fmt::format("slices lie unevenly, and voxels do not: even ones would be {:.6g} mm apart", step),
                     "Let reconstruct write the voxels: it fills the space between slices");
  }
  Box3 box = box_of(stack);
  box.low.z = box.high.z = 0;  // heights are the slices'
  const std::array<double, 3> spacing{spacing_x, spacing_y, step};
  VoxelGrid grid = origin == nullptr ? grid_around(box, spacing) : grid_from({origin->x, origin->y, 0}, box, spacing);
  grid.origin.z = heights.front();
  grid.size[2] = heights.size();
  check_grid(grid);
  return grid;
}

Segmentation rasterised(const ContourStack& stack, const VoxelGrid& grid, const Progress& progress) {
  Segmentation result{grid, {}};
  for (const std::string& name : structures_of(stack)) {
    Segment segment{name, VoxelBits(grid.size)};
    for (const Slice& slice : stack.slices) {
      progress.check();
      const std::size_t k = nearest_slice(slice.z, grid);
      for (const Contour& contour : slice.contours) {
        if (contour.structure != name) continue;
        const std::size_t n = contour.points.size();
        for (std::size_t p = 0; p < n; ++p)
          toggle_edge(contour.points[p], contour.points[(p + 1) % n], grid, k, segment.voxels);
      }
      fill_rows(segment.voxels, grid, k);
    }
    result.segments.push_back(std::move(segment));
    progress.tell("voxels",
                  static_cast<double>(result.segments.size()) / static_cast<double>(structures_of(stack).size()));
  }
  return result;
}

Segmentation rasterised(const std::vector<FilledSurface>& solids, const VoxelGrid& grid, const Progress& progress) {
  Segmentation result{grid, {}};
  constexpr std::size_t between_checks = 4096;
  for (const FilledSurface& solid : solids) {
    Segment segment{solid.name, VoxelBits(grid.size)};
    const SurfaceMesh& mesh = *solid.surface;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (t % between_checks == 0) progress.check();
      const Triangle& corners = mesh.triangles[t];
      toggle_triangle(mesh.points[corners[0]], mesh.points[corners[1]], mesh.points[corners[2]], grid, segment.voxels);
    }
    for (std::size_t k = 0; k < grid.size[2]; ++k) fill_rows(segment.voxels, grid, k);
    result.segments.push_back(std::move(segment));
    progress.tell("voxels", static_cast<double>(result.segments.size()) / static_cast<double>(solids.size()));
  }
  return result;
}

}  // namespace odontoscope
