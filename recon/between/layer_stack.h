#pragma once
// Two given slices and the layers between them as voxels. Inner part of joined.h.

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "recon/between/composed.h"
#include "recon/between/joined.h"
#include "recon/between/simple_point.h"

namespace odontoscope::between {

/// Regions of both given slices in one numbering: contours of the lower, contours of the upper, the outside. A region
/// of material is known by its outer contour, one of void by its hole.
using RegionId = std::uint32_t;

struct RegionGraph {
  std::size_t lower = 0, upper = 0;               // contours
  std::vector<bool> hollow;                       // by region
  std::set<std::pair<RegionId, RegionId>> links;  // of material, the lower first
  std::vector<RegionId> void_group;               // by region: the least of its group; itself for material
  std::vector<std::size_t> void_group_size;       // by group: its regions
  LayerTopology implied;

  RegionGraph(const SliceSet& slices, const Surroundings& surroundings);
  RegionId outside_region() const { return static_cast<RegionId>(lower + upper); }
};

/// Voxels (i, j, k), k = 0 the lower and layers - 1 the upper slice; all at the border in i and j are void.
struct LayerStack {
  std::ptrdiff_t first_i = 0, first_j = 0;  // on the grid
  std::ptrdiff_t columns = 0, rows = 0, layers = 0;
  std::vector<double> field;  // negative where material is wanted
  std::vector<std::uint8_t> material;
  std::vector<RegionId> region;  // in the given layers; of material in between, the one that it grew from

  std::size_t at(std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t k) const {
    return static_cast<std::size_t>((k * rows + j) * columns + i);
  }
  std::size_t layer_size() const { return static_cast<std::size_t>(columns * rows); }
  std::ptrdiff_t layer_of(std::size_t voxel) const { return static_cast<std::ptrdiff_t>(voxel / layer_size()); }
  /// Not in a given slice, not at the border.
  bool free(std::size_t voxel) const;
  /// Precondition: not at the border in i, j or k.
  Neighbourhood around(std::size_t voxel) const;
  /// Number of the neighbour that a bit of a neighbourhood stands for.
  std::size_t neighbour(std::size_t voxel, int bit) const;
};

/// Is every region of both given slices just one piece on this grid (material by faces, void by corners too)?
bool resolves(const SliceSet& slices, const Grid& grid);

/// The given slices sampled, all between them void, the blended fields ready. Of a region in several pieces only the
/// largest stays; the others become what is around them. Empty if a region is not seen on the grid at all.
std::optional<LayerStack> sampled_layers(const SliceSet& slices, const Composition& composition, const Grid& grid,
                                         std::span<const double> shares);

/// Numbers of the pieces of each layer by itself, of material (joined by edges in the plane) and of void (by corners
/// too) alike; their count in `count`.
std::vector<std::uint32_t> pieces_of_layers(const LayerStack& stack, std::size_t& count);

LayerTopology topology_of(const LayerStack& stack);

}  // namespace odontoscope::between
