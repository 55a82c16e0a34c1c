#pragma once
// CSL, the text format in which papers on surfaces from cross sections trade their data ("CSLC" in the first line).
//
//   CSLC
//   PLANES LABELS
//   then for each plane: NUMBER VERTICES COMPONENTS A B C D, where Ax + By + Cz + D = 0
//     x y z                  for each vertex
//     COUNT LABEL i j k ...  for each component, a closed contour by vertex numbers from 0; COUNT is "5h0" for a hole
//     with five
//                            corners in component 0, which may come later
//
// Planes must be parallel; they may lie any way. Planes along z keep x and y as they are, those along x or y change
// axes by rotation (y, z, x or z, x, y), and any others are turned so that their normal is +z. Points are projected
// onto their plane. A file with two labels (one is the outside) gives the structure "tooth", one with more "label 1",
// "label 2" ...; holes belong to the structure that they are holes of. Numbers are taken as millimetres.

#include <string>
#include <string_view>

#include "recon/exchange/contour_file.h"

namespace odontoscope {

bool looks_like_csl(std::string_view bytes);

/// Throws InputError: bad-header, unparsable, truncated, trailing-bytes, not-finite, too-large, index-out-of-range,
/// not-parallel (planes), off-plane (a point), repeated-z (planes in one place), and the counts as in stack_json.h.
/// Counts are checked against the bytes that are there.
FileContours parse_csl(std::string_view bytes, const std::string& file);

}  // namespace odontoscope
