#pragma once
// Names of canals and horns where the anatomy is known.

#include "recon/cavity/centre_lines.h"

namespace odontoscope {

/// Where all canals end where those of one of the sample teeth do (and there are as many), canals and horns are called as that tooth's are: "mesiobuccal
/// canal", "distal horn", "root canal". Otherwise nothing changes: names from form alone would be guesses. The order stays.
void name_as_sample(CentreLines& lines);

}  // namespace odontoscope
