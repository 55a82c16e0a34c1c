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

struct AnatomyArguments {
  std::string input;
  DtWords dt;
  VolumeWords volume;
  std::vector<std::string> outputs;
};

std::string place(const Point3& p) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", p.x, p.y, p.z); }

bool passes(const CanalGraph& graph, std::size_t canal, std::size_t node) {
  return std::any_of(graph.parts.begin(), graph.parts.end(), [&](const CanalPart& part) {
    return (part.from == node || part.to == node) &&
           std::find(part.canals.begin(), part.canals.end(), canal) != part.canals.end();
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
  if (open)
    console.say(
        "What is open has no inside. \"odontoscope check\" tells where, \"odontoscope contours --repair\" closes "
        "gaps.");
}

/// "12.3 \u00b10.25"
std::string with(double value, double off) {
  return fmt::format("{} \u00b1{}", measured(value), fmt::format("{:.2g}", off));
}

void tell_canals(const Anatomy& anatomy, Console& console) {
  if (anatomy.canals.empty()) return;
  console.say(fmt::format("\n{:<20} {:>13} {:>13} {:>13} {:>13} {:>13} {:>13}", "canal, mm", "length", "Schneider",
                          "bend", "mean", "narrowest", "thinnest"));
  for (std::size_t c = 0; c < anatomy.canals.size(); ++c) {
    const MeasuredCanal& canal = anatomy.canals[c];
    const CanalUncertainty& off = anatomy.uncertainties[c];
    console.say(fmt::format(
        "{:<20} {:>13} {:>13} {:>13} {:>13} {:>13} {:>13}", canal.name, with(canal.length, off.length),
        fmt::format("{:.1f}\u00b0 \u00b1{:.1f}", canal.schneider_deg, off.schneider_deg),
        std::isfinite(canal.smallest_bend) ? with(canal.smallest_bend, off.smallest_bend) : "-",
        with(canal.mean_width, off.mean_width), canal.narrowest ? with(canal.narrowest->width, off.narrowest) : "-",
        canal.thinnest_wall ? with(canal.thinnest_wall->width, off.thinnest_wall) : "-"));
  }
  console.say(fmt::format("  \u00b1: how far a figure may be off because of slices {} mm apart",
                          measured(anatomy.slice_spacing)));
  for (std::size_t c = 0; c < anatomy.canals.size(); ++c) {
    const MeasuredCanal& canal = anatomy.canals[c];
    const CanalShape& shape = anatomy.shapes[c];
    console.say(
        fmt::format("  {}: {}{}", canal.name,
                    canal.narrowest ? "narrowest at " + place(canal.narrowest->at) : "too short for a narrowest place",
                    canal.thinnest_wall ? ", wall thinnest at " + place(canal.thinnest_wall->at) : ""));
    console.say(fmt::format("    coronal, middle, apical third {}, {}, {} mm^3{}", measured(shape.thirds[0].volume),
                            measured(shape.thirds[1].volume), measured(shape.thirds[2].volume),
                            shape.structure_model_index
                                ? fmt::format("; structure model index {:.2f}", *shape.structure_model_index)
                                : ""));
    std::string sections;
    for (const ApicalSection& section : shape.apical)
      sections += fmt::format("{}{} mm ({} mm^2) at {:.0f} mm", sections.empty() ? "" : ", ", measured(section.width),
                              measured(section.area), section.from_apex);
    if (!sections.empty()) console.say(fmt::format("    from the apex: {}", sections));
  }
}

void tell_roots(const Anatomy& anatomy, Console& console) {
  for (const MeasuredRoot& root : anatomy.roots) {
    std::string names, sections;
    for (const std::size_t c : root.canals) names += (names.empty() ? "" : ", ") + anatomy.canals[c].name;
    for (const std::size_t n : root.sections) sections += (sections.empty() ? "" : "-") + std::to_string(n);
    console.say(fmt::format("Root with {}: {}, Vertucci {}", names,
                            sections.empty() ? "too short to count sections" : sections, root.vertucci));
    if (root.uncounted > 0)
      console.say(fmt::format("  {} of this root {} not counted in its type",
                              counted(root.uncounted, "shorter branch", "shorter branches"),
                              root.uncounted == 1 ? "is" : "are"));
    for (const Isthmus& one : root.isthmuses)
      console.say(fmt::format("  isthmus of type {} (Hsu and Kim) between {} and {}, {} to {} mm above the apex{}",
                              one.type, anatomy.canals[one.one].name, anatomy.canals[one.other].name,
                              measured(one.from_apex), measured(one.to_apex),
                              one.type == "IV" ? "" : fmt::format(", {} mm wide", measured(one.narrowest))));
  }
  if (const std::string code = ahmed_code(anatomy.roots); !code.empty())
    console.say(fmt::format("Ahmed's code: {}", code));
  constexpr const char* thirds[3] = {"coronal", "middle", "apical"};
  for (const AccessoryCanal& one : anatomy.accessory_canals)
    console.say(fmt::format("  accessory canal ({}) from the {} third of {}: {} mm long, {} mm wide, to {}", one.name,
                            thirds[one.third], anatomy.canals[one.canal].name, measured(one.length),
                            measured(one.mean_width), place(one.end)));
}

void tell(const Anatomy& anatomy, const std::vector<NamedMesh>& whole, Console& console) {
  console.say(fmt::format("{:<24} {:>14} {:>16}", "structure", "volume, mm^3", "outside, mm^2"));
  for (const MeasuredStructure& structure : anatomy.structures)
    console.say(
        fmt::format("{:<24} {:>14} {:>16}", structure.name, measured(structure.volume), measured(structure.area)));
  if (anatomy.cavity_of.empty()) {
    console.say(std::string("No void inside. ") + what_a_void_takes);
    tell_open(whole, console);
    return;
  }
  console.say(fmt::format("{:<24} {:>14} {:>16}",
                          (anatomy.mouths.empty() ? "void in " : "hollow of ") + anatomy.cavity_of,
                          measured(anatomy.cavity_volume), measured(anatomy.cavity_area)));
  for (const Cavity::Mouth& mouth : anatomy.mouths)
    console.say(fmt::format("  opens to the outside at {}, {} mm^2: closed there by a flat cap", place(mouth.at),
                            measured(mouth.area)));
  if (anatomy.axis.own)
    console.say(
        fmt::format("The tooth leans by {:.0f}\u00b0 from z: measured along its own axis, the principal axis of its "
                    "solids, ({:.3f}, {:.3f}, {:.3f}).",
                    anatomy.axis.tilt_deg, anatomy.axis.along.x, anatomy.axis.along.y, anatomy.axis.along.z));
  if (anatomy.loose.count > 0)
    console.complain(
        fmt::format("warning: beside this void \"{}\" has {}, {} mm^3 in all, that {} not joined to it and not "
                    "measured: bubbles, or a canal that falls to pieces between slices.",
                    anatomy.cavity_of, counted(anatomy.loose.count, "loose piece"), measured(anatomy.loose.volume),
                    anatomy.loose.count == 1 ? "is" : "are"));
  console.say(fmt::format("\nChamber {} mm wide; {}, {}, {}.", measured(anatomy.chamber_width),
                          counted(anatomy.canals.size(), "canal"), counted(anatomy.horns, "horn"),
                          counted(anatomy.other_branches, "shorter branch", "shorter branches")));
  tell_canals(anatomy, console);
  for (const Opening& opening : anatomy.openings)
    console.say(fmt::format("  {} opens to the outside at {}: there is no wall", anatomy.canals[opening.canal].name,
                            place(opening.at)));
  if (anatomy.handles > 0)
    console.say(
        fmt::format("{}: canals join again, or something stands in the chamber.", counted(anatomy.handles, "handle")));
  if (anatomy.narrow_handles > 0)
    console.say(fmt::format(
        "The void's wall has {} narrower than half a canal, as they come about between slices: not counted.",
        counted(anatomy.narrow_handles, "handle")));
  for (std::size_t node = 1; node < anatomy.graph.nodes.size(); ++node) {
    const std::string kind = anatomy.graph.kind(node);
    if (kind == "end") continue;
    std::string names;
    for (std::size_t c = 0; c < anatomy.canals.size(); ++c)
      if (passes(anatomy.graph, c, node)) names += (names.empty() ? "" : ", ") + anatomy.canals[c].name;
    console.say(fmt::format("  {}: {} at {}", names,
                            kind == "fork"   ? "part"
                            : kind == "join" ? "join"
                                             : "join and part again",
                            place(anatomy.graph.nodes[node])));
  }
  tell_roots(anatomy, console);
  if (anatomy.roots.empty() && !anatomy.canals.empty())
    console.say("The outside of the tooth is not there: no walls, no roots.");
}

ExitCode run(const AnatomyArguments& options, Session& session) {
  PlannedFiles files;
  for (const std::string& file : options.outputs) known_ending(file, {".json", ".csv"});
  files.outputs = options.outputs;
  refuse_senseless(options.dt);
  for (const std::string* input : {&options.input, &options.dt.links})
    if (!input->empty()) files.inputs.push_back(*input);
  refuse_unwritable(files);
  const Shown shown = shown_from(options.input, options.volume, options.dt, session);
  const std::vector<NamedMesh> whole = whole_structures(shown.surfaces);
  const Anatomy anatomy = measure_anatomy(looked_at(whole), session.progress(), shown.slices);
  std::vector<FileContent> contents;
  for (const std::string& file : options.outputs)
    contents.push_back({file, known_ending(file, {".json", ".csv"}) == ".csv"
                                  ? anatomy_csv(anatomy)
                                  : anatomy_json(anatomy, options.input.empty() ? "sample molar" : options.input)});
  session.progress().check();
  write_all(contents, session.interrupts);
  tell(anatomy, whole, session.console);
  for (const FileContent& file : contents) session.console.say(fmt::format("Wrote {}", file.file.string()));
  return anatomy.cavity_of.empty() ? ExitCode::found_wanting : ExitCode::done;
}

}  // namespace

Command anatomy_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("anatomy", "Volumes, canals, widths, walls and branching in numbers");
  const auto options = std::make_shared<AnatomyArguments>();
  parser->add_option("INPUT", options->input, "Contour stack, mesh, or with --iso a volume; none: the sample molar")
      ->type_name("");
  repeatable(parser->add_option("-o,--output", options->outputs, "All as JSON, or one row a canal as CSV; repeatable"))
      ->type_name("FILE.json|.csv");
  add_dt_options(*parser, options->dt);
  add_partition_options(*parser, options->dt.partition);
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
