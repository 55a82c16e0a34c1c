#pragma once
// The space between two given slices, through as many interpolated ones as give every structure the topology that
// contours and links imply.

#include <vector>

#include "recon/delaunay/attention.h"
#include "recon/partition/interpolate.h"
#include "recon/partition/partition_slab.h"
#include "recon/partition/slab_stack.h"

namespace odontoscope::partition {

struct SolvedBetween {
  std::vector<PartitionSlice> slices;  // interpolated, bottom up
  std::vector<PartitionSlab> slabs;    // one more
  std::vector<Topology> found;         // of each structure
  long off = 0;                        // pieces, handles and bubbles by which it is not what is implied
};

struct BetweenTask {
  const PartitionSlice& lower;
  const PartitionSlice& upper;
  const Materials& materials;
  std::vector<Topology> implied;               // of each structure
  const Interpolator* interpolator = nullptr;  // none: the two slices alone
  std::size_t slab = 0;
  Place place;  // for messages
};

/// The first attempt that gives what is implied, else the one that comes nearest.
SolvedBetween solve_between(const BetweenTask& task, const Progress& progress);

/// Once more, by the structures' own contours, if that comes nearer. Precondition: task.interpolator, and its
/// survey_own was called.
void improve_between(const BetweenTask& task, SolvedBetween& solved, const Progress& progress);

/// The tetrahedra of one label, and their boundary.
struct LabelledPart {
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Triangle> boundary;
};
LabelledPart part_of(const TetraMesh& mesh, std::size_t first, std::size_t end, Label label);

}  // namespace odontoscope::partition
