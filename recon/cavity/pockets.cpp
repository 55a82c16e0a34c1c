#include "recon/cavity/pockets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "recon/cavity/height_pieces.h"
#include "recon/cavity/limits.h"
#include "recon/cavity/polygon_cap.h"
#include "recon/core/polygon.h"
#include "recon/mesh/plane_section.h"
#include "recon/mesh/vector.h"

namespace odontoscope::cavity {
namespace {

constexpr std::size_t outside = static_cast<std::size_t>(-1);

std::vector<double> wanted_levels(const SurfaceMesh& surface) {
  double low = surface.points.front().z, high = low;
  for (const Point3& p : surface.points) {
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  std::vector<double> levels{low + limits::cap_inset * (high - low)};
  for (std::size_t i = 1; i < limits::pocket_levels; ++i)
    levels.push_back(low + (high - low) * static_cast<double>(i) / static_cast<double>(limits::pocket_levels));
  levels.push_back(high - limits::cap_inset * (high - low));
  return levels;
}

/// Each piece's pocket: pieces that meet in holes only, and are joined through them.
std::vector<std::size_t> pocket_of_piece(const HeightPieces& pieces) {
  std::vector<char> inner(pieces.pieces, 0), outer(pieces.pieces, 0);
  for (const Section& section : pieces.sections)
    for (const std::size_t piece : {section.below, section.above})
      (section.hole || section.island ? inner : outer)[piece] = 1;
  std::vector<std::size_t> pocket(pieces.pieces, outside);
  for (std::size_t piece = 0; piece < pocket.size(); ++piece)
    if (inner[piece] && !outer[piece]) pocket[piece] = piece;
  for (bool changed = true;
       changed;) {  // sections come from below upwards: twice or thrice at most, but for labyrinths
    changed = false;
    const auto meet = [&](const Section& section) {
      if (pocket[section.below] == outside || pocket[section.above] == outside ||
          pocket[section.below] == pocket[section.above])
        return;
      pocket[section.below] = pocket[section.above] = std::min(pocket[section.below], pocket[section.above]);
      changed = true;
    };
    std::for_each(pieces.sections.begin(), pieces.sections.end(), meet);
    std::for_each(pieces.sections.rbegin(), pieces.sections.rend(), meet);
  }
  return pocket;
}

Polygon places(const SurfaceMesh& surface, const Section& section, double level) {
  Polygon loop;
  for (const HalfEdge h : section.edges) loop.push_back(crossing_point(surface, h, level));
  return loop;
}

Point3 middle_of(const Polygon& loop, double level) {
  Point3 sum{0, 0, level};
  for (const Point2& p : loop) {
    sum.x += p.x / static_cast<double>(loop.size());
    sum.y += p.y / static_cast<double>(loop.size());
  }
  return sum;
}

/// A pocket's lining, cut off at its mouths, and caps.
class Lining {
 public:
  Lining(const SurfaceMesh& surface, const HeightPieces& pieces, const std::vector<std::size_t>& pocket_of,
         std::size_t pocket)
      : surface_(surface), pieces_(pieces) {
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
      const std::size_t lowest = pieces.lowest_slab[t], count = pieces.first_piece[t + 1] - pieces.first_piece[t];
      const auto inside = [&](std::size_t i) {
        return pocket_of[pieces.piece_of[pieces.first_piece[t] + i]] == pocket;
      };
      for (std::size_t first = 0; first < count; ++first) {
        if (!inside(first)) continue;
        std::size_t last = first;
        while (last + 1 < count && inside(last + 1)) ++last;
        add(t, lowest + first, lowest + last, first == 0, last + 1 == count);
        if (cut_from_.empty() || cut_from_.back() != t) cut_from_.push_back(t);
        first = last;
      }
    }
  }

  /// False if the mouth is no simple polygon.
  bool cap(const Section& section, bool pocket_below) {
    const double level = pieces_.levels[section.level];
    const auto triangles = triangulated(places(surface_, section, level));
    if (!triangles) return false;
    for (Triangle t : *triangles) {
      if (pocket_below) std::swap(t[1], t[2]);
      for (PointIndex& corner : t) corner = cut_point(section.edges[corner], section.level);
      caps_.push_back(t);
    }
    return true;
  }

  void take(Cavity& cavity) {
    cavity.wall = std::move(wall_);
    cavity.cap_triangles = caps_.size();
    cavity.wall.triangles.insert(cavity.wall.triangles.end(), caps_.begin(), caps_.end());
    cavity.cut_from = std::move(cut_from_);
  }

 private:
  PointIndex place(const std::tuple<PointIndex, PointIndex, std::size_t>& key, const Point3& at) {
    const auto [known, is_new] = known_.try_emplace(key, static_cast<PointIndex>(wall_.points.size()));
    if (is_new) wall_.points.push_back(at);
    return known->second;
  }
  PointIndex cut_point(HalfEdge h, std::size_t level) {
    const auto [a, b] = std::minmax({start(surface_, h), end(surface_, h)});
    const double height = pieces_.levels[level];
    const Point2 at = crossing_point(surface_, h, height);
    return place({a, b, level}, {at.x, at.y, height});
  }

  /// What of the triangle lies from one slab to another.
  void add(std::uint32_t t, std::size_t low, std::size_t high, bool to_bottom, bool to_top) {
    const auto above = [&](PointIndex v, std::size_t level) {
      return lies_above(surface_.points[v], pieces_.levels[level]);
    };
    std::vector<PointIndex> polygon;
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const PointIndex a = start(surface_, h), b = end(surface_, h);
      if ((to_bottom || above(a, low - 1)) && (to_top || !above(a, high)))
        polygon.push_back(place({a, a, 0}, surface_.points[a]));
      const bool through_bottom = !to_bottom && above(a, low - 1) != above(b, low - 1),
                 through_top = !to_top && above(a, high) != above(b, high);
      const bool rises = surface_.points[b].z > surface_.points[a].z;
      if (through_bottom && rises) polygon.push_back(cut_point(h, low - 1));
      if (through_top) polygon.push_back(cut_point(h, high));
      if (through_bottom && !rises) polygon.push_back(cut_point(h, low - 1));
    }
    for (std::size_t i = 2; i < polygon.size(); ++i)
      wall_.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
  }

  const SurfaceMesh& surface_;
  const HeightPieces& pieces_;
  SurfaceMesh wall_;
  std::vector<Triangle> caps_;
  std::vector<std::uint32_t> cut_from_;
  std::map<std::tuple<PointIndex, PointIndex, std::size_t>, PointIndex> known_;
};

double depth_of(const SurfaceMesh& wall) {
  double low = wall.points.front().z, high = low;
  for (const Point3& p : wall.points) {
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  return high - low;
}

bool anything_in(const Polygon& mouth, double level, const std::vector<const SurfaceMesh*>& others) {
  return std::any_of(others.begin(), others.end(), [&](const SurfaceMesh* other) {
    const std::vector<Polygon> loops = section_loops(*other, level);
    return std::any_of(loops.begin(), loops.end(), [&](const Polygon& loop) { return encloses(mouth, loop.front()); });
  });
}

}  // namespace

std::vector<Cavity> pockets_of(const StructureSurface& part, const SurfaceReport& report,
                               const std::vector<const SurfaceMesh*>& others) {
  std::vector<Cavity> found;
  if (!report.closed_oriented_manifold()) return found;
  const SurfaceMesh& surface = *part.surface;
  const HeightPieces pieces = height_pieces(surface, edge_mates(surface), wanted_levels(surface));
  const std::vector<std::size_t> pocket_of = pocket_of_piece(pieces);
  std::map<std::size_t, std::vector<const Section*>> mouths;  // of each pocket
  for (const Section& section : pieces.sections)
    if (pocket_of[section.below] != pocket_of[section.above])
      mouths[std::min(pocket_of[section.below], pocket_of[section.above])].push_back(&section);
  for (const auto& [pocket, sections] : mouths) {
    Lining lining(surface, pieces, pocket_of, pocket);
    Cavity cavity;
    cavity.structure = part.structure;
    double widest = 0;
    const bool closed = std::all_of(sections.begin(), sections.end(), [&](const Section* section) {
      const double level = pieces.levels[section->level];
      const Polygon loop = places(surface, *section, level);
      const double area = signed_area(loop);
      widest = std::max(widest, std::sqrt(4 * area / std::numbers::pi));
      cavity.mouths.push_back({middle_of(loop, level), area});
      const bool crowded = std::any_of(pieces.sections.begin(), pieces.sections.end(), [&](const Section& other) {
        return &other != section && other.level == section->level &&
               encloses(loop, places(surface, other, level).front());
      });
      return section->hole && !crowded && !anything_in(loop, level, others) &&
             lining.cap(*section, pocket_of[section->below] != outside);
    });
    if (!closed) continue;
    lining.take(cavity);
    if (depth_of(cavity.wall) < limits::pocket_depth * widest) continue;
    const SurfaceReport walls = inspect(cavity.wall);
    if (!walls.closed_oriented_manifold() || walls.shells.size() != 1 ||
        walls.shells.front().kind != Shell::Kind::cavity)
      continue;
    cavity.volume = std::abs(walls.shells.front().volume);
    found.push_back(std::move(cavity));
  }
  return found;
}

}  // namespace odontoscope::cavity
