#pragma once
// Matches the faces of tetrahedra by their three point numbers: an open-addressing table, since this runs for every
// slab.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "recon/mesh/meshes.h"

namespace odontoscope::delaunay {

class FaceTable {
 public:
  static constexpr std::uint32_t vacant = 0xffffffffu;

  explicit FaceTable(std::size_t faces) {
    std::size_t size = 16;
    while (size < faces * 2) size *= 2;
    mask_ = size - 1;
    slots_.resize(size);
  }

  /// The value stored for this face (in any order of its points), or `vacant`; the caller fills it.
  std::uint32_t& operator()(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a > b) std::swap(a, b);
    if (b > c) std::swap(b, c);
    if (a > b) std::swap(a, b);
    std::uint64_t hash = a * 0x9e3779b97f4a7c15ull ^ b * 0xc2b2ae3d27d4eb4full ^ c * 0x165667b19e3779f9ull;
    hash ^= hash >> 29;
    for (std::size_t i = hash & mask_;; i = (i + 1) & mask_) {
      Slot& slot = slots_[i];
      if (slot.value == vacant) {
        slot.a = a;
        slot.b = b;
        slot.c = c;
      }
      if (slot.a == a && slot.b == b && slot.c == c) return slot.value;
    }
  }

 private:
  struct Slot {
    std::uint32_t a = vacant, b = vacant, c = vacant, value = vacant;
  };
  std::vector<Slot> slots_;
  std::size_t mask_ = 0;
};

/// Is this an even permutation of the ascending order? The two sides of a face differ in it.
inline bool even_permutation(const Triangle& face) {
  return (face[0] < face[1]) != ((face[1] < face[2]) != (face[0] < face[2]));
}

/// Calls visit(face) for each face that only one of the tetrahedra has, in their order, counter-clockwise seen from
/// outside.
template <class Visit>
void each_outer_face(const std::vector<std::array<std::uint32_t, 4>>& tetrahedra, Visit visit) {
  FaceTable table(tetrahedra.size() * 4);
  std::vector<bool> shared(tetrahedra.size() * 4, false);
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
    for (std::uint32_t i = 0; i < 4; ++i) {
      const auto& f = outward_face[i];
      std::uint32_t& seen = table(tetrahedra[t][f[0]], tetrahedra[t][f[1]], tetrahedra[t][f[2]]);
      if (seen == FaceTable::vacant)
        seen = 4 * t + i;
      else
        shared[seen] = shared[4 * t + i] = true;
    }
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (shared[4 * t + i]) continue;
      const auto& f = outward_face[i];
      visit(Triangle{tetrahedra[t][f[0]], tetrahedra[t][f[1]], tetrahedra[t][f[2]]});
    }
}

}  // namespace odontoscope::delaunay
