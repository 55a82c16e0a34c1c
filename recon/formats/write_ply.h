#pragma once
// PLY, binary little endian, indexed: the surfaces without loss.
//
// Millimetres, double precision. Vertices x y z; faces a list of three indices and `structure`, which counts the
// structures from 1; comment lines give their names. Cavities face inwards.

#include <string>

#include "recon/formats/written_model.h"

namespace odontoscope {

/// UsageError if there are more points than 32 bits count.
std::string ply_bytes(const WrittenModel& model);

}  // namespace odontoscope
