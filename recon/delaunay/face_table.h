#pragma once
// Matches the faces of tetrahedra by their three point numbers: an open-addressing table, since this runs for every slab.

#include <cstdint>
#include <utility>
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

}  // namespace odontoscope::delaunay
