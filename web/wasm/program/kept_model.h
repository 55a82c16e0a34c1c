#pragma once
// A page's model, kept by JavaScript for as long as it keeps the instance of the module.

#include "engine/app/command.h"
#include "engine/app/made_model.h"

namespace odontoscope::app {

/// In place of the one that was kept before.
void keep(MadeModel&& model);

/// `save`: it as files.
Command save_command(CLI::App& root);

}  // namespace odontoscope::app
