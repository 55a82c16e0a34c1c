#include "recon/cavity/height_pieces.h"

#include <algorithm>
#include <utility>

#include "recon/core/polygon.h"
#include "recon/core/union_find.h"
#include "recon/mesh/plane_section.h"

namespace odontoscope::cavity {
namespace {

/// In the middle of the widest gap between vertices about each wanted level.
std::vector<double> off_vertices(const SurfaceMesh& surface, const std::vector<double>& wanted) {
  std::vector<double> heights;
  for (const Point3& p : surface.points) heights.push_back(p.z);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  std::vector<double> levels;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double low = i > 0 ? (wanted[i - 1] + wanted[i]) / 2 : wanted[i],
                 high = i + 1 < wanted.size() ? (wanted[i] + wanted[i + 1]) / 2 : wanted[i];
    const auto is_free = [&](double z) { return !std::binary_search(heights.begin(), heights.end(), z); };
    double best = wanted[i], widest = 0;
    for (auto above = std::lower_bound(heights.begin(), heights.end(), low);
         !is_free(wanted[i]) && above != heights.end(); ++above) {
      const double from = std::max(above == heights.begin() ? low : *(above - 1), low), to = std::min(*above, high);
      if (to - from > widest) {
        widest = to - from;
        best = from + (to - from) / 2;
      }
      if (*above >= high) break;
    }
    if (is_free(best) && best > heights.front() && best < heights.back() && (levels.empty() || best > levels.back()))
      levels.push_back(best);
  }
  return levels;
}

class Slicing {
 public:
  Slicing(const SurfaceMesh& surface, const EdgeMates& edges, HeightPieces& made)
      : surface_(surface), edges_(edges), made_(made) {
    for (const Point3& p : surface.points)
      slab_.push_back(static_cast<std::size_t>(std::upper_bound(made.levels.begin(), made.levels.end(), p.z) -
                                               made.levels.begin()));
    made_.first_piece.push_back(0);
    for (const Triangle& t : surface.triangles) {
      const auto [low, high] = std::minmax({slab_[t[0]], slab_[t[1]], slab_[t[2]]});
      made_.lowest_slab.push_back(low);
      made_.first_piece.push_back(made_.first_piece.back() + high - low + 1);
    }
  }

  void join_pieces() {
    UnionFind pieces(made_.first_piece.back());
    const auto numbered = [&](HalfEdge h, std::size_t slab) { return static_cast<std::uint32_t>(part(h / 3, slab)); };
    for (HalfEdge h = 0; h < 3 * surface_.triangles.size(); ++h) {
      if (h > edges_.mate[h]) continue;
      const auto [low, high] = std::minmax(slab_[start(surface_, h)], slab_[end(surface_, h)]);
      for (std::size_t s = low; s <= high; ++s) pieces.join(numbered(h, s), numbered(edges_.mate[h], s));
    }
    std::vector<std::size_t> number(made_.first_piece.back(), 0);
    made_.piece_of.resize(number.size());
    for (std::uint32_t i = 0; i < number.size(); ++i) {
      if (pieces.find(i) == i) number[i] = made_.pieces++;  // the lowest is the first
      made_.piece_of[i] = number[pieces.find(i)];
    }
  }

  void find_sections() {
    std::vector<std::vector<HalfEdge>> rising(made_.levels.size());
    for (HalfEdge h = 0; h < 3 * surface_.triangles.size(); ++h)
      for (std::size_t level = slab_[start(surface_, h)]; level < slab_[end(surface_, h)]; ++level)
        rising[level].push_back(h);
    std::vector<std::size_t> seen(surface_.triangles.size(), made_.levels.size());
    for (std::size_t level = 0; level < rising.size(); ++level) {
      const std::size_t first = made_.sections.size();
      for (const HalfEdge h : rising[level])
        if (seen[h / 3] != level) add_section(level, h, seen);
      tell_islands(first);
    }
  }

 private:
  std::size_t part(std::size_t triangle, std::size_t slab) const {
    return made_.first_piece[triangle] + slab - made_.lowest_slab[triangle];
  }
  bool rises_through(HalfEdge h, std::size_t level) const {
    return slab_[start(surface_, h)] <= level && slab_[end(surface_, h)] > level;
  }

  /// Of a triangle that is cut one edge rises through the level and one falls: on through the falling one, whose mate
  /// rises.
  void add_section(std::size_t level, HalfEdge rising, std::vector<std::size_t>& seen) {
    Section section{level, {}, made_.piece_of[part(rising / 3, level)], made_.piece_of[part(rising / 3, level + 1)]};
    Polygon loop;
    for (HalfEdge h = rising; seen[h / 3] != level;) {
      seen[h / 3] = level;
      HalfEdge falling = next(h);
      if (!rises_through(edges_.mate[falling], level)) falling = previous(h);
      section.edges.push_back(falling);
      loop.push_back(crossing_point(surface_, falling, made_.levels[level]));
      h = edges_.mate[falling];
    }
    section.hole = signed_area(loop) > 0;
    made_.sections.push_back(std::move(section));
    loops_.push_back(std::move(loop));
  }

  void tell_islands(std::size_t first) {
    for (std::size_t i = first; i < made_.sections.size(); ++i)
      for (std::size_t k = first; k < made_.sections.size() && !made_.sections[i].hole; ++k)
        if (made_.sections[k].hole && encloses(loops_[k], loops_[i].front())) made_.sections[i].island = true;
  }

  const SurfaceMesh& surface_;
  const EdgeMates& edges_;
  HeightPieces& made_;
  std::vector<std::size_t> slab_;  // of each vertex: how many levels lie below it
  std::vector<Polygon> loops_;
};

}  // namespace

HeightPieces height_pieces(const SurfaceMesh& surface, const EdgeMates& edges, const std::vector<double>& wanted) {
  HeightPieces made;
  made.levels = off_vertices(surface, wanted);
  Slicing slicing(surface, edges, made);
  slicing.join_pieces();
  slicing.find_sections();
  return made;
}

}  // namespace odontoscope::cavity
