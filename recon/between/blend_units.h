#pragma once
// Which shapes are blended as one: the contours of four slices sorted by the links. Inner part of blend.h.
//
// A group is a connected component of the graph of linked regions. Its material unit is what its outer contours
// enclose, without holes that are linked to the outside; its void units are its other holes, each a connected component
// of the graph of linked void regions. Islands of a hole that are of the same group belong to the void unit as holes of
// it, so that "material minus voids" is the group's own section in either slice.

#include <array>
#include <cstddef>
#include <vector>

#include "recon/between/nesting.h"
#include "recon/between/slice_weights.h"

namespace odontoscope::between {

inline constexpr std::size_t slices_used = 4;
/// Places in arrays by slice.
inline constexpr std::size_t at_before = 0, at_lower = 1, at_upper = 2, at_after = 3;

/// The surroundings with what is known of their contours; missing slices are empty outlines.
struct SliceSet {
  std::array<const Outline*, slices_used> outlines{};
  std::array<std::vector<ContourFacts>, slices_used> facts;
  std::array<double, slices_used> z{};

  explicit SliceSet(const Surroundings& surroundings);

  /// Of the box around lower and upper.
  double larger_side() const;
};

enum class Presence {
  shape,   // the unit has contours there
  gone,    // it has none: it shrinks against the nearest contour of the slice
  unused,  // no such slice, or nothing in it that the unit could be matched with: it has no say
};

struct BlendUnit {
  std::array<Outline, slices_used> shapes;
  std::array<Presence, slices_used> presence{};
};

struct BlendGroup {
  BlendUnit material;
  std::vector<std::size_t> voids;  // numbers in BlendPlan::voids
};

struct BlendPlan {
  std::vector<BlendGroup> groups;
  std::vector<BlendUnit> voids;
};

/// Throws InternalError for links that name no contours, or contours of the wrong kind.
BlendPlan blend_plan(const SliceSet& slices, const Surroundings& surroundings);

}  // namespace odontoscope::between
