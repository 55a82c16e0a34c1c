#pragma once
// A stack of contours of several structures to one conforming complex, in which they share their faces.
//
// What holds for every valid stack: all tetrahedra are positive; each face belongs to at most two, of one
// material or of two that share it; the surface of each material, and of all together, is closed, oriented outwards,
// edge- and vertex-manifold; the complex cut by a slice's plane is exactly that slice's partition, seen from either
// side, and touches the plane nowhere else. So there is no gap and no overlap, and volumes add up. It is proven on the
// result each time; a failed proof throws InternalError.
//
// The same input gives the same bytes, on any number of threads.
//
// Not supported: links chosen by the user.

#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/input/validate.h"

namespace odontoscope {

struct PartitionOptions {
  /// Structures in the order in which they win where they overlap; those that are not named follow, the innermost
  /// first.
  std::vector<std::string> priority;
  double gap = 0;  // mm; void narrower than this between two structures is closed
  Between between = Between::blended;
  int threads = 0;  // 0: as many as the machine has
};

/// Validates `stack` (InputError; also unknown-structure for a name of `priority` that is not there,
/// too-many-structures, slices-too-close). The solids of the result are the complex's materials (a structure that
/// others cover wholly has none), with coordinates equal to the bit where they share faces; `Reconstruction::complex`
/// is set.
Reconstruction reconstruct_partition(const ValidStack& stack, const PartitionOptions& options = {},
                                     const Progress& progress = {});
/// Validates it first.
Reconstruction reconstruct_partition(const ContourStack& stack, const PartitionOptions& options = {},
                                     const Progress& progress = {});

}  // namespace odontoscope
