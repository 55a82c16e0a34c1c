#pragma once
// Numbers of permanent teeth: the FDI's two digits (ISO 3950) and the Universal Numbering System of the American Dental
// Association.

#include <string>

#include "recon/sample/sample_tooth.h"

namespace odontoscope {

/// 1 to 32 of "18" to "48"; 0 for what is no permanent tooth by the FDI.
int universal_number(const std::string& fdi);

/// "lower left first molar: FDI 36, Universal 19".
std::string tooth_in_words(ToothKind kind);

}  // namespace odontoscope
