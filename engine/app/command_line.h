#pragma once

#include "recon/core/error.h"

namespace odontoscope::app {

/// The whole program: parses, runs the subcommand, and turns whatever is thrown into a message and an exit code.
int run(int argc, char** argv);

}  // namespace odontoscope::app
