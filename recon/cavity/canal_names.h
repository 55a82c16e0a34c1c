#pragma once
// Names of canals and horns where the anatomy is known.

#include <optional>

#include "recon/cavity/centre_lines.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope {

/// The sample tooth whose canals end where these do; none if no tooth's do.
std::optional<ToothKind> sample_of(const CentreLines& lines);

/// Where all canals end where those of one of the sample teeth do (and there are as many), canals and horns are called
/// as that tooth's are: "mesiobuccal canal", "distal horn", "root canal". Otherwise nothing changes: names from form
/// alone would be guesses. The order stays.
void name_as_sample(CentreLines& lines);

}  // namespace odontoscope
