#pragma once
// Where the slices leave a choice that matters: a link that was made or not, and would change what the solid is like
// (its pieces, handles or canals) if it were decided the other way.

#include <cstddef>
#include <optional>
#include <string>

#include "recon/core/geometry.h"

namespace odontoscope {

enum class DoubtKind {
  may_connect,       // two regions are not linked, but may be one thing
  may_part,          // two regions are linked, but may be two things
  void_may_connect,  // two voids are not linked, but may be one canal
  void_may_part,     // two voids are linked, but may be two that end blind
};

/// One choice, each pair of contours at most once. For regions the contours are outer ones, and a link in the links
/// file (join, or keep apart) decides it. For voids they are holes' contours, and a pair of slices between these two
/// decides it: links name regions only.
struct Doubt {
  std::string structure;
  std::size_t slab = 0;  // between slices slab and slab + 1, by ascending z
  Point3 place;          // halfway between the two, mm
  DoubtKind kind = DoubtKind::may_connect;
  std::optional<std::size_t> lower, upper;  // numbers of the two contours in their slices' lists; none: the outside
  friend bool operator==(const Doubt&, const Doubt&) = default;
};

/// "may-connect", "may-part", "void-may-connect", "void-may-part".
const char* name(DoubtKind kind);

}  // namespace odontoscope
