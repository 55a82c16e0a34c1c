#include "recon/between/traced.h"

#include <algorithm>
#include <cmath>

#include "recon/contours/simplify_contours.h"
#include "recon/contours/trace.h"
#include "recon/core/limits.h"

namespace odontoscope::between {
namespace {

using trace::Vertex;

/// The window as trace::contours asks for it.
class Field {
 public:
  Field(const Window& window, const Grid& grid) : window_(window), grid_(grid) {}

  bool inside(Vertex v) const { return in_window(v) && value(v) < 0; }

  /// Is the saddle of the bilinear surface over the cell inside? a and b are, c and d are not.
  bool joined(Vertex a, Vertex b, Vertex c, Vertex d) const {
    if (!in_window(c) || !in_window(d)) return false;
    return value(a) * value(b) >= value(c) * value(d);
  }

  Point2 crossing(Vertex in, Vertex out) const {
    const double from = value(in), to = in_window(out) ? value(out) : far_outside;
    const double fraction = std::clamp(from / (from - to), limits::grid_vertex_margin, 1 - limits::grid_vertex_margin);
    const auto at = [&](std::ptrdiff_t first, std::ptrdiff_t a, std::ptrdiff_t b, double anchor) {
      const double place = static_cast<double>(first + a) + fraction * static_cast<double>(b - a);
      return std::round((anchor + grid_.step * place) / grid_.grain) * grid_.grain;
    };
    return {at(window_.first_i, in.i, out.i, grid_.anchor.x), at(window_.first_j, in.j, out.j, grid_.anchor.y)};
  }

 private:
  bool in_window(Vertex v) const { return v.i >= 0 && v.j >= 0 && v.i < window_.columns && v.j < window_.rows; }
  double value(Vertex v) const { return window_.values[static_cast<std::size_t>(v.j * window_.columns + v.i)]; }

  const Window& window_;
  const Grid& grid_;
};

std::size_t points_in(const Slice& slice) {
  std::size_t count = 0;
  for (const Contour& contour : slice.contours) count += contour.points.size();
  return count;
}

}  // namespace

Slice traced(const Window& window, const Grid& grid) {
  Slice slice;
  trace::contours(Field(window, grid), static_cast<std::size_t>(window.columns), static_cast<std::size_t>(window.rows),
                  [&slice](std::vector<Point2>&& points) {
                    slice.contours.push_back({"", std::move(points)});
                    return true;
                  });
  return slice;
}

Outline thinned(const Slice& slice, double tolerance, double largest, std::size_t enough) {
  Slice left = simplify_slice(slice, std::min(tolerance, largest)).slice;
  for (int round = 0; round < limits::blend_thinning_rounds && points_in(left) > enough; ++round) {
    tolerance *= 2;
    if (tolerance > largest) break;
    left = simplify_slice(slice, tolerance).slice;
  }
  Outline outline;
  for (Contour& contour : left.contours) outline.push_back(std::move(contour.points));
  return outline;
}

std::size_t points_in(const Outline& outline) {
  std::size_t count = 0;
  for (const std::vector<Point2>& ring : outline) count += ring.size();
  return count;
}

}  // namespace odontoscope::between
