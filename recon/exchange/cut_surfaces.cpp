#include "recon/exchange/cut_surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "recon/core/limits.h"
#include "recon/core/polygon.h"
#include "recon/core/portable_math.h"
#include "recon/exchange/region_border.h"
#include "recon/input/planar_sweep.h"
#include "recon/input/validate.h"
#include "recon/mesh/half_edges.h"
#include "recon/mesh/plane_section.h"

namespace odontoscope {
namespace {

double gap_between(const Point2& a, const Point2& b) { return portable::hypot(a.x - b.x, a.y - b.y); }

/// A mesh made ready: its edges, and its triangles from low to high.
struct Prepared {
  const NamedMesh& source;
  EdgeMates mates;
  struct Span {
    double low, high;
    std::uint32_t triangle;
  };
  std::vector<Span> spans;  // by `low`
};

Prepared prepared(const NamedMesh& source) {
  const SurfaceMesh& mesh = source.surface;
  Prepared ready{source, edge_mates(mesh), {}};
  ready.spans.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (repeats_a_vertex(mesh.triangles[t])) continue;
    const auto [low, high] = std::minmax({mesh.points[mesh.triangles[t][0]].z, mesh.points[mesh.triangles[t][1]].z,
                                          mesh.points[mesh.triangles[t][2]].z});
    ready.spans.push_back({low, high, t});
  }
  std::stable_sort(ready.spans.begin(), ready.spans.end(), [](const auto& a, const auto& b) { return a.low < b.low; });
  return ready;
}

/// The first edge that `is_faulty` says yes to, as a place in words.
template <class Faulty>
std::string first_place(const SurfaceMesh& mesh, const EdgeMates& mates, Faulty is_faulty) {
  for (HalfEdge h = 0; h < mates.mate.size(); ++h) {
    if (!is_faulty(h)) continue;
    const Point3 &a = mesh.points[start(mesh, h)], &b = mesh.points[end(mesh, h)];
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", (a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2);
  }
  return "an unknown place";
}

void refuse_unless_closed(const Prepared& ready, const std::string& file) {
  const SurfaceMesh& mesh = ready.source.surface;
  const EdgeMates& mates = ready.mates;
  Place place;
  place.file = file;
  const std::string remedy = "Close it in the program that made it, or give --repair";
  if (mates.boundary_edges > 0) {
    const std::string where = first_place(mesh, mates, [&](HalfEdge h) { return mates.mate[h] == EdgeMates::none; });
    throw InputError("open-surface", place,
                     fmt::format("the surface of {} is open: {} border edges, one at {}", ready.source.name,
                                 mates.boundary_edges, where),
                     remedy);
  }
  if (mates.nonmanifold_edges > 0) {
    const std::string where = first_place(mesh, mates, [&](HalfEdge h) { return mates.mate[h] == EdgeMates::many; });
    throw InputError("crowded-edge", place,
                     fmt::format("{} edges of {} have more than two triangles, one at {}", mates.nonmanifold_edges,
                                 ready.source.name, where),
                     remedy);
  }
  if (mates.misoriented_edges > 0) {
    const std::string where = first_place(mesh, mates, [&](HalfEdge h) {
      return mates.mate[h] < EdgeMates::no_edge && start(mesh, h) == start(mesh, mates.mate[h]);
    });
    throw InputError("misoriented-surface", place,
                     fmt::format("at {} edges of {} neighbouring triangles are turned opposite ways, at one near {}",
                                 mates.misoriented_edges, ready.source.name, where),
                     remedy);
  }
}

/// Open lines joined end to nearest end by straight lines, until all are closed.
class GapCloser {
 public:
  GapCloser(std::vector<std::vector<Point2>> lines, const Place& place, const std::string& structure,
            const CutOptions& options, std::vector<ContourChange>& changes)
      : lines_(std::move(lines)), place_(place), structure_(structure), options_(options), changes_(changes) {}

  std::vector<std::vector<Point2>> closed() {
    std::vector<std::vector<Point2>> loops;
    while (!lines_.empty()) {
      const Join join = shortest();
      if (join.length > options_.widest_gap) refuse(join);
      if (join.length > 0) tell(join);
      if (join.first == join.second) {
        loops.push_back(std::move(lines_[join.first]));
        lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(join.first));
      } else {
        append(join);
      }
    }
    return loops;
  }

 private:
  /// The end of line `first` with the start of line `second` (or, with `reversed`, ends with ends).
  struct Join {
    std::size_t first = 0, second = 0;
    bool first_from_start = false, second_at_end = false;
    double length = std::numeric_limits<double>::max();
  };

  const Point2& end_of(std::size_t line, bool at_end) const {
    return at_end ? lines_[line].back() : lines_[line].front();
  }

  Join shortest() const {
    Join best;
    for (std::size_t a = 0; a < lines_.size(); ++a) {
      consider(best, {a, a, false, false, gap_between(lines_[a].back(), lines_[a].front())});
      for (std::size_t b = a + 1; b < lines_.size(); ++b) {
        for (const bool a_start : {false, true}) {
          for (const bool b_end : {false, true}) {
            consider(best, {a, b, a_start, b_end, gap_between(end_of(a, !a_start), end_of(b, b_end))});
          }
        }
      }
    }
    return best;
  }
  static void consider(Join& best, const Join& join) {
    if (join.length < best.length) best = join;
  }

  void append(const Join& join) {
    std::vector<Point2>& first = lines_[join.first];
    std::vector<Point2> second = std::move(lines_[join.second]);
    if (join.first_from_start) std::reverse(first.begin(), first.end());
    if (join.second_at_end) std::reverse(second.begin(), second.end());
    first.insert(first.end(), second.begin(), second.end());
    lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(join.second));
  }

  void tell(const Join& join) {
    const Point2& at = end_of(join.first, !join.first_from_start);
    changes_.push_back({place_, structure_,
                        fmt::format("a gap of {:.3g} mm at ({:.6g}, {:.6g}) was closed", join.length, at.x, at.y)});
  }

  [[noreturn]] void refuse(const Join& join) const {
    const Point2& at = end_of(join.first, !join.first_from_start);
    throw InputError(
        "gap-too-wide", place_,
        fmt::format("the surface of {} leaves a gap of {:.3g} mm at ({:.6g}, {:.6g}), and at most {:.3g} mm are closed",
                    structure_, join.length, at.x, at.y, options_.widest_gap),
        "Close the surface in the program that made it, or allow more with --widest-gap");
  }

  std::vector<std::vector<Point2>> lines_;
  const Place& place_;
  const std::string& structure_;
  const CutOptions& options_;
  std::vector<ContourChange>& changes_;
};

/// Cuts all meshes of one structure, height after ascending height.
class StructureCutter {
 public:
  StructureCutter(std::vector<Prepared> meshes, const CutOptions& options, std::vector<ContourChange>& changes)
      : meshes_(std::move(meshes)),
        next_(meshes_.size(), 0),
        active_(meshes_.size()),
        options_(options),
        changes_(changes) {}

  std::vector<Contour> cut(double height, const Place& place) {
    advance_to(height);
    std::vector<Contour> contours = contours_on(Side::below, height, place, &changes_);
    std::optional<Breach> breach = breach_of(contours);
    if (touches_vertex(height) && (!breach || breach->kind != Breach::Kind::crossing)) {
      contours = either_side(std::move(contours), contours_on(Side::above, height, place, nullptr));
      breach = breach_of(contours);
    }
    if (breach && !options_.repair) refuse(*breach, place);
    return contours;
  }

 private:
  const std::string& structure() const { return meshes_.front().source.name; }

  /// Takes up the triangles that begin at or below the height, and drops those that end below it.
  void advance_to(double height) {
    for (std::size_t m = 0; m < meshes_.size(); ++m) {
      const auto& spans = meshes_[m].spans;
      for (; next_[m] < spans.size() && spans[next_[m]].low <= height; ++next_[m])
        active_[m].push_back(spans[next_[m]]);
      std::erase_if(active_[m], [&](const Prepared::Span& span) { return span.high < height; });
    }
  }

  std::vector<std::uint32_t> crossed(std::size_t m, double height, Side side) const {
    std::vector<std::uint32_t> triangles;
    for (const Prepared::Span& span : active_[m]) {
      const bool begins_below = side == Side::below ? span.low < height : span.low <= height;
      const bool ends_above = side == Side::below ? span.high >= height : span.high > height;
      if (begins_below && ends_above) triangles.push_back(span.triangle);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  }

  bool touches_vertex(double height) const {
    for (std::size_t m = 0; m < meshes_.size(); ++m) {
      const SurfaceMesh& mesh = meshes_[m].source.surface;
      for (const Prepared::Span& span : active_[m]) {
        for (const PointIndex v : mesh.triangles[span.triangle]) {
          if (mesh.points[v].z == height) return true;
        }
      }
    }
    return false;
  }

  /// What is material just below the plane or just above it. As it lies below, to the bit, where the two are the same.
  std::vector<Contour> either_side(std::vector<Contour> below, const std::vector<Contour>& above) const {
    std::vector<std::vector<Point2>> polygons;
    double sum = 0;
    const auto take = [&](const std::vector<Contour>& side) {
      for (const Contour& contour : side) {
        polygons.push_back(contour.points);
        sum += signed_area(contour.points);
      }
    };
    take(below);
    take(above);
    if (is_same(below, above) && !breach_of(below)) return below;
    if (sum < 0) {  // a surface that is inside out as a whole
      for (std::vector<Point2>& polygon : polygons) std::reverse(polygon.begin(), polygon.end());
    }
    std::vector<Contour> both;
    for (std::vector<Point2>& points : region_border(polygons, {.inside = Inside::positive}))
      both.push_back({structure(), std::move(points)});
    return both;
  }

  /// The same points in the same order, whichever is first.
  static bool is_same(const std::vector<Contour>& a, const std::vector<Contour>& b) {
    const auto in_order = [](const std::vector<Contour>& contours) {
      const auto before = [](const Point2& p, const Point2& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; };
      std::vector<std::vector<Point2>> polygons;
      for (const Contour& contour : contours) {
        polygons.push_back(contour.points);
        std::rotate(polygons.back().begin(), std::min_element(polygons.back().begin(), polygons.back().end(), before),
                    polygons.back().end());
      }
      std::sort(polygons.begin(), polygons.end(), [&](const auto& p, const auto& q) {
        return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end(), before);
      });
      return polygons;
    };
    return in_order(a) == in_order(b);
  }

  /// Gaps that were closed go to `told` unless it is null.
  std::vector<Contour> contours_on(Side side, double height, const Place& place,
                                   std::vector<ContourChange>* told) const {
    std::vector<std::vector<Point2>> loops, lines;
    for (std::size_t m = 0; m < meshes_.size(); ++m) {
      const SurfaceMesh& mesh = meshes_[m].source.surface;
      for (const SectionTrace& trace : section_traces(mesh, meshes_[m].mates, crossed(m, height, side), height, side)) {
        std::vector<Point2> points;
        for (const HalfEdge h : trace.edges) points.push_back(crossing_point(mesh, h, height));
        (trace.closed ? loops : lines).push_back(std::move(points));
      }
    }
    std::vector<ContourChange> unheard;
    GapCloser closer(std::move(lines), place, structure(), options_, told != nullptr ? *told : unheard);
    for (std::vector<Point2>& loop : closer.closed()) loops.push_back(std::move(loop));
    std::vector<Contour> contours;
    for (std::vector<Point2>& points : loops) {
      points.erase(std::unique(points.begin(), points.end()), points.end());
      while (points.size() > 1 && points.back() == points.front()) points.pop_back();
      // What encloses nothing only touched the plane.
      if (points.size() >= 3 && !collinear(points)) contours.push_back({structure(), std::move(points)});
    }
    return contours;
  }

  static std::optional<Breach> breach_of(const std::vector<Contour>& contours) {
    std::vector<std::size_t> all(contours.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return sweep(contours, all).breach;
  }

  [[noreturn]] void refuse(const Breach& breach, Place place) const {
    place.at = breach.at;
    throw InputError(
        "section-meets-itself", place, fmt::format("the surface of {} cuts through or touches itself", structure()),
        "Mend it in the program that made it, move the planes a little with another --spacing-z, or give --repair");
  }

  std::vector<Prepared> meshes_;
  std::vector<std::size_t> next_;                    // span that comes next, for each mesh
  std::vector<std::vector<Prepared::Span>> active_;  // that reach up to the height at hand and begin no higher
  const CutOptions& options_;
  std::vector<ContourChange>& changes_;
};

/// Surfaces of one name together, in order of first appearance.
std::vector<std::vector<Prepared>> by_structure(const std::vector<NamedMesh>& surfaces) {
  std::vector<std::vector<Prepared>> groups;
  for (const NamedMesh& surface : surfaces) {
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const auto& g) { return g.front().source.name == surface.name; });
    if (group == groups.end()) group = groups.insert(groups.end(), std::vector<Prepared>{});
    group->push_back(prepared(surface));
  }
  return groups;
}

/// The same section has the same points in the same order, whichever triangle was met first.
void begin_at_least_point(std::vector<Point2>& points) {
  const auto before = [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::rotate(points.begin(), std::min_element(points.begin(), points.end(), before), points.end());
}

/// A surface that is inside out as a whole would otherwise be wound around nowhere.
void turn_outwards(ContourStack& stack) {
  for (const std::string& structure : structures_of(stack)) {
    double sum = 0;
    const auto each = [&](auto visit) {
      for (Slice& slice : stack.slices) {
        for (Contour& contour : slice.contours) {
          if (contour.structure == structure) visit(contour.points);
        }
      }
    };
    each([&](const std::vector<Point2>& points) { sum += signed_area(points); });
    if (sum < 0) each([](std::vector<Point2>& points) { std::reverse(points.begin(), points.end()); });
  }
}

}  // namespace

std::vector<double> heights_at(const std::vector<NamedMesh>& surfaces, double spacing) {
  if (!(spacing > 0) || !std::isfinite(spacing))
    throw UsageError(fmt::format("--spacing-z {}: slices lie a positive length apart", spacing));
  double low = std::numeric_limits<double>::max(), high = -low;
  for (const NamedMesh& surface : surfaces) {
    for (const Triangle& t : surface.surface.triangles) {
      for (const PointIndex v : t) {
        low = std::min(low, surface.surface.points[v].z);
        high = std::max(high, surface.surface.points[v].z);
      }
    }
  }
  const double count = std::floor((high - low) / spacing + 0.5);
  if (!(count >= 2)) {
    throw UsageError(fmt::format("--spacing-z {}: the model is only {:.4g} mm high, and two slices are needed", spacing,
                                 std::max(0.0, high - low)),
                     "Give a smaller one");
  }
  if (count > static_cast<double>(limits::slices)) {
    throw UsageError(
        fmt::format("--spacing-z {}: that makes {:.0f} slices of a model {:.4g} mm high, and {} are allowed", spacing,
                    count, high - low, limits::slices),
        "Give a larger one");
  }
  std::vector<double> heights;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    heights.push_back(low + (static_cast<double>(i) + 0.5) * spacing);
  return heights;
}

CutContours cut_surfaces(const std::vector<NamedMesh>& surfaces, const std::vector<double>& heights,
                         const std::string& file, const CutOptions& options, const Progress& progress) {
  ContourStack stack;
  std::vector<ContourChange> changes;
  stack.source = file;
  std::vector<StructureCutter> cutters;
  for (std::vector<Prepared>& group : by_structure(surfaces)) {
    if (!options.repair) {
      for (const Prepared& ready : group) refuse_unless_closed(ready, file);
    }
    cutters.emplace_back(std::move(group), options, changes);
  }
  for (std::size_t s = 0; s < heights.size(); ++s) {
    progress.check();
    progress.tell("cut", static_cast<double>(s) / static_cast<double>(heights.size()));
    Place place;
    place.file = file;
    place.slice = s;
    place.z = heights[s];
    Slice slice{heights[s], {}};
    for (StructureCutter& cutter : cutters) {
      std::vector<Contour> contours = cutter.cut(heights[s], place);
      std::move(contours.begin(), contours.end(), std::back_inserter(slice.contours));
    }
    for (Contour& contour : slice.contours) begin_at_least_point(contour.points);
    stack.slices.push_back(std::move(slice));
  }
  if (options.repair) {
    turn_outwards(stack);
    RepairedContours repaired = repair_contours(stack, {.inside = Inside::positive}, progress);
    stack = std::move(repaired.stack);
    changes.insert(changes.end(), repaired.changes.begin(), repaired.changes.end());
  }
  return {validate(std::move(stack), progress), std::move(changes)};
}

}  // namespace odontoscope
