#pragma once
// Matches the faces of tetrahedra by their three point numbers: an open-addressing table, since this runs for every slab.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

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
      if (slot.value == vacant) slot.key = {a, b, c};
      if (slot.key == std::array{a, b, c}) return slot.value;
    }
  }

 private:
  struct Slot {
    std::array<std::uint32_t, 3> key{vacant, vacant, vacant};
    std::uint32_t value = vacant;
  };
  std::vector<Slot> slots_;
  std::size_t mask_ = 0;
};

}  // namespace odontoscope::delaunay
