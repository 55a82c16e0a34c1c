#include "recon/between/joined.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "recon/between/grow.h"
#include "recon/between/layer_stack.h"
#include "recon/between/traced.h"
#include "recon/core/limits.h"

namespace odontoscope::between {
namespace {

bool wanted(const LayerStack& stack, std::size_t voxel) { return stack.field[voxel] < 0; }

std::size_t mismatches(const LayerStack& stack) {
  std::size_t count = 0;
  for (std::size_t v = stack.layer_size(); v < stack.material.size() - stack.layer_size(); ++v)
    count += (stack.material[v] != 0) != wanted(stack, v);
  return count;
}

/// Gives back what is not needed, and takes what that allows.
void settle(Grower& grower) {
  for (int round = 0; round < limits::join_settling_rounds; ++round) {
    grower.give_back();
    grower.grow(0);
  }
}

/// Grown with as few voxels against the fields as was found: where a join would be cut although the gap beside it could
/// be filled at less cost, growing over the field's zero and giving back does that.
void grow(LayerStack& stack, const RegionGraph& graph, double step) {
  Grower grower(stack, graph, step);
  grower.grow(0);
  grower.grow_until_joined();
  LayerStack flooded = stack;
  Grower flood(flooded, graph, step);
  flood.restore(stack, grower);
  settle(grower);
  std::size_t least = mismatches(stack);
  for (const double steps : limits::join_flood_steps) {
    if (least == 0) return;
    flood.grow(steps * step);
    LayerStack tried = flooded;
    Grower settling(tried, graph, step);
    settling.restore(flooded, flood);
    settle(settling);
    const std::size_t count = mismatches(tried);
    if (count >= least || topology_of(tried) != graph.implied) continue;
    least = count;
    stack = std::move(tried);
  }
}

double height_of(const SliceSet& slices, double share) {
  return slices.z[at_lower] + share * (slices.z[at_upper] - slices.z[at_lower]);
}

/// Connected voxels of one kind that are not as their field wants them.
std::vector<Correction> corrections_of(const LayerStack& stack, const SliceSet& slices, const Grid& grid,
                                       std::span<const double> shares) {
  std::vector<double> z{slices.z[at_lower]};
  for (const double share : shares) z.push_back(height_of(slices, share));
  z.push_back(slices.z[at_upper]);
  std::vector<bool> seen(stack.material.size(), false);
  std::vector<Correction> result;
  const auto differs = [&](std::size_t v, bool solid) {
    return stack.free(v) && !seen[v] && (stack.material[v] != 0) == solid && wanted(stack, v) != solid;
  };
  for (std::size_t first = 0; first < stack.material.size(); ++first) {
    const bool solid = stack.material[first] != 0;
    if (!differs(first, solid)) continue;
    Correction& item = result.emplace_back();
    item.kind = solid ? Correction::Kind::filled : Correction::Kind::cut;
    std::vector<std::size_t> piece{first};
    seen[first] = true;
    for (std::size_t n = 0; n < piece.size(); ++n) {
      const auto index = static_cast<std::ptrdiff_t>(piece[n]);
      const std::ptrdiff_t i = index % stack.columns, j = index / stack.columns % stack.rows;
      const auto k = static_cast<std::size_t>(stack.layer_of(piece[n]));
      const double volume = grid.step * grid.step * (z[k + 1] - z[k - 1]) / 2;
      item.volume += volume;
      item.place.x += volume * (grid.anchor.x + grid.step * static_cast<double>(stack.first_i + i));
      item.place.y += volume * (grid.anchor.y + grid.step * static_cast<double>(stack.first_j + j));
      item.place.z += volume * z[k];
      for (int bit = 0; bit < 27; ++bit) {
        const std::size_t there = stack.neighbour(piece[n], bit);
        if (!differs(there, solid)) continue;
        seen[there] = true;
        piece.push_back(there);
      }
    }
    item.place = {item.place.x / item.volume, item.place.y / item.volume, item.place.z / item.volume};
  }
  return result;
}

/// One layer's labels as a window, its values turned where the labels say otherwise.
Window window_of(const LayerStack& stack, std::ptrdiff_t k) {
  Window window{stack.first_i, stack.first_j, stack.columns, stack.rows, {}};
  const auto from = stack.field.begin() + k * stack.columns * stack.rows;
  window.values.assign(from, from + stack.columns * stack.rows);
  for (std::size_t p = 0; p < window.values.size(); ++p) {
    const bool solid = stack.material[static_cast<std::size_t>(k) * stack.layer_size() + p] != 0;
    if (solid != (window.values[p] < 0)) window.values[p] = solid ? -far_outside : far_outside;
  }
  return window;
}

/// Contours of neighbouring layers pass each other between two grid points if material and void lie crosswise there;
/// then they keep to their own halves, so that void is one across and material is not, as the voxels have it.
class Crossings {
 public:
  Crossings(const LayerStack& stack, std::ptrdiff_t k) : stack_(stack), k_(k) {}

  double operator()(std::size_t material, std::size_t hollow, double interpolated) const {
    const double turned =
        std::abs(value(k_, material)) >= far_outside || wrong(material) || wrong(hollow) ? 0.5 : interpolated;
    double fraction = turned;
    for (const std::ptrdiff_t k : {k_ - 1, k_ + 1}) {
      if (solid(k, material) || !solid(k, hollow)) continue;
      double theirs = 1 - limits::join_crosswise;  // where their material begins
      if (k == 0 || k == stack_.layers - 1) {
        const double in = value(k, hollow), out = value(k, material);
        theirs = (1 - in / (in - out)) * 2 * limits::join_crosswise;
      }
      fraction = std::min({fraction, limits::join_crosswise, theirs});
    }
    return fraction;
  }

 private:
  std::size_t voxel(std::ptrdiff_t k, std::size_t p) const {
    return static_cast<std::size_t>(k) * stack_.layer_size() + p;
  }
  bool solid(std::ptrdiff_t k, std::size_t p) const { return stack_.material[voxel(k, p)] != 0; }
  double value(std::ptrdiff_t k, std::size_t p) const { return stack_.field[voxel(k, p)]; }
  bool wrong(std::size_t p) const { return solid(k_, p) != (value(k_, p) < 0); }

  const LayerStack& stack_;
  std::ptrdiff_t k_;
};

/// For each piece of a layer the contour that it is known by: outer ones for material, holes for void.
using ContourOfPiece = std::map<std::uint32_t, std::size_t>;

ContourOfPiece given_contours(const LayerStack& stack, const std::vector<std::uint32_t>& pieces, std::ptrdiff_t k,
                              RegionId first, RegionId outside_region) {
  ContourOfPiece result;
  for (std::size_t p = 0; p < stack.layer_size(); ++p) {
    const std::size_t voxel = static_cast<std::size_t>(k) * stack.layer_size() + p;
    const RegionId region = stack.region[voxel];
    result.emplace(pieces[voxel], region == outside_region ? outside : region - first);
  }
  return result;
}

ContourOfPiece traced_contours(const LayerStack& stack, const std::vector<std::uint32_t>& pieces, std::ptrdiff_t k,
                               const Slice& slice, const Grid& grid) {
  ContourOfPiece result;
  result.emplace(pieces[stack.at(0, 0, k)], outside);
  for (std::size_t c = 0; c < slice.contours.size(); ++c) {
    const bool is_hole = !facts_of({slice.contours[c].points}).front().outer();
    const GridPoint beside = beside_first_point(slice.contours[c].points, grid, is_hole);
    result.emplace(pieces[stack.at(beside.i - stack.first_i, beside.j - stack.first_j, k)], c);
  }
  return result;
}

std::vector<LayerLinks> links_between(const LayerStack& stack, const std::vector<std::uint32_t>& pieces,
                                      const std::vector<ContourOfPiece>& contours) {
  std::vector<LayerLinks> result;
  for (std::ptrdiff_t k = 0; k + 1 < stack.layers; ++k) {
    std::set<std::pair<std::size_t, std::size_t>> material, voids;
    for (std::size_t p = 0; p < stack.layer_size(); ++p) {
      const std::size_t a = static_cast<std::size_t>(k) * stack.layer_size() + p, b = a + stack.layer_size();
      if (stack.material[a] != stack.material[b]) continue;
      const std::size_t lower = contours[static_cast<std::size_t>(k)].at(pieces[a]);
      const std::size_t upper = contours[static_cast<std::size_t>(k) + 1].at(pieces[b]);
      if (lower == outside && upper == outside) continue;
      (stack.material[a] ? material : voids).insert({lower, upper});
    }
    LayerLinks& links = result.emplace_back();
    for (const auto& [a, b] : material) links.material.push_back({a, b});
    for (const auto& [a, b] : voids) links.voids.push_back({a, b});
  }
  return result;
}

struct Sampled {
  Grid grid;
  LayerStack stack;
  bool resolved = false;
};

/// On the coarsest grid, from the usual one on, that shows every region of both slices as one piece, or else the
/// finest.
std::optional<Sampled> sampled(const SliceSet& slices, const BlendPlan& plan, std::span<const double> shares,
                               const JoinOptions& options) {
  std::optional<Grid> grid = grid_for(slices, options.blend.most_grid_points);
  if (!grid) return std::nullopt;
  bool resolved = resolves(slices, *grid);
  while (!resolved) {
    const std::optional<Grid> next = finer(*grid, slices, options.most_grid_points);
    if (!next) break;
    grid = next;
    resolved = resolves(slices, *grid);
  }
  auto stack = sampled_layers(slices, Composition(slices, plan, *grid), *grid, shares);
  if (!stack) return std::nullopt;
  return Sampled{*grid, std::move(*stack), resolved};
}

}  // namespace

JoinedBlend blend_joined(const Surroundings& surroundings, std::span<const double> shares, const JoinOptions& options) {
  require_blendable(surroundings, shares);
  const SliceSet slices(surroundings);
  const BlendPlan plan = blend_plan(slices, surroundings);
  const RegionGraph graph(slices, surroundings);
  JoinedBlend result;
  result.implied = graph.implied;
  std::optional<Sampled> made;
  if (!shares.empty()) made = sampled(slices, plan, shares, options);
  if (!made) {
    result.outlines = blend(surroundings, shares, options.blend);
    return result;
  }
  LayerStack& stack = made->stack;
  grow(stack, graph, made->grid.step);
  result.resolved = made->resolved;
  result.found = topology_of(stack);
  result.corrections = corrections_of(stack, slices, made->grid, shares);
  std::size_t count = 0;
  const std::vector<std::uint32_t> pieces = pieces_of_layers(stack, count);
  const double tolerance = options.blend.thinning * slices.larger_side();
  const std::size_t enough = std::max(points_in(*surroundings.lower), points_in(*surroundings.upper));
  std::vector<ContourOfPiece> contours{given_contours(stack, pieces, 0, 0, graph.outside_region())};
  for (std::ptrdiff_t k = 1; k + 1 < stack.layers; ++k) {
    const Slice slice = traced(window_of(stack, k), made->grid, {true, Crossings(stack, k)});
    contours.push_back(traced_contours(stack, pieces, k, slice, made->grid));
    result.outlines.push_back(thinned(slice, tolerance, limits::join_thinning_steps * made->grid.step, enough));
  }
  contours.push_back(
      given_contours(stack, pieces, stack.layers - 1, static_cast<RegionId>(graph.lower), graph.outside_region()));
  result.links = links_between(stack, pieces, contours);
  return result;
}

}  // namespace odontoscope::between
