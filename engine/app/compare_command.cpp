#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/comparison_drawn.h"
#include "engine/app/db_options.h"
#include "engine/app/dt_options.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/volume_options.h"
#include "engine/app/words.h"
#include "recon/compare/compare.h"
#include "recon/output/comparison_json.h"
#include "recon/output/comparison_page.h"

namespace odontoscope::app {
namespace {

struct CompareArguments {
  std::string input;
  VolumeWords words;
  DtWords dt;
  DbWords db;
  std::string report, html;
};

void refuse_senseless_comparison(const CompareArguments& options) {
  if (!options.report.empty()) known_ending(options.report, {".json"});
  if (!options.html.empty()) known_ending(options.html, {".html"});
  refuse_senseless(options.dt);
  refuse_volume_without_level(options.input, options.words);
}

void tell(const Comparison& comparison, Console& console) {
  constexpr std::size_t value_width = 18;
  std::size_t label_width = 0;
  const std::vector<ComparisonRow> rows = comparison_rows(comparison);
  for (const ComparisonRow& row : rows) label_width = std::max(label_width, row.what.size());
  const auto line = [&](const std::string& label, const std::vector<std::string>& values) {
    std::string text = fmt::format("{:<{}}", label, label_width);
    for (const std::string& value : values) text += fmt::format("{:>{}}", value, value_width);
    console.say(text);
  };
  std::vector<std::string> names;
  for (const ComparedMethod& method : comparison.methods) names.push_back(method.name);
  line("", names);
  for (const ComparisonRow& row : rows) line(row.what, row.values);
  console.say("");
  for (const ComparedPair& pair : comparison.pairs) {
    const SurfaceDistance& d = pair.distance;
    console.say(fmt::format("{} to {}: {} mm on average and {} mm at most; back: {} and {}",
                            comparison.methods[pair.first].name, comparison.methods[pair.second].name,
                            measured(d.a_to_b.mean), measured(d.a_to_b.largest), measured(d.b_to_a.mean),
                            measured(d.b_to_a.largest)));
  }
  for (const ComparedMethod& method : comparison.methods) {
    console.say(fmt::format("{}: {}", method.name, method.made_by));
    if (!method.verdict.empty()) console.say(method.verdict);
  }
}

ExitCode compare_methods(const CompareArguments& options, Session& session) {
  refuse_senseless_comparison(options);
  if (options.words.any_level()) understood(options.words);
  CompareOptions engines;
  engines.db = understood(options.db, session.threads);
  PlannedFiles files{.inputs = {options.input}, .outputs = {}};
  if (!options.dt.links.empty()) files.inputs.push_back(options.dt.links);
  for (const std::string& file : {options.report, options.html}) {
    if (!file.empty()) files.outputs.push_back(file);
  }
  refuse_unwritable(files);

  const ValidStack stack = contours_of_input(options.input, options.words, session);
  engines.dt = understood(options.dt, stack, session);
  Comparison comparison = compare(stack, engines, session.progress());
  const std::string no_pictures =
      options.report.empty() && options.html.empty() ? std::string() : add_comparison_pictures(comparison, session);
  std::vector<FileContent> contents;
  if (!options.report.empty()) contents.push_back({options.report, comparison_json(comparison)});
  if (!options.html.empty()) contents.push_back({options.html, comparison_page(comparison)});
  session.progress().check();
  write_all(contents, session.interrupts);
  tell(comparison, session.console);
  if (!no_pictures.empty())
    session.console.say(fmt::format("No pictures, and nothing about what is seen through: {}", no_pictures));
  for (const FileContent& file : contents) session.console.say(fmt::format("Wrote {}", file.file.string()));
  return ExitCode::done;
}

}  // namespace

Command compare_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("compare", "DT, DB and decimated DB of the same contours, side by side");
  const auto options = std::make_shared<CompareArguments>();
  parser->add_option("INPUT", options->input, "Contour stack (.json), or with --iso or --label a volume")
      ->required()
      ->type_name("");
  parser->add_option("--report", options->report, "All that was measured, for scripts")->type_name("FILE.json");
  parser->add_option("--html", options->html, "The same as a page, with pictures where this machine can draw")
      ->type_name("FILE.html");
  add_dt_options(*parser, options->dt);
  add_volume_options(*parser, options->words);
  add_db_options(*parser, options->db);
  parser->footer(
      "Examples:\n"
      "  odontoscope compare molar.json\n"
      "  odontoscope compare molar.json --grid 256 --cases consistent --html comparison.html\n"
      "  odontoscope compare tooth.nrrd --iso 120 --min-area 4 --decimate 8000 --report comparison.json\n"
      "\n"
      "DT is the Delaunay method, DB marching cubes over a distance field. Times are the least of up to three\n"
      "runs. docs/distance.md tells what each line means.\n");
  return {parser, [options](Session& session) { return compare_methods(*options, session); }};
}

}  // namespace odontoscope::app
