#include "tests/support/oracle_topology.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "tests/support/joined.h"
#include "tests/support/oracle_parts.h"
#include "tests/support/plane_check.h"
#include "tests/support/slab_cells.h"

namespace odontoscope::test {
namespace {

constexpr std::size_t none = std::size_t(-1);

std::string in_words(const SlabCount& count) {
  return std::to_string(count.pieces) + " pieces, " + std::to_string(count.handles) + " handles, " +
         std::to_string(count.bubbles) + " bubbles";
}

/// A contour of one of the slab's two slices.
struct Border {
  bool upper = false;
  std::size_t number = 0;  // in its slice's list
  std::vector<Point2> ring;
  bool hole = false;
  std::size_t parent = none;  // the contour just round it, among the slab's
  std::size_t region = none;  // the outer contour of the region that it bounds
  bool present = false;       // its region is linked, or carries a plate in this slab
};

void nest(std::vector<Border>& borders) {
  std::vector<int> depth(borders.size(), 0);
  const auto inside = [&](std::size_t a, std::size_t b) {
    return a != b && borders[a].upper == borders[b].upper && is_inside(borders[b].ring, borders[a].ring[0]);
  };
  for (std::size_t a = 0; a < borders.size(); ++a)
    for (std::size_t b = 0; b < borders.size(); ++b) depth[a] += inside(a, b);
  for (std::size_t a = 0; a < borders.size(); ++a) {
    borders[a].hole = depth[a] % 2 == 1;
    for (std::size_t b = 0; b < borders.size(); ++b)
      if (inside(a, b) && depth[b] == depth[a] - 1) borders[a].parent = b;
    borders[a].region = borders[a].hole ? borders[a].parent : a;
  }
}

std::vector<Border> borders_of(const ContourStack& sorted, const std::string& structure, std::size_t slab) {
  std::vector<Border> borders;
  for (bool upper : {false, true}) {
    const Slice& slice = sorted.slices[slab + upper];
    for (std::size_t c = 0; c < slice.contours.size(); ++c)
      if (slice.contours[c].structure == structure) borders.push_back({upper, c, slice.contours[c].points});
  }
  nest(borders);
  return borders;
}

/// Judges one slab of one structure.
class SlabJudge {
 public:
  using Edge = std::pair<std::size_t, std::size_t>;  // of a lower and an upper region

  SlabJudge(const SlabCells& cells, const ContourStack& sorted, const std::string& structure, std::size_t slab)
      : cells_(cells), borders_(borders_of(sorted, structure, slab)) {
    result_.slab = slab;
    for (std::size_t b = 0; b < borders_.size(); ++b)
      for (Point2 p : borders_[b].ring) border_at_[{p.x, p.y, sorted.slices[slab + borders_[b].upper].z}] = b;
    outside_ = borders_.size();
  }

  JudgedSlab judge(const std::vector<Link>& links, const std::optional<std::vector<VoidLink>>& void_links) {
    find_regions();
    const std::set<Edge> edges = edges_of(links);
    result_.found = {long(cells_.pieces), cells_.handles, cells_.bubbles};
    result_.manifold = cells_.manifold;
    if (!cells_.manifold) fault("is no manifold");
    const long loops = judge_pieces(edges);
    judge_hollows(void_links);
    result_.unlinked_hole = some_unlinked_hole();
    result_.expected.handles = loops + present_holes() - hollows_;
    if (result_.found.handles > result_.expected.handles)
      fault("has a handle too many", result_.found.handles - result_.expected.handles);
    if (result_.found.handles < result_.expected.handles)
      fault("lacks a handle", result_.expected.handles - result_.found.handles);
    if (result_.found.bubbles != 0) fault("has a bubble", result_.found.bubbles);
    return result_;
  }

 private:
  void fault(const std::string& what, long times = 1) {
    result_.faults.push_back(times == 1 ? what : what + ", " + std::to_string(times) + " times");
  }

  std::string words(std::size_t border) const {
    if (border == outside_) return "the outside";
    return std::string(borders_[border].upper ? "upper" : "lower") + " contour " +
           std::to_string(borders_[border].number);
  }

  std::size_t border_number(bool upper, std::size_t number) const {
    for (std::size_t b = 0; b < borders_.size(); ++b)
      if (borders_[b].upper == upper && borders_[b].number == number) return b;
    return none;
  }

  /// Which regions the slab's tetrahedra stand on, in whole, and which piece does.
  void find_regions() {
    std::vector<std::set<SlabCells::Place>> seen(borders_.size());
    for (const auto& [place, piece] : cells_.piece_at) {
      const auto at = border_at_.find(place);
      if (at == border_at_.end()) continue;
      seen[at->second].insert(place);
      borders_[at->second].present = true;
      pieces_on_[borders_[at->second].region].insert(piece);
    }
    for (std::size_t b = 0; b < borders_.size(); ++b) {
      const Border& outer = borders_[borders_[b].region];
      if ((borders_[b].present && seen[b].size() != borders_[b].ring.size()) || borders_[b].present != outer.present)
        fault("carries a region in part, that of " + words(b));
    }
  }

  /// The links as pairs of regions, which count as present whatever carries them: overhangs may have been trimmed in
  /// part or in whole.
  std::set<Edge> edges_of(const std::vector<Link>& links) {
    std::set<Edge> edges;
    for (const Link& link : links) {
      const std::size_t a = border_number(false, link.lower), b = border_number(true, link.upper);
      if (a == none || b == none || borders_[a].hole || borders_[b].hole) {
        fault("has a link that names no region");
        continue;
      }
      edges.emplace(a, b);
      for (std::size_t region : {a, b})
        if (!borders_[region].present) fault("has nothing on a linked region, that of " + words(region));
    }
    for (const auto& [a, b] : edges) linked_.insert({a, b});
    for (Border& border : borders_) border.present = border.present || linked_.count(border.region) > 0;
    return edges;
  }

  /// Compares pieces with the linked regions. Returns the links' loops.
  long judge_pieces(const std::set<Edge>& edges) {
    Joined joined(borders_.size());
    for (const auto& [a, b] : edges) joined.join(a, b);
    std::map<std::size_t, std::set<std::size_t>> parts_on, pieces_of;  // by piece; by part of the graph
    long regions = 0;
    for (std::size_t r = 0; r < borders_.size(); ++r) {
      if (borders_[r].hole || !borders_[r].present) continue;
      ++regions;
      const std::size_t part = joined.find(r);
      pieces_of[part];
      for (std::size_t piece : pieces_on_[r]) {
        parts_on[piece].insert(part);
        pieces_of[part].insert(piece);
      }
    }
    for (const auto& [piece, parts] : parts_on)
      if (parts.size() > 1)
        fault("joins what no link joins, " + words(*parts.begin()) + " and " + words(*parts.rbegin()));
    for (const auto& [part, pieces] : pieces_of)
      if (pieces.size() > 1)
        fault("is in " + std::to_string(pieces.size()) + " pieces where links join one, that of " + words(part));
    if (parts_on.size() < cells_.pieces) fault("has a piece that holds no region");
    result_.expected.pieces = long(pieces_of.size());
    return long(edges.size()) - regions + long(pieces_of.size());
  }

  long present_holes() const {
    return std::count_if(borders_.begin(), borders_.end(), [](const Border& b) { return b.hole && b.present; });
  }

  /// The void region within (of a hole) or round (of an outer contour) a border: a hole of a region that is there, or
  /// the outside.
  std::size_t void_beside(std::size_t border) const {
    std::size_t at = borders_[border].hole ? border : borders_[border].parent;
    while (at != none && !(borders_[at].hole && borders_[at].present)) at = borders_[at].parent;
    return at == none ? outside_ : at;
  }

  /// The holes of plates open into the void round them: a plate ends freely between the slices.
  void open_plates(Joined& implied) const {
    for (std::size_t b = 0; b < borders_.size(); ++b)
      if (borders_[b].hole && borders_[b].present && linked_.count(borders_[b].region) == 0)
        implied.join(b, void_beside(borders_[b].region));
  }

  bool some_unlinked_hole() const {
    return std::any_of(borders_.begin(), borders_.end(),
                       [&](const Border& b) { return b.hole && b.present && linked_.count(b.region) == 0; });
  }

  Joined found_hollows() {
    Joined found(borders_.size() + 1);
    std::map<std::size_t, std::size_t> void_of_wall;
    for (const auto& [place, wall] : cells_.wall_at) {
      const auto at = border_at_.find(place);
      if (at == border_at_.end()) continue;
      const std::size_t here = void_beside(at->second);
      found.join(here, void_of_wall.emplace(wall, here).first->second);
    }
    return found;
  }

  /// Compares which void regions are joined. Counts the hollows that do not reach the outside, by the links.
  void judge_hollows(const std::optional<std::vector<VoidLink>>& void_links) {
    const Joined found = found_hollows();
    Joined implied(borders_.size() + 1);
    open_plates(implied);
    if (void_links)
      for (const VoidLink& link : *void_links) {
        std::array<std::size_t, 2> ends{outside_, outside_};
        for (bool upper : {false, true})
          if (const auto& number = upper ? link.upper : link.lower) ends[upper] = border_number(upper, *number);
        if (std::any_of(ends.begin(), ends.end(),
                        [&](std::size_t e) { return e == none || (e != outside_ && !borders_[e].hole); })) {
          fault("has a void link that names no hole");
          continue;
        }
        for (std::size_t& end : ends)
          if (end != outside_) end = void_beside(end);
        implied.join(ends[0], ends[1]);
      }
    const Joined& wanted = void_links ? implied : found;
    std::set<std::size_t> closed;
    std::vector<std::size_t> voids{outside_};
    for (std::size_t b = 0; b < borders_.size(); ++b)
      if (borders_[b].hole && borders_[b].present) {
        if (wanted.find(b) != wanted.find(outside_)) closed.insert(wanted.find(b));
        for (std::size_t other : voids) {
          const bool linked = wanted.find(b) == wanted.find(other), open = found.find(b) == found.find(other);
          if (linked && !open) fault("closes what a void link joins, " + words(b) + " and " + words(other));
          if (!linked && open) fault("opens what no void link joins, " + words(b) + " and " + words(other));
        }
        voids.push_back(b);
      }
    hollows_ = long(closed.size());
  }

  const SlabCells& cells_;
  std::vector<Border> borders_;
  std::map<SlabCells::Place, std::size_t> border_at_;
  std::map<std::size_t, std::set<std::size_t>> pieces_on_;  // by region
  std::set<std::size_t> linked_;                            // regions
  std::size_t outside_ = 0;
  long hollows_ = 0;
  JudgedSlab result_;
};

}  // namespace

std::vector<JudgedSlab> slab_topology(const Solid& solid, const ContourStack& stack, const std::vector<Link>& links,
                                      const std::optional<std::vector<VoidLink>>& void_links) {
  ContourStack sorted = stack;
  std::sort(sorted.slices.begin(), sorted.slices.end(), [](const Slice& a, const Slice& b) { return a.z < b.z; });
  const std::vector<SlabCells> cells = cells_by_slab(solid.tetrahedra, sorted);
  std::vector<JudgedSlab> result;
  for (std::size_t slab = 0; slab < cells.size(); ++slab) {
    const auto here = [&](const auto& all) {
      auto some = all;
      std::erase_if(some, [&](const auto& link) { return link.structure != solid.structure || link.slice != slab; });
      return some;
    };
    const auto voids_here = void_links ? std::optional(here(*void_links)) : std::nullopt;
    result.push_back(SlabJudge(cells[slab], sorted, solid.structure, slab).judge(here(links), voids_here));
  }
  return result;
}

TopologyVerdict judge_topology(const Reconstruction& result, const ContourStack& stack) {
  std::vector<Link> links;
  for (const MadeLink& made : result.links) links.push_back(made.link);
  std::vector<VoidLink> voids;
  for (const MadeVoidLink& made : result.void_links)
    voids.push_back({made.structure, made.slice, made.lower, made.upper});
  std::map<std::pair<std::string, std::size_t>, const SlabTopology*> told;
  for (const SlabTopology& slab : result.topology) told[{slab.structure, slab.slice}] = &slab;
  TopologyVerdict verdict;
  const auto count = [](const Topology& t) { return SlabCount{t.pieces, t.handles, t.bubbles}; };
  for (const Solid& solid : result.solids)
    for (const JudgedSlab& slab : slab_topology(solid, stack, links, voids)) {
      const std::string where = solid.structure + ", slab " + std::to_string(slab.slab) + ": ";
      for (const std::string& fault : slab.faults) verdict.not_as_implied.push_back(where + fault);
      const auto known = told.find({solid.structure, slab.slab});
      if (known == told.end()) {
        if (slab.found.pieces > 0) verdict.untrue.push_back(where + "the result does not tell its topology");
        continue;
      }
      if (count(known->second->found) != slab.found)
        verdict.untrue.push_back(where + "found " + in_words(slab.found) + ", told are " +
                                 in_words(count(known->second->found)));
      const bool may_close = known->second->interpolated > 0 && slab.unlinked_hole;
      if (!may_close && count(known->second->implied) != slab.expected)
        verdict.untrue.push_back(where + "implied are " + in_words(slab.expected) + ", told are " +
                                 in_words(count(known->second->implied)));
    }
  return verdict;
}

}  // namespace odontoscope::test
