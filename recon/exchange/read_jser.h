#pragma once
// Series of PyReconstruct (.jser), the successor of Reconstruct: one JSON file, as its own program writes it
// (datatypes/series.py, section.py and trace.py of SynapseWeb/PyReconstruct, 2024).
//
//   {"sections": [null or {"thickness": um, "tforms": {ALIGNMENT: [a, b, c, d, e, f]},
//                          "contours": {NAME: [[[x ...], [y ...], colour, closed, negative, hidden, mode, tags],
//                          ...]}}, ...],
//    "series": {"alignment": ALIGNMENT, ...}, ...}
//
// A section's number is its place in the list. Each point becomes (ax + by + c, dx + ey + f) by the transform of the
// series' alignment; "no-alignment" leaves it as it is. A section's height is the sum of the thicknesses below it;
// sections that are missing count as thick as the last one before them. Traces that are not closed are left out;
// negative ones are contours like others (a hole lies within what it is a hole of). Micrometres become millimetres.
// Traces may be objects with the keys x, y and closed, as older files have them; files older still, without "sections",
// are refused.

#include <string>
#include <string_view>

#include "recon/exchange/contour_file.h"

namespace odontoscope {

bool looks_like_jser(std::string_view bytes);

/// Throws InputError: unparsable, wrong-type, missing-key (an alignment that a section lacks, too), repeated-z (a
/// section without thickness), no-sections, file-too-large, not-finite, too-large, and the counts as in stack_json.h.
FileContours parse_jser(std::string_view bytes, const std::string& file);

}  // namespace odontoscope
