#pragma once
// Wavefront OBJ: for modelling programs, and for readers without a library.
//
// Text, millimetres, double precision without loss, +z along the tooth. One object for each structure's external
// surfaces and one for its cavities, called "tooth_external" (the full name stands in a comment before it); faces are
// three vertex numbers, counter-clockwise from outside. Comments hold unit and certificate. No normals, no materials.

#include <string>

#include "recon/formats/written_model.h"

namespace odontoscope {

std::string obj_text(const WrittenModel& model);

}  // namespace odontoscope
