#pragma once
// VRML97 (ISO/IEC 14772-1:1997), which the paper explored its teeth in, and its successor X3D (ISO/IEC 19775).
//
// One Shape for each structure's external surfaces and one for its cavities, with its name, and `solid TRUE`, `ccw
// TRUE`: the back of a triangle is not drawn, so that a surface with misoriented triangles shows its holes. Coordinates
// are millimetres without loss; a Transform turns +z up into +y up and scales to the metres that these formats mean. A
// viewpoint shows all of it, and NavigationInfo fits one's size to the tooth's, since at a person's size it would lie
// before the near plane.

#include <string>

#include "recon/formats/written_model.h"

namespace odontoscope {

std::string vrml_text(const WrittenModel& model);
std::string x3d_text(const WrittenModel& model);

}  // namespace odontoscope
