#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/foreign_input.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/structure_files.h"
#include "engine/app/volume_options.h"
#include "engine/app/words.h"
#include "recon/input/stack_json.h"

namespace odontoscope::app {
namespace {

struct ContoursArguments {
  std::vector<std::string> inputs;  // several meshes, or one of anything
  VolumeWords words;
  ForeignWords foreign;
  VoxelWords voxels;
  std::vector<std::string> outputs;
  bool histogram = false;
};

ValidStack read_told(const ContoursArguments& options, Session& session, Whence& whence) {
  if (options.inputs.size() > 1) return meshes_told(options.inputs, options.foreign, session);
  return converted_told(options.inputs.front(), options.foreign, session, &whence);
}

ContourStack stack_of(const ContoursArguments& options, Session& session, Whence& whence) {
  if (options.words.any_level())
    return contours_told(options.inputs.front(), understood(options.words), session, nullptr, nullptr, &whence);
  const ValidStack stack = read_told(options, session, whence);
  return options.words.simplify ? simplify_told(stack, {*options.words.simplify}, session) : *stack;
}

ExitCode show_histogram(const ContoursArguments& options, Session& session) {
  if (options.inputs.size() > 1) throw UsageError("--histogram looks at one volume", "Give one input");
  if (!options.outputs.empty() || options.words.any_level())
    throw UsageError("--histogram only looks at a volume", "Leave out -o, --iso and --label");
  tell_histogram(options.inputs.front(), understood(options.words), session);
  return ExitCode::done;
}

void refuse_senseless(const ContoursArguments& options) {
  if (options.outputs.empty())
    throw UsageError("-o is missing: nothing says where to write the contours",
                     "Give -o FILE.json, or look at a volume's values with --histogram");
  for (const std::string& output : options.outputs) {
    if (!is_structures_file(output)) known_ending(output, {".json", ".dcm", ".seg.dcm", ".seg.nrrd"});
  }
  if (options.inputs.size() > 1 && options.words.any_level())
    throw UsageError("--iso and --label are about one volume", "Give one input");
  if (options.inputs.size() == 1) refuse_volume_without_level(options.inputs.front(), options.words);
  refuse_senseless(options.foreign, options.words.any_level());
  refuse_senseless(options.voxels, options.outputs, options.words.any_level());
  if (options.words.reshape.any()) refuse_reshaped(options.outputs);
  if (options.words.any_level()) understood(options.words);
  refuse_unwritable({.inputs = options.inputs, .outputs = options.outputs});
}

ExitCode make_contours(const ContoursArguments& options, Session& session) {
  if (options.histogram) return show_histogram(options, session);
  refuse_senseless(options);
  Whence whence;
  const ContourStack stack = stack_of(options, session, whence);
  std::vector<FileContent> files;
  for (const std::string& output : options.outputs) {
    if (is_structures_file(output))
      files.push_back(structures_file(stack, output, options.voxels, whence, session));
    else
      files.push_back({output, to_json(stack)});
  }
  session.progress().check();
  write_all(files, session.interrupts);
  for (const std::string& output : options.outputs)
    session.console.say(fmt::format("{}: {}", output, stack_in_words(stack)));
  return ExitCode::done;
}

}  // namespace

Command contours_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("contours", "Contours of a volume, a mesh, or another program's contour file");
  parser->alias("section");  // of a model: the way back to contours
  const auto options = std::make_shared<ContoursArguments>();
  parser->add_option("INPUT", options->inputs, "Volume, mesh or meshes, or other program's contours; see below")
      ->required()
      ->type_name("");
  repeatable(
      parser->add_option("-o,--output", options->outputs, "File to write; its ending tells the format; repeatable"))
      ->type_name("FILE");
  parser
      ->add_flag("--histogram", options->histogram,
                 "Show the values of a volume and where they part, and write nothing")
      ->group("Volumes");
  add_volume_options(*parser, options->words);
  add_foreign_options(*parser, options->foreign);
  add_voxel_options(*parser, options->voxels);
  parser->footer(
      "Examples:\n"
      "  odontoscope contours tooth.nrrd --iso 120 -o tooth.json\n"
      "  odontoscope contours scan.nii.gz --histogram\n"
      "  odontoscope contours scan.nii.gz --iso auto --min-area 4 -o tooth.json\n"
      "  odontoscope contours scan.nii.gz --iso 120=dentine --iso 195=enamel --min-area 0.1mm2 -o tooth.json\n"
      "  odontoscope contours DICOM --series 2 --iso 120 -o tooth.json\n"
      "  odontoscope contours segmented.mha --label 1=tooth --label 2=pulp --simplify 0.05 -o tooth.json\n"
      "  odontoscope contours scan.stl --spacing-z 0.2 -o scan.json\n"
      "  odontoscope contours enamel.stl dentine.stl pulp.stl --spacing-z 0.2 -o tooth.json\n"
      "  odontoscope section molar.glb --at 4.5 --at 12 -o two.json\n"
      "  odontoscope contours series.ser --structure Cell -o cell.json\n"
      "  odontoscope contours rtss.dcm --structure Heart --repair -o heart.json\n"
      "  odontoscope contours DICOM --iso 120 -o tooth.dcm -o tooth.seg.dcm -o tooth.seg.nrrd\n"
      "\n"
      "INPUT is a volume (NRRD, NIfTI, MetaImage, DICOM file or folder), a mesh (glTF, STL, PLY, OBJ), contours of\n"
      "another program (Reconstruct series .ser, CSL, DICOM RTSTRUCT), or a contour stack to be repaired.\n"
      "Written are contour stacks (.json), DICOM structure sets (RTSTRUCT, .dcm) and segmentations (SEG,\n"
      ".seg.dcm), and label maps with names (.seg.nrrd); they refer to the DICOM series that was read.\n"
      "Several meshes are cut by the same planes, each as a structure called after its file.\n"
      "What a file is, is told by its content. --repair mends contours that cross, touch or repeat themselves, and\n"
      "small gaps of meshes, and lists every change; without it such input is refused. section is another name for\n"
      "this subcommand.\n");
  return {parser, [options](Session& session) { return make_contours(*options, session); }};
}

}  // namespace odontoscope::app
