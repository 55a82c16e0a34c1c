#pragma once
// Contours as a structure set of radiotherapy: DICOM RTSTRUCT (PS3.3, A.19), in implicit little-endian coding, since
// longer contours do not fit into the other.
//
// Each structure is a region of interest of its name. Each outer contour of a slice is a contour of type CLOSED_PLANAR;
// its holes are joined to it by keyholes (keyholes.h), which the standard asks for and every reader takes right.
// Coordinates are the patient's, millimetres, in decimals of up to 16 characters. Where the contours came from DICOM
// the set belongs to that patient, study and frame of reference, and each contour names the image that it lies on.
// Slices without contours have no place in such a file.

#include <string>

#include "recon/input/contour_stack.h"
#include "recon/segmentation/dicom_common.h"

namespace odontoscope {

/// Same input, same bytes, identifiers too. Precondition: `validate` passed.
std::string rtstruct_bytes(const ContourStack& stack, const PatientOrigin& origin, const WrittenBy& by = {});

}  // namespace odontoscope
