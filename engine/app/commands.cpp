#include "engine/app/command.h"

namespace odontoscope::app {

const char* first_steps() {
  return "First steps:\n"
         "  odontoscope sample molar -o molar.json                contours of a generated tooth\n"
         "  odontoscope reconstruct molar.json -o molar.glb       contours to a solid model\n"
         "  odontoscope view molar.glb                            look at it, turn it, cut it open\n"
         "  odontoscope render molar.glb -o molar.png             a picture of it\n"
         "  odontoscope web molar.json -o molar.html              a page to look at it in any browser\n"
         "  odontoscope anatomy molar.json                        its canals in numbers\n"
         "  odontoscope check molar.glb                           is it closed and oriented?\n"
         "  odontoscope reconstruct scan.nrrd --iso 120 -o t.stl  straight from a CT volume\n"
         "\n"
         "Every subcommand explains itself: odontoscope reconstruct --help\n"
         "\n"
         "Exit codes: 0 done, 1 checked and found wanting, 2 wrong command line, 3 bad input,\n"
         "            4 cannot read or write, 5 cannot draw on this machine, 70 a bug of ours,\n"
         "            130 stopped by Ctrl-C. Unless it is 0 or 1, no output file was touched.\n";
}

std::vector<Command> add_commands(CLI::App& root) {
  std::vector<Command> commands;
  for (const auto make : {sample_command, contours_command, reconstruct_command, check_command, render_command,
                          view_command, web_command, compare_command, canal_command, anatomy_command, figures_command,
                          corpus_command, batch_command, compare_images_command})
    commands.push_back(make(root));
  return commands;
}

}  // namespace odontoscope::app
