#pragma once
// Whole teeth as the program's loader would deliver them. Made once, then remembered.

#include <memory>

#include "engine/viewer/loading.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::testing_support {

LoadedModel sample_tooth_loaded(ToothKind kind = ToothKind::molar);

/// Precondition: ct_molar_there().
LoadedModel ct_molar_loaded();
bool ct_molar_there();

}  // namespace odontoscope::testing_support
