#pragma once
// Pieces, handles and bubbles of a solid that is given by voxels, by counting.
//
// Voxels are closed cubes: two belong together if they share so much as a corner (26 neighbours); what is not material
// belongs together through faces (6). Euler characteristic: corners - edges + faces - cubes of that complex, summed
// over grid points from their eight voxels (after S. B. Gray, "Local properties of binary images in two dimensions",
// IEEE Transactions on Computers C-20(5), 1971). Handles follow: pieces - handles + bubbles.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace odontoscope::test {

struct Topology {
  long pieces = 0, handles = 0, bubbles = 0;
  friend bool operator==(const Topology&, const Topology&) = default;
};

/// "1 piece, 2 handles, no bubble" in short: "1/2/0".
std::string in_short(const Topology& topology);

/// x fastest, then y, then z; 0 is void.
struct Voxels {
  std::size_t columns = 0, rows = 0, layers = 0;
  std::vector<std::uint8_t> values;

  Voxels() = default;
  Voxels(std::size_t along_x, std::size_t along_y, std::size_t along_z)
      : columns(along_x), rows(along_y), layers(along_z), values(along_x * along_y * along_z, 0) {}
  std::size_t index(std::size_t i, std::size_t j, std::size_t k) const { return (k * rows + j) * columns + i; }
};

/// Of the voxels that have `bit` set.
Topology topology_of(const Voxels& voxels, std::uint8_t bit);

}  // namespace odontoscope::test
