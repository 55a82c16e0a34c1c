#include "recon/between/simple_point.h"

#include <cstdlib>

namespace odontoscope::between {
namespace {

constexpr int cells = 27;
constexpr Neighbourhood everything = (1u << cells) - 1;
constexpr Neighbourhood centre = 1u << 13;

struct Tables {
  std::array<Neighbourhood, cells> by_face{}, by_any{};  // neighbours of a neighbour
  Neighbourhood faces = 0, faces_and_edges = 0;          // of the voxel itself
  std::array<Neighbourhood, 8> corner{};                 // the eight cells round each of its corners
};

constexpr int offset(int cell, int axis) { return (axis == 0 ? cell % 3 : axis == 1 ? cell / 3 % 3 : cell / 9) - 1; }

constexpr int away(int a, int b, int axis) {
  const int apart = offset(a, axis) - offset(b, axis);
  return apart < 0 ? -apart : apart;
}

constexpr Tables tables() {
  Tables t;
  for (int a = 0; a < cells; ++a) {
    for (int b = 0; b < cells; ++b) {
      const int dx = away(a, b, 0), dy = away(a, b, 1), dz = away(a, b, 2);
      if (a == b) continue;
      if (dx + dy + dz == 1) t.by_face[a] |= 1u << b;
      if (dx <= 1 && dy <= 1 && dz <= 1) t.by_any[a] |= 1u << b;
    }
    const int steps = away(a, 13, 0) + away(a, 13, 1) + away(a, 13, 2);
    if (steps == 1) t.faces |= 1u << a;
    if (steps == 1 || steps == 2) t.faces_and_edges |= 1u << a;
  }
  for (int corner = 0; corner < 8; ++corner) {
    for (int cell = 0; cell < 8; ++cell) {
      const int x = (corner & 1) + (cell & 1), y = (corner >> 1 & 1) + (cell >> 1 & 1), z = (corner >> 2) + (cell >> 2);
      t.corner[corner] |= 1u << (x + 3 * y + 9 * z);
    }
  }
  return t;
}

constexpr Tables table = tables();

Neighbourhood piece(Neighbourhood seed, Neighbourhood within, const std::array<Neighbourhood, cells>& adjacent) {
  Neighbourhood found = seed, fresh = seed;
  while (fresh != 0) {
    Neighbourhood next = 0;
    for (; fresh != 0; fresh &= fresh - 1) next |= adjacent[static_cast<std::size_t>(__builtin_ctz(fresh))];
    fresh = next & within & ~found;
    found |= fresh;
  }
  return found;
}

}  // namespace

LocalPieces local_pieces(Neighbourhood material) {
  LocalPieces result;
  const Neighbourhood solid = material & table.faces_and_edges;
  for (Neighbourhood left = solid & table.faces; left != 0;) {
    const Neighbourhood found = piece(left & -left, solid, table.by_face);
    if (result.material < 4) result.material_bits[static_cast<std::size_t>(result.material)] = found & table.faces;
    ++result.material;
    left &= ~found;
  }
  const Neighbourhood hollow = ~material & everything & ~centre;
  for (Neighbourhood left = hollow; left != 0;) {
    const Neighbourhood found = piece(left & -left, hollow, table.by_any);
    if (result.voids < 4) result.void_bits[static_cast<std::size_t>(result.voids)] = found;
    ++result.voids;
    left &= ~found;
  }
  return result;
}

bool corner_contact(Neighbourhood material) {
  for (const Neighbourhood corner : table.corner) {
    const Neighbourhood hollow = ~material & corner;
    if (__builtin_popcount(hollow) != 2) continue;
    const int a = __builtin_ctz(hollow), b = __builtin_ctz(hollow & (hollow - 1));
    if (away(a, b, 0) + away(a, b, 1) + away(a, b, 2) == 3) return true;
  }
  return false;
}

}  // namespace odontoscope::between
