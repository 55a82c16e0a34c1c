#pragma once
// The user's word on correspondence: which region of a slice connects to which region of the next.
//
// A region is named by its outer contour. The file (docs/formats.md):
//   {"format":"odontoscope.links","version":1,"links":[
//     {"structure":"tooth","slice":12,"lower":0,"upper":1,"connect":true}]}
// `slice` counts the slices by ascending z from 0; `lower` is the number of the outer contour of a region in that
// slice, `upper` of one in slice+1, counted from 0 as they stand in their slice's list (all structures counted). The
// report lists the links that were made in the same form with a "criterion" added, so that it can be copied and
// changed; "criterion" and "z" are read and ignored.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/input/contour_stack.h"

namespace odontoscope {

struct Link {
  std::string structure = "tooth";
  std::size_t slice = 0;
  std::size_t lower = 0;
  std::size_t upper = 0;
  /// true: connect them; false: keep them apart. Wins over every automatic criterion.
  bool connect = true;
  friend bool operator==(const Link&, const Link&) = default;
};

/// Throws InputError (unparsable, wrong-format, wrong-version, not-finite, too-large, bad-name, ...) or FileError.
std::vector<Link> read_links(const std::string& file);

/// Throws InputError unless every link names a structure, slice and outer contour that exist in `ordered_stack`
/// (slices by ascending z) and no pair is both forced and forbidden.
/// Causes: link-unknown-structure, link-unknown-slice, link-unknown-contour, link-not-outer (names a hole),
/// link-wrong-structure, link-contradiction.
void validate_links(const std::vector<Link>& links, const ContourStack& ordered_stack, const std::string& file = {});

}  // namespace odontoscope
