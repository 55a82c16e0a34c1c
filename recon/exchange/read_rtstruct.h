#pragma once
// Structure sets of radiotherapy: DICOM RTSTRUCT (DICOM PS3.3, A.19 and C.8.8.5 to C.8.8.6).
//
// Each region of interest (ROI) with contours becomes a structure of its name. Contours of type CLOSED_PLANAR and
// CLOSEDPLANAR_XOR are taken, points and open lines are left out and counted in the remarks. A hole is a contour within
// another, or a keyhole: one line that goes in along a bridge and comes back along the very same points (parted here,
// unbridge.h, and told); where points differ, repair_contours may mend it. Numbers are millimetres in the patient's
// axes.
//
// Planes must be parallel; parallel_planes.h says how they become slices. A contour that its slice has already is left
// out and told. Names become UTF-8 (character_set.h). The preamble and the mark of DICOM may be missing.

#include <string>
#include <string_view>
#include <vector>

#include "recon/exchange/contour_file.h"

namespace odontoscope {

bool looks_like_rtstruct(std::string_view bytes);

/// `structures` as for read_contour_file: only planes of those wanted become slices. Throws InputError:
///   truncated, unreadable-structure-set   see dicom_set.h; also if it names no region
///   wrong-count                           a contour has not as many points as it says
///   not-parallel, unknown-structure, unparsable, not-finite, too-large, file-too-large, and the counts as in
///   stack_json.h
FileContours parse_rtstruct(std::string_view bytes, const std::string& file,
                            const std::vector<std::string>& structures = {});

}  // namespace odontoscope
