#include "recon/delaunay/look_here.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "recon/core/limits.h"
#include "recon/core/portable_math.h"
#include "recon/delaunay/difference_place.h"
#include "recon/delaunay/strands.h"
#include "recon/delaunay/verdict.h"

namespace odontoscope::delaunay {
namespace {

constexpr std::size_t most_options_told = 4;

std::string counted(long count, const char* singular, const char* plural) {
  return fmt::format("{} {}", count, count == 1 ? singular : plural);
}

/// "2 pieces where contours and links imply 1", of what differs.
std::string difference_in_words(const Topology& implied, const Topology& found) {
  std::string words;
  const auto add = [&words](long is, long should, const char* singular, const char* plural) {
    if (is == should) return;
    words += fmt::format("{}{} where contours and links imply {}", words.empty() ? "" : ", ",
                         counted(is, singular, plural), should);
  };
  add(found.pieces, implied.pieces, "piece", "pieces");
  add(found.handles, implied.handles, "handle", "handles");
  add(found.bubbles, implied.bubbles, "bubble", "bubbles");
  return words;
}

class Look {
 public:
  Look(const Reconstruction& made, const ContourStack& ordered, const ReconstructOptions& options)
      : made_(made), ordered_(ordered), options_(options) {
    for (const SlabTopology& slab : made.topology) slab_of_[{slab.structure, slab.slice}] = &slab;
  }

  std::vector<Attention> run() {
    std::map<std::string, std::size_t> order;
    for (const Solid& solid : made_.solids) {
      order.emplace(solid.structure, order.size());
      look_at_slabs(solid.structure);
      look_at_shut_voids(solid.structure, look_at_ends(solid.structure, Strands::Of::voids));
      look_at_loose_pieces(solid, look_at_ends(solid.structure, Strands::Of::material));
    }
    for (const Doubt& doubt : made_.doubts) look_at_doubt(doubt);
    std::stable_sort(found_.begin(), found_.end(), [&order](const Attention& a, const Attention& b) {
      return std::tuple(a.kind, order[a.structure], a.slice) < std::tuple(b.kind, order[b.structure], b.slice);
    });
    return std::move(found_);
  }

 private:
  Attention item(AttentionKind kind, const std::string& structure, std::size_t slice, std::size_t last_slice) const {
    Attention one;
    one.kind = kind;
    one.structure = structure;
    one.slice = slice;
    one.last_slice = last_slice;
    one.z_lower = ordered_.slices[slice].z;
    one.z_upper = ordered_.slices[last_slice].z;
    const std::size_t slab = std::min(slice, ordered_.slices.size() - 2);
    if (const auto known = slab_of_.find({structure, slab}); known != slab_of_.end()) {
      one.expected = known->second->implied;
      one.found = known->second->found;
    }
    return one;
  }

  // ---- slabs --------------------------------------------------------------------------------------------------------

  void look_at_slabs(const std::string& structure) {
    for (const SlabTopology& slab : made_.topology) {
      if (slab.structure != structure || slab.as_implied()) continue;
      Attention one = item(AttentionKind::topology, structure, slab.slice, slab.slice + 1);
      one.place = slab.place;
      one.found = slab.untrimmed.value_or(slab.found);
      one.seen = fmt::format("the solid between the two has {}.", difference_in_words(slab.implied, one.found));
      one.remedy = options_.between == Between::delaunay ? "--between blended looks for the solid that they imply."
                                                         : "A slice between the two would tell.";
      found_.push_back(std::move(one));
    }
  }

  // ---- ends ---------------------------------------------------------------------------------------------------------

  /// The pieces that an item was made of.
  struct Ends {
    Strands strands;
    std::set<std::uint32_t> told;
  };

  Ends look_at_ends(const std::string& structure, Strands::Of what) {
    Ends ends{Strands(made_, ordered_, structure, what), {}};
    std::vector<Link> links;
    for (const Link& link : options_.links)
      if (link.structure == structure && what == Strands::Of::material) links.push_back(link);
    for (const std::vector<FacingEnds>& group : ends.strands.facing(links)) {
      found_.push_back(facing_item(structure, what, ends.strands.sections(), group));
      for (const FacingEnds& pair : group)
        for (const std::size_t section : {pair.lower, pair.upper}) ends.told.insert(ends.strands.piece(section));
    }
    return ends;
  }

  Attention facing_item(const std::string& structure, Strands::Of what, const std::vector<Section>& sections,
                        const std::vector<FacingEnds>& group) const {
    const Section& lower = sections[group.front().lower];
    const Section& upper = sections[group.front().upper];
    const bool material = what == Strands::Of::material;
    Attention one = item(material ? AttentionKind::gap : AttentionKind::void_gap, structure, lower.slice, upper.slice);
    one.place = {(lower.centre.x + upper.centre.x) / 2, (lower.centre.y + upper.centre.y) / 2,
                 (one.z_lower + one.z_upper) / 2};
    one.seen = facing_in_words(material ? "piece" : "void", lower, upper, group);
    if (!material) {
      one.remedy = void_remedy(group.front());
      return one;
    }
    for (const FacingEnds& pair : group)
      one.links.push_back({structure, lower.slice, sections[pair.lower].contour, sections[pair.upper].contour, true});
    one.remedy = link_remedy(one.links);
    return one;
  }

  static std::string facing_in_words(const char* thing, const Section& lower, const Section& upper,
                                     const std::vector<FacingEnds>& group) {
    if (group.size() > 1)
      return fmt::format("{}s end in slice {} and others begin in slice {}: {} ways to go on, and nothing says which.",
                         thing, lower.slice, upper.slice, group.size());
    const std::string aside = fmt::format("{:.2g} mm aside", group.front().aside);
    if (!lower.linked_above && !upper.linked_below)
      return fmt::format("a {} ends in slice {} and another begins in slice {}, {}: one that goes on, or two.", thing,
                         lower.slice, upper.slice, aside);
    const bool ends = !lower.linked_above;
    return fmt::format(
        "a {} {} in slice {}, and in slice {} lies, partly over it and {}, another that it is not joined with.", thing,
        ends ? "ends" : "begins", ends ? lower.slice : upper.slice, ends ? upper.slice : lower.slice, aside);
  }

  static std::string link_remedy(const std::vector<Link>& links) {
    Link apart = links.front();
    apart.connect = false;
    if (links.size() == 1)
      return fmt::format("If it is one, add {}; if two, {}.", option_for(links.front()), option_for(apart));
    std::string options;
    for (std::size_t i = 0; i < std::min(links.size(), most_options_told); ++i)
      options += (i > 0 ? ", " : "") + option_for(links[i]);
    if (links.size() > most_options_told)
      options += fmt::format(" and {} more in the report", links.size() - most_options_told);
    return fmt::format("Choose from {}; --unlink keeps a pair apart.", options);
  }

  std::string void_remedy(const FacingEnds& pair) const {
    if (pair.gap == 0 && options_.correspondence != Correspondence::overlap)
      return fmt::format("--correspondence overlap{} joins voids that lie partly over each other.",
                         options_.between == Between::delaunay ? " --between blended" : "");
    return "Links are made between regions, not voids: a slice between the two, with the canal in it, would tell.";
  }

  /// Voids that reach neither the outside nor the largest of those that are shut in.
  void look_at_shut_voids(const std::string& structure, Ends ends) {
    const std::vector<Section>& sections = ends.strands.sections();
    struct HollowRun {
      std::size_t first = 0, last = 0;  // sections
      double area = 0;
      bool open = false;
    };
    std::map<std::uint32_t, HollowRun> pieces;
    for (std::size_t s = 0; s < sections.size(); ++s) {
      HollowRun& piece = pieces.try_emplace(ends.strands.piece(s), HollowRun{s, s, 0, false}).first->second;
      piece.last = s;
      piece.area += sections[s].area;
      piece.open = piece.open || sections[s].open;
    }
    double largest = 0;
    for (const auto& [number, piece] : pieces) largest = std::max(largest, piece.area);
    for (const auto& [number, piece] : pieces) {
      if (piece.open || piece.area == largest || ends.told.contains(number)) continue;
      const Section& low = sections[piece.first];
      const Section& high = sections[piece.last];
      Attention one = item(AttentionKind::void_gap, structure, low.slice, high.slice);
      one.place = {(low.centre.x + high.centre.x) / 2, (low.centre.y + high.centre.y) / 2,
                   (one.z_lower + one.z_upper) / 2};
      one.seen = "a void is shut in: it reaches neither the outside nor the largest void of the structure.";
      one.remedy = "If it is a canal, a slice that shows where it goes on would tell.";
      found_.push_back(std::move(one));
    }
  }

  // ---- doubts -------------------------------------------------------------------------------------------------------

  void look_at_doubt(const Doubt& doubt) {
    const bool material = doubt.kind == DoubtKind::may_connect || doubt.kind == DoubtKind::may_part;
    const bool joined = doubt.kind == DoubtKind::may_part || doubt.kind == DoubtKind::void_may_part;
    Attention one = item(AttentionKind::choice, doubt.structure, doubt.slab, doubt.slab + 1);
    one.place = doubt.place;
    if (!material || !doubt.lower || !doubt.upper) {
      if (told_there(one)) return;
      one.seen = joined ? "a void goes on from one to the other, and may be two that end blind."
                        : "a void ends in one and begins in the other, and may be one canal.";
      one.remedy = "Links are made between regions, not voids: a slice between the two would tell.";
      found_.push_back(std::move(one));
      return;
    }
    const Link pair{doubt.structure, doubt.slab, *doubt.lower, *doubt.upper, !joined};
    if (decided(pair) || told_there(one)) return;
    one.links.push_back(pair);
    one.seen = fmt::format("contours {} and {} are {}joined, and may be {}.", *doubt.lower, *doubt.upper,
                           joined ? "" : "not ", joined ? "two things" : "one thing");
    Link kept = pair;
    kept.connect = joined;
    one.remedy = fmt::format("If so, add {}; if not, {}.", option_for(pair), option_for(kept));
    found_.push_back(std::move(one));
  }

  /// Whether the user's own links say what becomes of a pair.
  bool decided(const Link& pair) const {
    return std::any_of(options_.links.begin(), options_.links.end(), [&pair](const Link& link) {
      return std::tie(link.structure, link.slice, link.lower, link.upper) ==
             std::tie(pair.structure, pair.slice, pair.lower, pair.upper);
    });
  }

  /// Whether a gap between the same slices, within its own height, is told already.
  bool told_there(const Attention& one) const {
    const double near = one.z_upper - one.z_lower;
    return std::any_of(found_.begin(), found_.end(), [&](const Attention& other) {
      return other.structure == one.structure && other.slice == one.slice && other.kind != AttentionKind::topology &&
             portable::hypot(other.place.x - one.place.x, other.place.y - one.place.y) <= near;
    });
  }

  // ---- loose pieces -------------------------------------------------------------------------------------------------

  struct Extent {
    std::size_t first = 0, last = 0;  // sections: the lowest and the highest
    std::size_t slices(const std::vector<Section>& sections) const {
      return sections[last].slice - sections[first].slice + 1;
    }
  };

  void look_at_loose_pieces(const Solid& solid, Ends ends) {
    const std::vector<Section>& sections = ends.strands.sections();
    std::map<std::uint32_t, Extent> pieces;
    for (std::size_t s = 0; s < sections.size(); ++s)
      pieces.try_emplace(ends.strands.piece(s), Extent{s, s}).first->second.last = s;
    const bool any_tall = std::any_of(pieces.begin(), pieces.end(), [&](const auto& piece) {
      return piece.second.slices(sections) > limits::loose_slices;
    });
    std::vector<Extent> loose;
    for (const auto& [piece, extent] : pieces) {
      const std::size_t slices = extent.slices(sections);
      if ((slices == 1 || (any_tall && slices <= limits::loose_slices)) && !ends.told.contains(piece))
        loose.push_back(extent);
    }
    if (loose.empty()) return;
    const std::vector<double> volumes = volumes_of(solid.tetrahedra, sections, loose);
    for (std::size_t i = 0; i < loose.size(); ++i) {
      const Section& low = sections[loose[i].first];
      const Section& high = sections[loose[i].last];
      Attention one = item(AttentionKind::loose_piece, solid.structure, low.slice, high.slice);
      one.place = {(low.centre.x + high.centre.x) / 2, (low.centre.y + high.centre.y) / 2,
                   (one.z_lower + one.z_upper) / 2};
      one.seen =
          low.slice == high.slice
              ? fmt::format("contour {} is linked to nothing below or above and became a thin plate of {:.2g} mm^3.",
                            low.contour, volumes[i])
              : fmt::format("a loose piece of {:.2g} mm^3 that only {} slices hold.", volumes[i],
                            loose[i].slices(sections));
      found_.push_back(std::move(one));
    }
  }

  /// Of the solid's pieces that hold these, each found by the first point of its lowest contour, which is a corner of
  /// the solid bit by bit.
  std::vector<double> volumes_of(const TetraMesh& mesh, const std::vector<Section>& sections,
                                 const std::vector<Extent>& pieces) const {
    UnionFind joined(mesh.points.size());
    for (const Tetrahedron& tet : mesh.tetrahedra)
      for (const PointIndex v : tet) joined.join(tet[0], v);
    using Place = std::tuple<double, double, double>;
    std::map<Place, std::size_t> wanted;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Section& low = sections[pieces[i].first];
      wanted[{low.ring->front().x, low.ring->front().y, ordered_.slices[low.slice].z}] = i;
    }
    std::map<std::uint32_t, std::size_t> piece_of;
    for (std::uint32_t p = 0; p < mesh.points.size(); ++p)
      if (const auto at = wanted.find({mesh.points[p].x, mesh.points[p].y, mesh.points[p].z}); at != wanted.end())
        piece_of[joined.find(p)] = at->second;
    std::vector<double> volumes(pieces.size(), 0);
    for (const Tetrahedron& tet : mesh.tetrahedra)
      if (const auto at = piece_of.find(joined.find(tet[0])); at != piece_of.end())
        volumes[at->second] += mass_of(mesh.points, {tet}).volume;
    return volumes;
  }

  const Reconstruction& made_;
  const ContourStack& ordered_;
  const ReconstructOptions& options_;
  std::map<std::pair<std::string, std::size_t>, const SlabTopology*> slab_of_;
  std::vector<Attention> found_;
};

}  // namespace

std::vector<Attention> places_to_look_at(const Reconstruction& made, const ContourStack& ordered,
                                         const ReconstructOptions& options) {
  return Look(made, ordered, options).run();
}

}  // namespace odontoscope::delaunay
