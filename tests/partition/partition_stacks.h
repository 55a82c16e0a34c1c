#pragma once
// Stacks of two to five structures that a malicious tester would send to the partition: valid, and as awkward as their
// kind says. A seed means the same stack on every machine; the kind is the seed's remainder by the number of kinds.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "recon/input/contour_stack.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {

struct PartitionCase {
  ContourStack stack;                 // slices by ascending z
  std::vector<std::string> priority;  // all structures
  double gap = 0;
  bool delaunay = false;  // without interpolated slices
  std::string kind;
};

enum class PartitionSize { small, any, large };  // some tens of points; mostly below 250; about 2,000

PartitionCase partition_case(std::uint64_t seed, PartitionSize size);
const std::vector<std::string>& partition_kinds();

// --- for the makers --------------------------------------------------------------------------------------------------
/// Draws one stack of about `points` points, which may break a rule now and then: partition_case draws again.
using PartitionMaker = ContourStack (*)(RandomNumbers& random, int points);
struct NamedPartitionMaker {
  const char* kind;
  PartitionMaker make;
};
const std::vector<NamedPartitionMaker>& shape_makers();   // blobs, shells, crossings
const std::vector<NamedPartitionMaker>& border_makers();  // borders shared, lattices, corners
const std::vector<NamedPartitionMaker>& mixed_makers();   // strange stacks of one structure made of several

/// "s1" to "s5".
std::string structure_name(int number);
/// Adds the ring unless it breaks a rule or meets one of its own structure.
bool add_ring(Slice& slice, int structure, const std::vector<Point2>& ring);
/// Heights at random distances.
ContourStack stack_slices(RandomNumbers& random, std::vector<Slice> slices);

}  // namespace odontoscope::test
