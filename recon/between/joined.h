#pragma once
// Virtual slices with the topology that the links imply.
//
// Two given slices and the virtual ones between them are taken as thick layers that are joined where neighbours
// overlap. What the links imply of the whole:
// - pieces of material: components of the graph of linked regions;
// - pieces of void: components of the graph of linked void regions, the outside being one;
// - independent loops of material: holes of all regions in both slices, plus independent cycles of the graph of linked
//   regions, minus components of the graph of linked void regions that do not reach the outside.
// Blended fields alone need not give that. Here each layer is a raster; material grows from the two given slices, the
// surest voxel first (the most negative field), by simple voxels, which change no topology (Bertrand 1994; growing with
// topology control: Bischoff and Kobbelt, "Isosurface reconstruction with topology control", 2002). A voxel that joins
// two pieces is taken just once for each linked pair of regions; one that seals a void off, only where that parts void
// regions that are not linked. If a join or seal is still missing, material grows on over the field's zero; whatever of
// that is not needed is given back, the least sure first. The contours are then traced from the fields, turned where
// the labels say otherwise.

#include <cstddef>
#include <span>
#include <vector>

#include "recon/between/blend.h"

namespace odontoscope::between {

struct LayerTopology {
  std::size_t pieces = 0;    // of material
  std::size_t voids = 0;     // pieces of void, the outside one of them
  std::ptrdiff_t loops = 0;  // independent loops of material
  friend bool operator==(const LayerTopology&, const LayerTopology&) = default;
};

/// What the blended fields have and the layers were not given, or the other way round.
struct Correction {
  enum class Kind { filled, cut };  // void became material, material became void
  Kind kind = Kind::filled;
  Point3 place;       // in the middle of it
  double volume = 0;  // mm^3, of voxels
};

/// Which contours of a layer and the one above it overlap, as ContourLink says.
struct LayerLinks {
  std::vector<ContourLink> material, voids;
};

struct JoinedBlend {
  std::vector<Outline> outlines;  // one a share, as `blend` gives them
  /// Between lower, the outlines in order, and upper: one more than outlines.
  std::vector<LayerLinks> links;
  std::vector<Correction> corrections;
  LayerTopology implied, found;
  /// false: contours or walls are too thin for the finest grid that is allowed. Then tips that do not hold together on
  /// it are left out of account; if that is not enough, the outlines are those of `blend`, without links and
  /// corrections.
  bool resolved = false;

  bool as_implied() const { return resolved && implied == found; }
};

struct JoinOptions {
  BlendOptions blend;
  /// The grid is refined up to so many points a layer until every contour and wall of the two slices is seen on it.
  std::size_t most_grid_points = 400'000;
};

/// As `blend`, with the same preconditions. Some ten times slower.
JoinedBlend blend_joined(const Surroundings& surroundings, std::span<const double> shares,
                         const JoinOptions& options = {});

}  // namespace odontoscope::between
