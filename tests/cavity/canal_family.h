#pragma once
// The family: roots with known canals, drawn at random, and what is told of them from their slices.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "recon/cavity/anatomy.h"
#include "recon/delaunay/reconstruct.h"
#include "tests/cavity/known_root.h"

namespace odontoscope::test {

/// By turns: Vertucci's eight types; a taper; arcs of 8, 15 and 30 mm; an open apex; two tapers; a fork shorter than a
/// quarter; a fin; an accessory canal; isthmuses of types V, II and IV; a ribbon. Sizes at random, half of them oval,
/// two in three tilted by up to 30 degrees. The same for the same seed, on every machine.
KnownRoot random_root(std::uint64_t seed);
inline constexpr std::uint64_t kinds_of_roots = 21;

/// By turns: arcs that bend to the section's long side, arcs that are a part of the canal, tapering arcs, double
/// curves, a foramen at the root's side, an apex that opens like a funnel, a gutter (C-shaped), a delta, flat canals
/// with a part of an arc, straight oval tapers, flat arcs, an isthmus among three canals.
KnownRoot rare_root(std::uint64_t seed);
inline constexpr std::uint64_t rare_kinds = 12;

/// A figure as it was told and as it is.
struct FigureVerdict {
  std::string name;
  double known = 0, told = 0, off = 0;  // `off`: what is told of how far it may be off
  double error() const { return told / known - 1; }
};

struct FamilyVerdict {
  bool counted = false;  // as many canals, roots, and the type
  bool beside = false;   // accessory canals and isthmuses as they are
  std::string told;      // "II expected, told I with 1 canal"
  std::vector<FigureVerdict> figures;
  double orifice_off = 0;  // farthest of the canals' orifices from where they are
};
FamilyVerdict judge(const KnownRoot& root, const Anatomy& made);

Anatomy anatomy_of(const Reconstruction& model);

}  // namespace odontoscope::test
