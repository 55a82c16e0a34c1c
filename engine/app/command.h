#pragma once
// What a subcommand is: options on a parser, and a function to run once the whole command line is known to be sound.

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <vector>

#include "engine/app/console.h"
#include "engine/app/interrupt.h"
#include "recon/core/error.h"
#include "recon/core/progress.h"

namespace odontoscope::app {

struct MadeModel;  // engine/app/made_model.h

/// What every subcommand is given when it runs.
struct Session {
  Console& console;
  Interrupts& interrupts;
  int threads = 0;  // 0: as many as the machine has
  /// Work for somebody else than the terminal: who watches and stops it instead.
  std::optional<Progress> watched = {};
  /// Takes the model that a page shows, from whoever can write it to files later without making it again (web/wasm);
  /// empty: nobody does.
  std::function<void(MadeModel&&)> keep = {};

  /// For long work: shows a bar or lines, and stops on Ctrl-C.
  Progress progress() const {
    if (watched) return *watched;
    return {[this](std::string_view stage, double fraction) { console.progress(stage, fraction); }, interrupts.token()};
  }
};

struct Command {
  CLI::App* parser = nullptr;  // owned by the root parser
  /// Throws what recon/core/error.h lists.
  std::function<ExitCode(Session&)> run;
};

/// The subcommands that this program has, added to its parser, and what its help says last. In commands.cpp; the
/// program for browsers (web/wasm/program) has fewer.
std::vector<Command> add_commands(CLI::App& root);
const char* first_steps();

Command sample_command(CLI::App& root);
Command contours_command(CLI::App& root);
Command reconstruct_command(CLI::App& root);
Command check_command(CLI::App& root);
Command render_command(CLI::App& root);
Command view_command(CLI::App& root);
Command web_command(CLI::App& root);
Command compare_command(CLI::App& root);
Command canal_command(CLI::App& root);
Command figures_command(CLI::App& root);
Command anatomy_command(CLI::App& root);
Command corpus_command(CLI::App& root);
Command batch_command(CLI::App& root);
Command compare_images_command(CLI::App& root);

}  // namespace odontoscope::app
