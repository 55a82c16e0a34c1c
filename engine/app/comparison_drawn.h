#pragma once
// What `compare` shows beside its numbers, apart from it, since WebAssembly has it without.

#include <string>

#include "engine/app/command.h"
#include "recon/compare/compare.h"

namespace odontoscope::app {

/// Pictures of each method's model, and what is seen through it. Empty, or why this machine cannot draw. Throws
/// Cancelled.
std::string add_comparison_pictures(Comparison& comparison, Session& session);

}  // namespace odontoscope::app
