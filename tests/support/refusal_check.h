#pragma once
// Is a refusal of the engine true? Decided from the stack and its links alone, with exact arithmetic.
//
// `too-close` is true if in the slice that it names (any slice, if none) a corner of a contour lies nearer than
// `parted_ulps` units in the last place of the slice's largest coordinate to an edge of its structure that it is no end
// of: then nothing can be put between. `slices-too-close` is true if fewer than `parted_heights` doubles lie between
// the height of the slice that it names and the next. `link-contradiction` is true if forced links of one slab join,
// directly or through others, two regions that a forbidden link keeps apart. `link-impossible` is true only if two
// parts that forced links join, and a forbidden link keeps apart, have outlines whose convex hulls meet in the plane:
// parts with hulls apart can be built in their hulls. Any other refusal of a valid stack is false.

#include <string>
#include <vector>

#include "recon/core/error.h"
#include "recon/input/contour_stack.h"
#include "recon/input/links.h"

namespace odontoscope::test {

inline constexpr int parted_ulps = 16;
inline constexpr int parted_heights = 5;

/// Empty if the refusal is true; else what it claims and what is so. `stack`: slices by ascending z.
std::string what_is_false(const InputError& refusal, const ContourStack& stack, const std::vector<Link>& links);

}  // namespace odontoscope::test
