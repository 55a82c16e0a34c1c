// In place of engine/app/commands.cpp: the subcommands that neither draw nor start processes.
#include "engine/app/command.h"
#include "web/wasm/program/kept_model.h"

namespace odontoscope::app {

const char* first_steps() {
  return "This is the program as WebAssembly: what draws, opens windows or starts processes is not in it.\n"
         "  odontoscope sample molar -o molar.json                contours of a generated tooth\n"
         "  odontoscope reconstruct molar.json -o molar.glb       contours to a solid model\n"
         "  odontoscope web molar.json -o molar.html              a page to look at it in any browser\n"
         "  odontoscope anatomy molar.json                        its canals in numbers\n"
         "  odontoscope check molar.glb                           is it closed and oriented?\n"
         "\n"
         "Every subcommand explains itself: odontoscope reconstruct --help\n";
}

/// A page's model can be saved afterwards.
static Command keeping(const Command& command) {
  return {command.parser, [run = command.run](Session& session) {
            session.keep = [](MadeModel&& model) { keep(std::move(model)); };
            return run(session);
          }};
}

std::vector<Command> add_commands(CLI::App& root) {
  std::vector<Command> commands;
  for (const auto make : {sample_command, contours_command, reconstruct_command, check_command, canal_command,
                          anatomy_command, compare_command, save_command})
    commands.push_back(make(root));
  commands.push_back(keeping(web_command(root)));
  return commands;
}

}  // namespace odontoscope::app
