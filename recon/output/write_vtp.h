#pragma once
// VTK's XML format for surfaces: for ParaView and meshio's friends.
//
// Millimetres, double precision, base64 arrays. All structures in one piece; cell data `structure` counts them from 1
// (field data "structure NAME" holds the number of NAME), `kind` is 0 for an external surface, 1 for a cavity's, 2 for
// an open one; field data `certified` is 1 or 0.

#include <string>

#include "recon/formats/written_model.h"

namespace odontoscope {

std::string vtp_bytes(const WrittenModel& model);

}  // namespace odontoscope
