#include <fmt/format.h>

#include <memory>
#include <string>

#include "engine/app/command.h"
#include "engine/app/outputs.h"
#include "engine/app/volume_options.h"
#include "engine/app/words.h"
#include "recon/input/stack_json.h"

namespace odontoscope::app {
namespace {

struct Options {
  std::string volume;
  VolumeWords words;
  std::string output;
};

ExitCode make_contours(const Options& options, Session& session) {
  known_ending(options.output, {".json"});
  if (!options.words.any_level()) {
    throw UsageError("nothing says where in the volume the surface lies",
                     "Give --iso T for an image, --label N for a label map");
  }
  const VolumeContourOptions wanted = understood(options.words);
  refuse_unwritable({.inputs = {options.volume}, .outputs = {options.output}});
  const ContourStack stack = contours_told(options.volume, wanted, session);
  const std::string text = to_json(stack);
  session.progress().check();
  write_all({{options.output, text}}, session.interrupts);
  session.console.say(fmt::format("{}: {}", options.output, stack_in_words(stack)));
  return ExitCode::done;
}

}  // namespace

Command contours_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("contours", "Contours of a CT volume or label map, slice by slice");
  const auto options = std::make_shared<Options>();
  parser->add_option("VOLUME", options->volume, "NRRD, NIfTI or MetaImage file, DICOM file or folder")
      ->required()
      ->type_name("");
  parser->add_option("-o,--output", options->output, "The contour stack to write")->required()->type_name("FILE.json");
  add_volume_options(*parser, options->words);
  parser->footer(
      "Examples:\n"
      "  odontoscope contours tooth.nrrd --iso 120 -o tooth.json\n"
      "  odontoscope contours scan.nii.gz --iso 120=dentine --iso 195=enamel --min-area 0.1 -o tooth.json\n"
      "  odontoscope contours segmented.mha --label 1=tooth --label 2=pulp --simplify 0.05 -o tooth.json\n");
  return {parser, [options](Session& session) { return make_contours(*options, session); }};
}

}  // namespace odontoscope::app
