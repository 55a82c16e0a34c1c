#include <fmt/format.h>

#include <memory>
#include <string>

#include "engine/app/command.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/words.h"
#include "recon/input/stack_json.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::app {
namespace {

struct SampleArguments {
  ToothKind tooth = ToothKind::molar;
  SampleOptions sample;
  bool apart = false, filled = false, filled_dentine = false;
  std::string output;
};

ExitCode make_sample(const SampleArguments& options, Session& session) {
  known_ending(options.output, {".json"});
  refuse_unwritable({.inputs = {}, .outputs = {options.output}});
  SampleOptions sample = options.sample;
  if (options.apart || options.filled_dentine) sample.walls = SampleWalls::apart;
  if (options.filled) sample.walls = SampleWalls::filled;
  sample.hollow_dentine = !options.filled_dentine;
  const ContourStack stack = sample_tooth(options.tooth, sample);
  session.progress().check();
  write_all({{options.output, to_json(stack)}}, session.interrupts);
  session.console.say(fmt::format("{}: {}", options.output, stack_in_words(stack)));
  session.console.say(fmt::format("It is a generated {}.", sample_facts(options.tooth).tooth));
  return ExitCode::done;
}

}  // namespace

Command sample_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("sample", "Contours of a generated tooth with enamel, dentine and pulp");
  const auto options = std::make_shared<SampleArguments>();
  add_choice(*parser, "TOOTH", options->tooth, tooth_kinds, "molar, premolar or incisor")->required()->type_name("");
  parser->add_option("-o,--output", options->output, "The contour stack to write")->required()->type_name("FILE.json");
  parser
      ->add_option("--slice-spacing", options->sample.slice_spacing,
                   "Even distance of slices, mm (default: closer where it is steep)")
      ->type_name("MM");
  parser->add_option("--point-spacing", options->sample.point_spacing, "Largest distance of a contour's points, mm")
      ->type_name("MM")
      ->capture_default_str();
  CLI::Option* apart =
      parser->add_flag("--apart", options->apart, "A gap of 0.03 mm between structures, which share their walls else");
  CLI::Option* dentine = parser->add_flag("--filled-dentine", options->filled_dentine,
                                          "Apart, dentine without the pulp's hole: for --together dentine,pulp");
  parser->add_flag("--filled", options->filled, "Every structure filled, over those within it")
      ->excludes(apart)
      ->excludes(dentine);
  parser->add_flag("--open-apex", options->sample.open_apex,
                   "Canals leave the roots through their foramen, not blind 0.5 mm above");
  parser->footer(
      "Examples:\n"
      "  odontoscope sample molar -o molar.json\n"
      "  odontoscope sample molar --apart -o apart.json\n"
      "  odontoscope sample incisor --slice-spacing 0.1 -o fine.json\n"
      "\n"
      "The molar is a lower first molar: two roots, three canals, five cusps.\n");
  return {parser, [options](Session& session) { return make_sample(*options, session); }};
}

}  // namespace odontoscope::app
