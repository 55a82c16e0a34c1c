#pragma once
// Binary STL: for printers and old tools.
//
// Millimetres, single precision; all structures one after the other, cavities facing inwards. STL has no vertices:
// whoever reads it joins equal coordinates. Points of a structure that are distinct stay distinct; where two structures
// share a wall (enamel on dentine) that joining glues them together, so such a model is better kept as GLB or PLY.

#include <string>

#include "recon/formats/written_model.h"

namespace odontoscope {

/// UsageError if there are more triangles than a 32-bit number counts.
std::string stl_bytes(const WrittenModel& model);

}  // namespace odontoscope
