#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/outputs.h"
#include "engine/app/plain_input.h"
#include "engine/app/sniff.h"
#include "engine/app/words.h"
#include "recon/core/read_file.h"
#include "recon/exchange/contour_file.h"
#include "recon/formats/read_mesh.h"
#include "recon/input/stack_json.h"
#include "recon/input/validate.h"
#include "recon/output/report_json.h"

namespace odontoscope::app {
namespace {

struct CheckArguments {
  std::string file;
  std::string report;
};

void tell_all_shells(const std::vector<Shell>& shells, Console& console) {
  constexpr std::size_t most_lines = 10;
  for (std::size_t i = 0; i < std::min(shells.size(), most_lines); ++i) console.say("  " + shell_in_words(shells[i]));
  if (shells.size() > most_lines) console.say(fmt::format("  and {} smaller ones", shells.size() - most_lines));
}

void tell_surface(const NamedSurfaceReport& mesh, Console& console) {
  const SurfaceReport& report = mesh.report;
  console.say(fmt::format("{}: {}, {}", mesh.name.empty() ? "surface" : mesh.name,
                          counted(report.triangles, "triangle"), counted(report.vertices, "vertex", "vertices")));
  tell_all_shells(report.shells, console);
  console.say(fmt::format("  smallest angle {} degrees (median {}), aspect ratio at most {} (median {})",
                          measured(report.smallest_angle_deg.min), measured(report.smallest_angle_deg.median),
                          measured(report.aspect_ratio.max), measured(report.aspect_ratio.median)));
  const std::vector<std::string> defects = defects_in_words(report);
  if (defects.empty())
    console.say("  closed, oriented and manifold");
  else
    console.say(fmt::format("  wanting: {}", fmt::join(defects, ", ")));
}

ExitCode check_meshes(const std::vector<NamedMesh>& meshes, const CheckArguments& options, Session& session) {
  std::vector<NamedSurfaceReport> reports;
  for (const NamedMesh& mesh : meshes) {
    session.progress().check();
    reports.push_back({mesh.name, inspect(mesh.surface)});
    tell_surface(reports.back(), session.console);
    for (const std::string& remark : mesh.remarks) session.console.say("  " + remark);
  }
  if (!options.report.empty()) {
    write_all({{options.report, surface_report_json(options.file, reports)}}, session.interrupts);
  }
  const bool sound = std::all_of(reports.begin(), reports.end(),
                                 [](const NamedSurfaceReport& mesh) { return mesh.report.closed_oriented_manifold(); });
  session.console.say(fmt::format("{}: {}", options.file, sound ? "sound" : "found wanting"));
  return sound ? ExitCode::done : ExitCode::found_wanting;
}

ExitCode check_stack(const ContourStack& stack, const CheckArguments& options, Session& session) {
  validate(stack, session.progress());
  session.console.say(fmt::format("{}: {}", options.file, stack_in_words(stack)));
  std::vector<double> heights;
  for (const Slice& slice : stack.slices) heights.push_back(slice.z);
  std::sort(heights.begin(), heights.end());
  double narrowest = heights[1] - heights[0], widest = narrowest;
  for (std::size_t i = 1; i < heights.size(); ++i) {
    narrowest = std::min(narrowest, heights[i] - heights[i - 1]);
    widest = std::max(widest, heights[i] - heights[i - 1]);
  }
  session.console.say(fmt::format("  slices {} to {} mm apart", measured(narrowest), measured(widest)));
  session.console.say("  every contour is simple, and those of a structure are disjoint: sound");
  return ExitCode::done;
}

[[noreturn]] void refuse_to_check(FileKind kind, const std::string& file) {
  if (kind == FileKind::volume) {
    throw UsageError(fmt::format("{} is a volume image; check judges contour stacks and meshes", file),
                     fmt::format("Contours of it: odontoscope contours {} --iso T -o FILE.json", file));
  }
  refuse_empty(file);
  Place place;
  place.file = file;
  throw InputError("unknown-format", std::move(place),
                   "this is neither a contour stack nor a glTF, STL, PLY or OBJ mesh",
                   "Give a file of one of these formats");
}

void refuse_report(const CheckArguments& options) {
  if (!options.report.empty()) throw UsageError("--report is for meshes, and this is a contour stack", "Leave it out");
}

ExitCode check(const CheckArguments& options, Session& session) {
  if (!options.report.empty()) {
    known_ending(options.report, {".json"});
    refuse_unwritable({.inputs = {options.file}, .outputs = {options.report}});
  }
  const std::string bytes = read_file(options.file, limits::file_bytes, session.progress().stop);
  if (const auto kind = contour_file_kind(bytes)) {
    refuse_report(options);
    return check_stack(read_contour_file(*kind, bytes, options.file).stack, options, session);
  }
  const FileKind kind = kind_of(bytes, options.file);
  if (const auto meshes = meshes_in(kind, bytes, options.file)) return check_meshes(*meshes, options, session);
  if (kind != FileKind::contour_stack) refuse_to_check(kind, options.file);
  refuse_report(options);
  return check_stack(parse_stack(bytes, options.file), options, session);
}

}  // namespace

Command check_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("check", "Judge a mesh or a contour stack; exit code 1 if found wanting");
  const auto options = std::make_shared<CheckArguments>();
  parser->add_option("FILE", options->file, "Mesh (GLB, glTF, STL, PLY, OBJ) or contours; told by its content")
      ->required()
      ->type_name("");
  parser->add_option("--report", options->report, "What was found in a mesh, for scripts")->type_name("FILE.json");
  parser->footer(
      "Examples:\n"
      "  odontoscope check molar.glb\n"
      "  odontoscope check scan.stl --report scan-report.json\n"
      "  odontoscope check --quiet model.stl && echo closed and oriented\n"
      "\n"
      "A mesh is sound if it is closed, oriented and manifold everywhere; a contour stack if every\n"
      "contour is simple and those of one structure are disjoint.\n");
  return {parser, [options](Session& session) { return check(*options, session); }};
}

}  // namespace odontoscope::app
