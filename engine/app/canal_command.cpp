#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/words.h"
#include "recon/compare/canal.h"
#include "recon/output/canal_plot.h"
#include "recon/output/comparison_json.h"

namespace odontoscope::app {
namespace {

struct CanalArguments {
  double width = CanalTooth{}.canal;
  std::vector<int> grids;
  std::string plot, report;
};

void tell(const CanalExperiment& experiment, Console& console) {
  const auto words = [&](const CanalResult& result) {
    return fmt::format("{}; a hole in {} of {} slices, genus {}, {}", result.open_through ? "open" : "closed",
                       result.open_slices, experiment.slices, result.genus, counted(result.surfaces, "surface"));
  };
  console.say(fmt::format("A canal of {} mm in a tooth of 10 mm, {}:", measured(experiment.tooth.canal),
                          counted(experiment.slices, "slice")));
  console.say(fmt::format("DT:          {}", words(experiment.dt)));
  for (const CanalResult& result : experiment.db)
    console.say(fmt::format("DB grid {:>4}: {}", result.grid, words(result)));
}

ExitCode run_experiment(const CanalArguments& options, Session& session) {
  if (!options.plot.empty()) known_ending(options.plot, {".svg"});
  if (!options.report.empty()) known_ending(options.report, {".json"});
  PlannedFiles files;
  for (const std::string& file : {options.plot, options.report}) {
    if (!file.empty()) files.outputs.push_back(file);
  }
  refuse_unwritable(files);
  CanalOptions experiment;
  experiment.tooth.canal = options.width;
  experiment.threads = session.threads;
  for (const int grid : options.grids) experiment.grids.push_back(static_cast<std::size_t>(grid));
  const CanalExperiment result = canal_experiment(experiment, session.progress());
  std::vector<FileContent> contents;
  if (!options.plot.empty()) contents.push_back({options.plot, canal_plot(result)});
  if (!options.report.empty()) contents.push_back({options.report, canal_json(result)});
  session.progress().check();
  write_all(contents, session.interrupts);
  tell(result, session.console);
  for (const FileContent& file : contents) session.console.say(fmt::format("Wrote {}", file.file.string()));
  return ExitCode::done;
}

}  // namespace

Command canal_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("canal", "Experiment: which grids keep a thin root canal open");
  const auto options = std::make_shared<CanalArguments>();
  constexpr int most_points = 2048;
  parser->add_option("--width", options->width, "Width of the canal, mm (default: 0.25)")->type_name("MM");
  repeatable(
      parser->add_option("--grid", options->grids, "Grid points along x and y; repeatable (default: 16 to 128 by 4)"))
      ->type_name("N")
      ->check(whole_number_from_one_to(most_points));
  parser->add_option("-o,--output", options->plot, "Plot of survival over grid size")->type_name("FILE.svg");
  parser->add_option("--report", options->report, "The same as numbers")->type_name("FILE.json");
  parser->footer(
      "Examples:\n"
      "  odontoscope canal -o canal.svg\n"
      "  odontoscope canal --width 0.4 --grid 32 --grid 64 --report canal.json\n"
      "\n"
      "A tooth of 10 mm with one canal from end to end is reconstructed by DT and by DB on many grids, with\n"
      "the consistent table. Open means: one surface of genus 1.\n");
  return {parser, [options](Session& session) { return run_experiment(*options, session); }};
}

}  // namespace odontoscope::app
