#include "recon/between/blend.h"

#include <algorithm>
#include <cmath>

#include "recon/between/blend_units.h"
#include "recon/between/composed.h"
#include "recon/contours/simplify_contours.h"
#include "recon/contours/trace.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"

namespace odontoscope::between {
namespace {

using trace::Vertex;

void check(const Surroundings& s, std::span<const double> shares) {
  const bool given = s.lower && s.upper;
  const bool finite = std::isfinite(s.z_lower) && std::isfinite(s.z_upper);
  const bool ascending = s.z_lower < s.z_upper && (!s.before || s.z_before < s.z_lower) && (!s.after || s.z_upper < s.z_after);
  const bool beyond = (!s.before || std::isfinite(s.z_before)) && (!s.after || std::isfinite(s.z_after));
  if (!given || !finite || !ascending || !beyond) throw InternalError("a slab to be blended has no two slices in order");
  for (std::size_t n = 0; n < shares.size(); ++n) {
    const bool between = shares[n] > 0 && shares[n] < 1 && (n == 0 || shares[n] > shares[n - 1]);
    if (!between) throw InternalError("shares of a slab must lie between 0 and 1 and ascend");
  }
}

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

Slice traced(const Window& window, const Grid& grid) {
  Slice slice;
  trace::contours(Field(window, grid), static_cast<std::size_t>(window.columns), static_cast<std::size_t>(window.rows),
                  [&slice](std::vector<Point2>&& points) {
                    slice.contours.push_back({"", std::move(points)});
                    return true;
                  });
  return slice;
}

std::size_t points_in(const Outline& outline) {
  std::size_t count = 0;
  for (const std::vector<Point2>& ring : outline) count += ring.size();
  return count;
}

std::size_t points_in(const Slice& slice) {
  std::size_t count = 0;
  for (const Contour& contour : slice.contours) count += contour.points.size();
  return count;
}

/// Thinned to the tolerance, and further while it has more points than the given slices.
Outline thinned(Slice slice, double tolerance, std::size_t enough) {
  slice = simplify_slice(slice, tolerance).slice;
  for (int round = 0; round < limits::blend_thinning_rounds && points_in(slice) > enough; ++round) {
    tolerance *= 2;
    slice = simplify_slice(slice, tolerance).slice;
  }
  Outline outline;
  for (Contour& contour : slice.contours) outline.push_back(std::move(contour.points));
  return outline;
}

double larger_side(const SliceSet& slices) {
  Box box;
  for (const std::size_t slice : {at_lower, at_upper}) {
    for (const ContourFacts& facts : slices.facts[slice]) box.take(facts.box);
  }
  return std::max(box.high.x - box.low.x, box.high.y - box.low.y);
}

}  // namespace

std::vector<Outline> blend(const Surroundings& surroundings, std::span<const double> shares, const BlendOptions& options) {
  check(surroundings, shares);
  std::vector<Outline> result;
  if (surroundings.lower->empty() && surroundings.upper->empty()) {
    result.resize(shares.size());
    return result;
  }
  const SliceSet slices(surroundings);
  const BlendPlan plan = blend_plan(slices, surroundings);
  const std::optional<Grid> grid = grid_for(slices, options.most_grid_points);
  if (!grid) {
    for (const double share : shares) result.push_back(share < 0.5 ? *surroundings.lower : *surroundings.upper);
    return result;
  }
  const Composition composition(slices, plan, *grid);
  const double tolerance = options.thinning * larger_side(slices);
  const std::size_t enough = std::max(points_in(*surroundings.lower), points_in(*surroundings.upper));
  for (const double share : shares) result.push_back(thinned(traced(composition.at(share), *grid), tolerance, enough));
  return result;
}

}  // namespace odontoscope::between
