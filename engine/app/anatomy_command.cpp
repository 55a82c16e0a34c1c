#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/shown_input.h"
#include "engine/app/whole_structures.h"
#include "engine/app/words.h"
#include "recon/cavity/anatomy.h"
#include "recon/mesh/surface_report.h"
#include "recon/output/anatomy_text.h"

namespace odontoscope::app {
namespace {

struct Options {
  std::string input;
  VolumeWords volume;
  std::vector<std::string> outputs;
};

std::string place(const Point3& p) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", p.x, p.y, p.z); }

bool passes(const CanalGraph& graph, std::size_t canal, std::size_t node) {
  return std::any_of(graph.parts.begin(), graph.parts.end(), [&](const CanalPart& part) {
    return (part.from == node || part.to == node) && std::find(part.canals.begin(), part.canals.end(), canal) != part.canals.end();
  });
}

/// An open surface has no inside, so that no void can be found in it.
void tell_open(const std::vector<NamedMesh>& whole, Console& console) {
  bool open = false;
  for (const NamedMesh& solid : whole) {
    const std::size_t edges = inspect(solid.surface).boundary_edges;
    if (edges == 0) continue;
    open = true;
    console.say(fmt::format("\"{}\" is open: {}.", solid.name, counted(edges, "border edge")));
  }
  if (open) console.say("What is open has no inside. \"odontoscope check\" tells where, \"odontoscope contours --repair\" closes gaps.");
}

void tell(const Anatomy& anatomy, const std::vector<NamedMesh>& whole, Console& console) {
  console.say(fmt::format("{:<24} {:>14} {:>16}", "structure", "volume, mm^3", "outside, mm^2"));
  for (const MeasuredStructure& structure : anatomy.structures)
    console.say(fmt::format("{:<24} {:>14} {:>16}", structure.name, measured(structure.volume), measured(structure.area)));
  if (anatomy.cavity_of.empty()) {
    console.say(std::string("No void inside. ") + what_a_void_takes);
    tell_open(whole, console);
    return;
  }
  console.say(fmt::format("{:<24} {:>14} {:>16}", (anatomy.mouths.empty() ? "void in " : "hollow of ") + anatomy.cavity_of, measured(anatomy.cavity_volume), measured(anatomy.cavity_area)));
  for (const Cavity::Mouth& mouth : anatomy.mouths)
    console.say(fmt::format("  opens to the outside at {}, {} mm^2: closed there by a flat cap", place(mouth.at), measured(mouth.area)));
  console.say(fmt::format("\nChamber {} mm wide; {}, {}, {}.", measured(anatomy.chamber_width), counted(anatomy.canals.size(), "canal"),
                          counted(anatomy.horns, "horn"), counted(anatomy.other_branches, "shorter branch", "shorter branches")));
  if (!anatomy.canals.empty())
    console.say(fmt::format("\n{:<20} {:>8} {:>10} {:>8} {:>8} {:>10} {:>10}", "canal, mm", "length", "Schneider", "bend", "mean", "narrowest", "thinnest"));
  for (const MeasuredCanal& canal : anatomy.canals)
    console.say(fmt::format("{:<20} {:>8} {:>9.1f}\u00b0 {:>8} {:>8} {:>10} {:>10}", canal.name, measured(canal.length), canal.schneider_deg,
                            std::isfinite(canal.smallest_bend) ? measured(canal.smallest_bend) : "-", measured(canal.mean_width),
                            canal.narrowest ? measured(canal.narrowest->width) : "-", canal.thinnest_wall ? measured(canal.thinnest_wall->width) : "-"));
  for (const MeasuredCanal& canal : anatomy.canals)
    console.say(fmt::format("  {}: {}{}", canal.name, canal.narrowest ? "narrowest at " + place(canal.narrowest->at) : "too short for a narrowest place",
                            canal.thinnest_wall ? ", wall thinnest at " + place(canal.thinnest_wall->at) : ""));
  if (anatomy.handles > 0)
    console.say(fmt::format("{}: canals join again, or something stands in the chamber.", counted(static_cast<std::size_t>(anatomy.handles), "handle")));
  for (std::size_t node = 1; node < anatomy.graph.nodes.size(); ++node) {
    const std::string kind = anatomy.graph.kind(node);
    if (kind == "end") continue;
    std::string names;
    for (std::size_t c = 0; c < anatomy.canals.size(); ++c)
      if (passes(anatomy.graph, c, node)) names += (names.empty() ? "" : ", ") + anatomy.canals[c].name;
    console.say(fmt::format("  {}: {} at {}", names, kind == "fork" ? "part" : kind == "join" ? "join" : "join and part again", place(anatomy.graph.nodes[node])));
  }
  for (const MeasuredRoot& root : anatomy.roots) {
    std::string names, sections;
    for (const std::size_t c : root.canals) names += (names.empty() ? "" : ", ") + anatomy.canals[c].name;
    for (const std::size_t n : root.sections) sections += (sections.empty() ? "" : "-") + std::to_string(n);
    console.say(fmt::format("Root with {}: {}, Vertucci {}", names, sections.empty() ? "too short to count sections" : sections, root.vertucci));
    if (root.uncounted > 0)
      console.say(fmt::format("  {} of this root {} not counted in its type", counted(root.uncounted, "shorter branch", "shorter branches"), root.uncounted == 1 ? "is" : "are"));
  }
  if (anatomy.roots.empty() && !anatomy.canals.empty()) console.say("The outside of the tooth is not there: no walls, no roots.");
}

ExitCode run(const Options& options, Session& session) {
  PlannedFiles files;
  for (const std::string& file : options.outputs) known_ending(file, {".json", ".csv"});
  files.outputs = options.outputs;
  if (!options.input.empty()) files.inputs.push_back(options.input);
  refuse_unwritable(files);
  const Shown shown = shown_from(options.input, options.volume, session);
  const std::vector<NamedMesh> whole = whole_structures(shown.surfaces);
  const Anatomy anatomy = measure_anatomy(looked_at(whole), session.progress());
  std::vector<FileContent> contents;
  for (const std::string& file : options.outputs)
    contents.push_back({file, known_ending(file, {".json", ".csv"}) == ".csv" ? anatomy_csv(anatomy) : anatomy_json(anatomy, options.input.empty() ? "sample molar" : options.input)});
  session.progress().check();
  write_all(contents, session.interrupts);
  tell(anatomy, whole, session.console);
  for (const FileContent& file : contents) session.console.say(fmt::format("Wrote {}", file.file.string()));
  return anatomy.cavity_of.empty() ? ExitCode::found_wanting : ExitCode::done;
}

}  // namespace

Command anatomy_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("anatomy", "Volumes, canals, widths, walls and branching in numbers");
  const auto options = std::make_shared<Options>();
  parser->add_option("INPUT", options->input, "Contour stack, mesh, or with --iso a volume; none: the sample molar")->type_name("");
  repeatable(parser->add_option("-o,--output", options->outputs, "All as JSON, or one row a canal as CSV; repeatable"))->type_name("FILE.json|.csv");
  add_volume_options(*parser, options->volume);
  parser->footer(
      "Examples:\n"
      "  odontoscope anatomy\n"
      "  odontoscope anatomy molar.json -o molar-anatomy.json -o canals.csv\n"
      "  odontoscope anatomy tooth.nrrd --iso 120 --min-area 4\n"
      "\n"
      "Lengths in mm, as the input has them. docs/navigation.md says how each is measured. Exit code 1: there is\n"
      "no void inside.\n");
  return {parser, [options](Session& session) { return run(*options, session); }};
}

}  // namespace odontoscope::app
