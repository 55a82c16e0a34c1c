#include "recon/between/layer_stack.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "recon/core/limits.h"
#include "recon/core/union_find.h"

namespace odontoscope::between {
namespace {

constexpr std::uint32_t no_piece = std::numeric_limits<std::uint32_t>::max();

/// Regions of one given slice on the raster, contour by contour from outside in.
std::vector<RegionId> painted(const SliceSet& slices, std::size_t slice, const Lattice& lattice, RegionId first,
                              RegionId outside_region) {
  const std::vector<ContourFacts>& facts = slices.facts[slice];
  std::vector<std::size_t> order(facts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&facts](std::size_t a, std::size_t b) {
    return std::abs(facts[a].area) > std::abs(facts[b].area);
  });
  std::vector<RegionId> region(lattice.size(), outside_region);
  for (const std::size_t c : order) {
    const std::vector<std::uint8_t> mask = inside_mask(lattice, {(*slices.outlines[slice])[c]});
    for (std::size_t p = 0; p < mask.size(); ++p) {
      if (mask[p]) region[p] = first + static_cast<RegionId>(c);
    }
  }
  return region;
}

void join_within_layers(const LayerStack& stack, UnionFind& sets) {
  for (std::ptrdiff_t k = 0; k < stack.layers; ++k) {
    for (std::ptrdiff_t j = 0; j < stack.rows; ++j) {
      for (std::ptrdiff_t i = 0; i < stack.columns; ++i) {
        const std::size_t here = stack.at(i, j, k);
        const auto join = [&](std::ptrdiff_t di, std::ptrdiff_t dj) {
          if (i + di < 0 || i + di >= stack.columns || j + dj >= stack.rows) return;
          const std::size_t there = stack.at(i + di, j + dj, k);
          const bool diagonal = di != 0 && dj != 0;
          if (stack.material[here] != stack.material[there] || (diagonal && stack.material[here])) return;
          sets.join(static_cast<std::uint32_t>(here), static_cast<std::uint32_t>(there));
        };
        join(1, 0);
        join(0, 1);
        join(1, 1);
        join(-1, 1);
      }
    }
  }
}

/// For each piece of a layer its region and size.
struct Piece {
  RegionId region = 0;
  std::ptrdiff_t layer = 0;
  std::size_t size = 0;
};

/// By piece, of both given layers; pieces of others have no size. Each piece lies in one region, as long as contours
/// part the grid's points as they part the plane; where two regions fall together, the piece is given the first one.
std::vector<Piece> given_pieces(const LayerStack& stack, const std::vector<std::uint32_t>& pieces, std::size_t count) {
  std::vector<Piece> result(count);
  for (const std::ptrdiff_t k : {std::ptrdiff_t{0}, stack.layers - 1}) {
    for (std::size_t p = 0; p < stack.layer_size(); ++p) {
      const std::size_t voxel = static_cast<std::size_t>(k) * stack.layer_size() + p;
      Piece& piece = result[pieces[voxel]];
      if (piece.size++ == 0) piece = {stack.region[voxel], k, 1};
    }
  }
  return result;
}

/// The largest piece of each region, the outside's in the lower and, last, in the upper layer; none where there is
/// none.
std::vector<std::uint32_t> largest_pieces(const std::vector<Piece>& pieces, std::size_t regions) {
  std::vector<std::uint32_t> largest(regions + 1, no_piece);
  for (std::uint32_t n = 0; n < pieces.size(); ++n) {
    if (pieces[n].size == 0) continue;
    const bool upper_outside = pieces[n].region + 1 == regions && pieces[n].layer > 0;
    std::uint32_t& best = largest[upper_outside ? regions : pieces[n].region];
    if (best == no_piece || pieces[n].size > pieces[best].size) best = n;
  }
  return largest;
}

/// Do regions that fall together on the grid, for want of points between them, make one piece?
bool falls_together(const LayerStack& stack, const std::vector<std::uint32_t>& pieces,
                    const std::vector<Piece>& given) {
  for (const std::ptrdiff_t k : {std::ptrdiff_t{0}, stack.layers - 1}) {
    for (std::size_t p = 0; p < stack.layer_size(); ++p) {
      const std::size_t voxel = static_cast<std::size_t>(k) * stack.layer_size() + p;
      if (given[pieces[voxel]].region != stack.region[voxel]) return true;
    }
  }
  return false;
}

/// Turns all pieces but the largest of each region into what is around them. false: a region has none, or two are one.
bool drop_strays(LayerStack& stack, std::size_t regions) {
  for (int round = 0; round < limits::join_stray_rounds; ++round) {
    std::size_t count = 0;
    const std::vector<std::uint32_t> pieces = pieces_of_layers(stack, count);
    const std::vector<Piece> given = given_pieces(stack, pieces, count);
    const std::vector<std::uint32_t> largest = largest_pieces(given, regions);
    if (falls_together(stack, pieces, given) || std::count(largest.begin(), largest.end(), no_piece) > 0) return false;
    bool any = false;
    for (const std::ptrdiff_t k : {std::ptrdiff_t{0}, stack.layers - 1}) {
      RegionId around = stack.region[stack.at(0, 0, k)];
      for (std::size_t p = 0; p < stack.layer_size(); ++p) {
        const std::size_t voxel = static_cast<std::size_t>(k) * stack.layer_size() + p;
        const Piece& piece = given[pieces[voxel]];
        const bool upper_outside = piece.region + 1 == regions && k > 0;
        if (largest[upper_outside ? regions : piece.region] == pieces[voxel]) {
          around = stack.region[voxel];
          continue;
        }
        any = true;
        stack.material[voxel] ^= 1;
        stack.region[voxel] = around;  // the last one to the left that stays
      }
    }
    if (!any) return true;
  }
  return false;
}

LayerStack framed(const SliceSet& slices, const std::vector<Window>& windows, const Grid& grid) {
  constexpr std::ptrdiff_t free_border = 3;
  LayerStack stack;
  std::ptrdiff_t low_i = std::numeric_limits<std::ptrdiff_t>::max(), low_j = low_i, high_i = -low_i, high_j = -low_i;
  const auto take = [&](std::ptrdiff_t i, std::ptrdiff_t j) {
    low_i = std::min(low_i, i), high_i = std::max(high_i, i);
    low_j = std::min(low_j, j), high_j = std::max(high_j, j);
  };
  const auto whole = [&](double value, double anchor) {
    return static_cast<std::ptrdiff_t>(std::floor((value - anchor) / grid.step));
  };
  for (const std::size_t slice : {at_lower, at_upper}) {
    for (const ContourFacts& facts : slices.facts[slice]) {
      take(whole(facts.box.low.x, grid.anchor.x), whole(facts.box.low.y, grid.anchor.y));
      take(whole(facts.box.high.x, grid.anchor.x) + 1, whole(facts.box.high.y, grid.anchor.y) + 1);
    }
  }
  for (const Window& window : windows) {  // only what is wanted as material counts
    for (std::ptrdiff_t j = 0; j < window.rows; ++j) {
      for (std::ptrdiff_t i = 0; i < window.columns; ++i) {
        if (window.values[static_cast<std::size_t>(j * window.columns + i)] < 0)
          take(window.first_i + i, window.first_j + j);
      }
    }
  }
  stack.first_i = low_i - free_border;
  stack.first_j = low_j - free_border;
  stack.columns = high_i - low_i + 1 + 2 * free_border;
  stack.rows = high_j - low_j + 1 + 2 * free_border;
  stack.layers = static_cast<std::ptrdiff_t>(windows.size()) + 2;
  return stack;
}

}  // namespace

RegionGraph::RegionGraph(const SliceSet& slices, const Surroundings& surroundings)
    : lower(slices.facts[at_lower].size()), upper(slices.facts[at_upper].size()) {
  const std::size_t regions = lower + upper + 1;
  hollow.assign(regions, true);
  std::size_t outer = 0;
  for (std::size_t c = 0; c < lower + upper; ++c) {
    const ContourFacts& facts = c < lower ? slices.facts[at_lower][c] : slices.facts[at_upper][c - lower];
    hollow[c] = !facts.outer();
    outer += facts.outer();
  }
  const auto region = [&](std::size_t slice, std::size_t contour) {
    if (contour == outside) return outside_region();
    return static_cast<RegionId>(slice == at_lower ? contour : lower + contour);
  };
  UnionFind sets(regions);
  for (const ContourLink& link : surroundings.material)
    links.insert({region(at_lower, link.lower), region(at_upper, link.upper)});
  for (const auto& [a, b] : links) sets.join(a, b);
  for (const ContourLink& link : surroundings.voids)
    sets.join(region(at_lower, link.lower), region(at_upper, link.upper));
  void_group.resize(regions);
  void_group_size.assign(regions, 0);
  for (RegionId r = 0; r < regions; ++r) {
    void_group[r] = sets.find(r);
    if (hollow[r]) ++void_group_size[void_group[r]];
    if (void_group[r] == r) ++(hollow[r] ? implied.voids : implied.pieces);
  }
  const auto signed_count = [](std::size_t n) { return static_cast<std::ptrdiff_t>(n); };
  implied.loops = signed_count(lower + upper - outer) + signed_count(links.size()) - signed_count(outer) +
                  signed_count(implied.pieces) - signed_count(implied.voids - 1);
}

bool LayerStack::free(std::size_t voxel) const {
  const auto n = static_cast<std::ptrdiff_t>(voxel);
  const std::ptrdiff_t i = n % columns, j = n / columns % rows, k = n / (columns * rows);
  return i > 0 && j > 0 && k > 0 && i < columns - 1 && j < rows - 1 && k < layers - 1;
}

std::size_t LayerStack::neighbour(std::size_t voxel, int bit) const {
  const std::ptrdiff_t step = (bit % 3 - 1) + (bit / 3 % 3 - 1) * columns + (bit / 9 - 1) * columns * rows;
  return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(voxel) + step);
}

Neighbourhood LayerStack::around(std::size_t voxel) const {
  Neighbourhood bits = 0;
  for (int plane = 0; plane < 3; ++plane) {
    for (int line = 0; line < 3; ++line) {
      const std::uint8_t* cell = material.data() + neighbour(voxel, 9 * plane + 3 * line);
      bits |= static_cast<Neighbourhood>(cell[0] | cell[1] << 1 | cell[2] << 2) << (9 * plane + 3 * line);
    }
  }
  return bits;
}

namespace {

/// Layers over all windows with both given slices in them.
LayerStack with_given_slices(const SliceSet& slices, const std::vector<Window>& windows, const Grid& grid) {
  LayerStack stack = framed(slices, windows, grid);
  const std::size_t size = stack.layer_size() * static_cast<std::size_t>(stack.layers);
  const std::size_t lower = slices.facts[at_lower].size(), upper = slices.facts[at_upper].size();
  const auto outside_region = static_cast<RegionId>(lower + upper);
  stack.field.assign(size, far_outside);
  stack.material.assign(size, 0);
  stack.region.assign(size, outside_region);
  const Lattice lattice{{grid.anchor.x + grid.step * static_cast<double>(stack.first_i),
                         grid.anchor.y + grid.step * static_cast<double>(stack.first_j)},
                        grid.step,
                        stack.columns,
                        stack.rows};
  for (const std::size_t slice : {at_lower, at_upper}) {
    const std::size_t offset = slice == at_lower ? 0 : size - stack.layer_size();
    const RegionId first = slice == at_lower ? 0 : static_cast<RegionId>(lower);
    const std::vector<RegionId> region = painted(slices, slice, lattice, first, outside_region);
    for (std::size_t p = 0; p < region.size(); ++p) {
      stack.region[offset + p] = region[p];
      stack.material[offset + p] = region[p] != outside_region && slices.facts[slice][region[p] - first].outer();
    }
    const std::vector<double> field = signed_distances(lattice, *slices.outlines[slice]);
    std::copy(field.begin(), field.end(), stack.field.begin() + static_cast<std::ptrdiff_t>(offset));
  }
  return stack;
}

}  // namespace

bool resolves(const SliceSet& slices, const Grid& grid) {
  const LayerStack stack = with_given_slices(slices, {}, grid);
  const std::size_t regions = slices.facts[at_lower].size() + slices.facts[at_upper].size() + 1;
  std::size_t count = 0;
  const std::vector<std::uint32_t> pieces = pieces_of_layers(stack, count);
  return count == regions + 1 && !falls_together(stack, pieces, given_pieces(stack, pieces, count));
}

std::optional<LayerStack> sampled_layers(const SliceSet& slices, const Composition& composition, const Grid& grid,
                                         std::span<const double> shares) {
  std::vector<Window> windows;
  for (const double share : shares) windows.push_back(composition.at(share));
  LayerStack stack = with_given_slices(slices, windows, grid);
  const std::size_t regions = slices.facts[at_lower].size() + slices.facts[at_upper].size() + 1;
  if (!drop_strays(stack, regions)) return std::nullopt;
  for (std::size_t n = 0; n < windows.size(); ++n) {
    const Window& window = windows[n];
    const std::ptrdiff_t end_j = std::min(window.first_j + window.rows, stack.first_j + stack.rows);
    const std::ptrdiff_t end_i = std::min(window.first_i + window.columns, stack.first_i + stack.columns);
    for (std::ptrdiff_t j = std::max(window.first_j, stack.first_j); j < end_j; ++j) {
      for (std::ptrdiff_t i = std::max(window.first_i, stack.first_i); i < end_i; ++i) {
        const std::size_t voxel = stack.at(i - stack.first_i, j - stack.first_j, static_cast<std::ptrdiff_t>(n) + 1);
        stack.field[voxel] = window.values[window.at(i, j)];
      }
    }
  }
  return stack;
}

std::vector<std::uint32_t> pieces_of_layers(const LayerStack& stack, std::size_t& count) {
  UnionFind sets(stack.material.size());
  join_within_layers(stack, sets);
  std::vector<std::uint32_t> pieces(stack.material.size());
  count = 0;
  for (std::uint32_t v = 0; v < pieces.size(); ++v) {
    const std::uint32_t root = sets.find(v);
    pieces[v] = root == v ? static_cast<std::uint32_t>(count++) : pieces[root];
  }
  return pieces;
}

LayerTopology topology_of(const LayerStack& stack) {
  UnionFind sets(stack.material.size());
  join_within_layers(stack, sets);
  std::ptrdiff_t euler = 0;
  const auto solid = [&](std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t k) {
    return stack.material[stack.at(i, j, k)] != 0;
  };
  for (std::ptrdiff_t k = 0; k < stack.layers; ++k) {
    for (std::ptrdiff_t j = 1; j + 1 < stack.rows; ++j) {
      for (std::ptrdiff_t i = 1; i + 1 < stack.columns; ++i) {
        const bool up = k + 1 < stack.layers, here = solid(i, j, k);
        if (up) {  // void by edges and corners too
          for (std::ptrdiff_t dj = -1; dj <= 1; ++dj) {
            for (std::ptrdiff_t di = -1; di <= 1; ++di) {
              if (solid(i + di, j + dj, k + 1) != here || (here && (di != 0 || dj != 0))) continue;
              sets.join(static_cast<std::uint32_t>(stack.at(i, j, k)),
                        static_cast<std::uint32_t>(stack.at(i + di, j + dj, k + 1)));
            }
          }
        }
        if (!here) continue;
        const bool x = solid(i + 1, j, k), y = solid(i, j + 1, k), xy = x && y && solid(i + 1, j + 1, k);
        const bool z = up && solid(i, j, k + 1);
        const bool xz = x && z && solid(i + 1, j, k + 1), yz = y && z && solid(i, j + 1, k + 1);
        euler += 1 - x - y - z + xy + xz + yz - (xy && xz && yz && solid(i + 1, j + 1, k + 1));
      }
    }
  }
  LayerTopology found;
  std::vector<bool> open(stack.material.size(), false);  // roots of void that reach a given slice
  for (std::uint32_t v = 0; v < stack.material.size(); ++v) {
    const std::ptrdiff_t k = stack.layer_of(v);
    if (k == 0 || k == stack.layers - 1) open[sets.find(v)] = true;
  }
  std::ptrdiff_t bubbles = 0;
  for (std::uint32_t v = 0; v < stack.material.size(); ++v) {
    if (sets.find(v) != v) continue;
    ++(stack.material[v] ? found.pieces : found.voids);
    bubbles += !stack.material[v] && !open[v];
  }
  found.loops = static_cast<std::ptrdiff_t>(found.pieces) - euler + bubbles;
  return found;
}

}  // namespace odontoscope::between
