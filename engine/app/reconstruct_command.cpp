#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/db_options.h"
#include "engine/app/dt_options.h"
#include "engine/app/foreign_input.h"
#include "engine/app/made_model.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/structure_files.h"
#include "engine/app/tour_cameras.h"
#include "engine/app/volume_options.h"
#include "recon/core/limits.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/delaunay/verdict.h"
#include "recon/input/validate.h"
#include "recon/output/model_file.h"
#include "recon/output/report_json.h"

namespace odontoscope::app {
namespace {

enum class Method { dt, db };

struct ReconstructArguments {
  std::string input;
  Method method = Method::dt;
  VolumeWords words;
  ForeignWords foreign;
  VoxelWords voxels;
  DbWords db;
  DtWords dt;
  std::vector<std::string> together;  // "A,B"
  std::optional<int> triangles;
  std::optional<std::string> elements;  // size in mm, or "quality"
  bool strict = false;
  std::vector<std::string> outputs;
  bool tours = false, compress = false, see_through = false, variants = false, hotspots = false, as_given = false;
  std::string report;
};

void refuse_other_methods_options(const ReconstructArguments& options) {
  if (options.method == Method::dt) {
    if (!options.db.any()) return;
    throw UsageError("--grid, --cases, --field, --split and --decimate are about the DB method", "Add --method db");
  }
  if (options.triangles || options.strict || options.elements)
    throw UsageError("--triangles, --elements and --strict are about the DT method", "Use --decimate with --method db");
  if (!options.dt.any()) return;
  throw UsageError(
      "--correspondence, --between, --links, --link and --unlink are about the DT method; DB connects whatever "
      "overlaps",
      "Leave them out, or part slices with --split");
}

void refuse_tetrahedra_of_db(const std::string& output) {
  const std::string ending = known_ending(output, model_endings());
  const auto& endings = tetrahedra_endings();
  if (std::find(endings.begin(), endings.end(), ending) == endings.end()) return;
  throw UsageError(fmt::format("{}: {} holds tetrahedra, and the DB method makes only a surface", output, ending),
                   fmt::format("Use {}", fmt::join(surface_endings(), ", ")));
}

void refuse_voxels_of_db(const std::string& output) {
  throw UsageError(fmt::format("{}: surfaces of the DB method may be open, and have no inside", output),
                   "Use --method dt");
}

bool is_gltf(const std::string& output) {
  if (is_structures_file(output)) return false;
  const std::string ending = known_ending(output, model_endings());
  return ending == ".glb" || ending == ".gltf";
}

void refuse_senseless_as_given(const ReconstructArguments& options) {
  if (!options.words.reshape.upright)
    throw UsageError("--as-given is about --upright", "Add --upright, or leave it out");
  if (options.method == Method::db)
    throw UsageError("--as-given is about the DT method", "Leave it out: the report's matrix tells the turn");
  for (const std::string& output : options.outputs) {
    if (known_ending(output, model_endings()) != ".inp") continue;
    throw UsageError("--as-given: .inp names the nodes of the first and last slice, which would lie aslant",
                     "Leave it out: the report's matrix tells the turn");
  }
}

void refuse_with_partition(const ReconstructArguments& options) {
  if (!options.dt.partition.wanted) return;
  if (options.method == Method::db) throw UsageError("--partition is about the DT method", "Use --method dt");
  if (!options.together.empty())
    throw UsageError("--together makes one solid of structures, --partition keeps them apart", "Use one of the two");
}

void refuse_senseless_elements(const ReconstructArguments& options) {
  if (!options.elements) return;
  element_size_from(*options.elements);
  if (options.triangles)
    throw UsageError("--elements and --triangles both make the surfaces anew", "Use one of the two");
}

void refuse_senseless(const ReconstructArguments& options) {
  refuse_other_methods_options(options);
  refuse_with_partition(options);
  refuse_senseless(options.foreign, options.words.any_level());
  for (const std::string& output : options.outputs) {
    if (is_structures_file(output)) {
      if (options.method == Method::db) refuse_voxels_of_db(output);
      continue;
    }
    if (options.method == Method::db) refuse_tetrahedra_of_db(output);
    known_ending(output, model_endings());
  }
  const char* of_gltf_alone = options.tours      ? "--tours: only .glb and .gltf hold cameras that move"
                              : options.compress ? "--compress: only .glb and .gltf are written compressed"
                              : options.see_through
                                  ? "--see-through: only .glb and .gltf have materials that are seen through"
                              : options.variants ? "--variants: only .glb and .gltf have variants of materials"
                              : options.hotspots ? "--hotspots: only .glb and .gltf have places with names"
                                                 : nullptr;
  if (of_gltf_alone && std::none_of(options.outputs.begin(), options.outputs.end(), is_gltf))
    throw UsageError(of_gltf_alone, "Write one of these too: -o model.glb");
  if (options.as_given) refuse_senseless_as_given(options);
  refuse_senseless_elements(options);
  if (options.words.reshape.any()) refuse_reshaped(options.outputs);
  if (!options.report.empty()) known_ending(options.report, {".json"});
  for (const std::string& list : options.together) names_in(list, "--together");
  refuse_senseless(options.dt);
  refuse_volume_without_level(options.input, options.words);
  refuse_senseless(options.voxels, options.outputs, options.words.any_level());
}

PlannedFiles planned_files(const ReconstructArguments& options) {
  PlannedFiles files{.inputs = {options.input}, .outputs = options.outputs};
  if (!options.dt.links.empty()) files.inputs.push_back(options.dt.links);
  if (!options.report.empty()) files.outputs.push_back(options.report);
  return files;
}

/// What a method made: files still to be written, and what to say once they are.
struct Made {
  std::vector<FileContent> files;
  std::function<void(double seconds, Console& console)> tell;
  std::vector<CameraPath> paths;
  std::string missed, absurd;          // of --triangles: what to warn of, or empty
  std::vector<std::string> look_here;  // an amber verdict's places
};

/// The model in each format that was asked for. `Made::tell` is left to the caller.
template <class MadeModel>
Made files_of(const MadeModel& model, const ReconstructArguments& options, Session& session) {
  Made made;
  std::optional<CentreLines> lines;
  if (options.tours || options.hotspots) lines = lines_inside(model, options.tours ? "--tours" : "--hotspots", session);
  if (options.tours) made.paths = tour_cameras(model, *lines);
  GlbOptions glb{.paths = made.paths,
                 .compressed = options.compress,
                 .see_through = options.see_through,
                 .variants = options.variants};
  if (options.hotspots) glb.hotspots = hotspots_of(*lines);
  for (const std::string& output : options.outputs) {
    if (!is_structures_file(output)) made.files.push_back(model_file(model, output, glb));
  }
  return made;
}

void tell_tours(const std::vector<CameraPath>& paths, Console& console) {
  std::string words;
  for (const CameraPath& path : paths)
    words += fmt::format("{}{} ({:.0f} s)", words.empty() ? "" : ", ", path.name, path.keys.back().seconds);
  if (!words.empty()) console.say("Tours: " + words);
}

/// Of the full solid, whatever --triangles says.
std::vector<FileContent> structure_files(const Reconstruction& model, const ContourStack& stack, const Whence& whence,
                                         const ReconstructArguments& options, Session& session) {
  std::vector<FileContent> files;
  for (const std::string& output : options.outputs) {
    if (is_structures_file(output))
      files.push_back(structures_file(model, stack, output, options.voxels, whence, session));
  }
  return files;
}

/// What is known of the input beside its contours.
struct Input {
  std::optional<ReportVolume> volume;
  Whence whence;
};

Made made_by_dt(const ValidStack& stack, Input input, const ReconstructArguments& options, Session& session) {
  DtWords dt = options.dt;
  if (!options.together.empty()) dt.partition.independent = true;
  const auto whole =
      std::make_shared<MadeModel>(MadeModel{{reconstructed(stack, dt, session), {}, {}, {}}, std::move(input.volume)});
  Model* const model = &whole->model;
  std::vector<FileContent> structures = structure_files(model->reconstruction, stack, input.whence, options, session);
  if (options.elements) mesh_model(*model, element_size_from(*options.elements), session.progress());
  if (options.triangles) simplify_model(*model, static_cast<std::size_t>(*options.triangles), session.progress());
  if (options.as_given && whole->volume && whole->volume->upright) {
    move_model(*model, whole->volume->upright->inverse());
    whole->volume->as_given = true;
  }
  Made made = files_of(model->reconstruction, options, session);
  made.files.insert(made.files.end(), std::make_move_iterator(structures.begin()),
                    std::make_move_iterator(structures.end()));
  if (!options.report.empty()) made.files.push_back({options.report, report_of(*whole)});
  if (model->aim) made.missed = missed_aim_in_words(*model->aim);
  made.absurd = absurd_distance_in_words(model->simplifications);
  for (const Attention& item : model->reconstruction.attention) made.look_here.push_back(in_words(item));
  made.tell = [whole](double seconds, Console& console) { tell_model(whole->model, seconds, console); };
  return made;
}

Made made_by_db(const ValidStack& stack, const ReconstructArguments& options, Session& session) {
  const DbOptions engine = understood(options.db, session.threads);
  const auto model = std::make_shared<DbReconstruction>(reconstruct_by_distance(stack, engine, session.progress()));
  Made made = files_of(*model, options, session);
  if (!options.report.empty()) made.files.push_back({options.report, report_json(*model, engine)});
  made.tell = [model](double seconds, Console& console) { tell_model(*model, seconds, console); };
  return made;
}

ValidStack stack_of(const ReconstructArguments& options, Session& session, Input& input) {
  if (options.words.any_level() || !needs_conversion(options.input, options.foreign)) {
    return contours_of_input(options.input, options.words, session, &input.volume, &input.whence);
  }
  const ValidStack stack = converted_told(options.input, options.foreign, session, &input.whence);
  if (!options.words.simplify) return stack;
  return validate(simplify_told(stack, {*options.words.simplify}, session), session.progress());
}

/// The first of an amber verdict's places, or all.
void warn_to_look(const std::vector<std::string>& places, std::size_t most, Console& console) {
  for (std::size_t i = 0; i < std::min(places.size(), most); ++i) console.complain("warning: " + places[i]);
  if (places.size() > most)
    console.complain(fmt::format("and {} more in the report (--report FILE.json)", places.size() - most));
}

/// What --strict does not let pass: said, and nothing is written.
bool refused_as_strict(const Made& made, Console& console) {
  if (!made.missed.empty()) console.complain(made.missed + ". Nothing was written, as --strict asks.");
  warn_to_look(made.look_here, made.look_here.size(), console);
  if (!made.look_here.empty()) console.complain("the verdict is amber. Nothing was written, as --strict asks.");
  return !made.missed.empty() || !made.look_here.empty();
}

ExitCode make_model(const ReconstructArguments& options, Session& session) {
  refuse_senseless(options);
  if (options.words.any_level()) understood(options.words);
  understood(options.db, session.threads);
  refuse_unwritable(planned_files(options));

  const auto start = std::chrono::steady_clock::now();
  Input input;
  ValidStack stack = stack_of(options, session, input);
  if (!options.together.empty()) {
    ContourStack joined = *stack;
    for (const std::string& list : options.together) joined = together(joined, names_in(list, "--together"));
    stack = validate(std::move(joined), session.progress());
  }
  const Made made =
      options.method == Method::db ? made_by_db(stack, options, session) : made_by_dt(stack, input, options, session);
  session.progress().check();
  if (options.strict && refused_as_strict(made, session.console)) return ExitCode::found_wanting;
  write_all(made.files, session.interrupts);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  made.tell(taken.count(), session.console);
  tell_tours(made.paths, session.console);
  for (const FileContent& file : made.files) session.console.say(fmt::format("Wrote {}", file.file.string()));
  for (const std::string& warning : {made.missed, made.absurd}) {
    if (!warning.empty()) session.console.complain("warning: " + warning + ".");
  }
  constexpr std::size_t most_places_told = 8;
  warn_to_look(made.look_here, most_places_told, session.console);
  return made.missed.empty() ? ExitCode::done : ExitCode::found_wanting;
}

void add_options(CLI::App& parser, ReconstructArguments& options) {
  parser
      .add_option("INPUT", options.input, "Contours (as contours --help lists), or a mesh or volume to take them from")
      ->required()
      ->type_name("");
  repeatable(
      parser.add_option("-o,--output", options.outputs, "Model to write; its ending tells the format; repeatable"))
      ->required()
      ->type_name("FILE");
  parser.add_flag("--tours", options.tours, "Into .glb and .gltf: a moving camera for each canal, to be played");
  parser.add_flag("--see-through", options.see_through, "In .glb and .gltf enamel and dentine show the pulp");
  parser.add_flag("--variants", options.variants,
                  "Into .glb and .gltf: natural, see-through and plaster, to choose from");
  parser.add_flag("--hotspots", options.hotspots,
                  "Into .glb and .gltf: places with names, orifices and tips of canals");
  parser.add_flag("--compress", options.compress,
                  "Smaller .glb and .gltf, without loss, for readers that know meshopt");
  parser.add_option("--report", options.report, "Certificate, counts, links and times")->type_name("FILE.json");
  add_choice<Method>(parser, "--method", options.method, {{"dt", Method::dt}, {"db", Method::db}},
                     "dt: Delaunay (default); db: distance field and marching cubes")
      ->type_name("NAME");
  repeatable(parser.add_option("--together", options.together, "Make structures one solid: the inner becomes a cavity"))
      ->type_name("A,B");
  constexpr int most_triangles = 100'000'000;
  parser.add_option("--triangles", options.triangles, "Simplify the surfaces to at most N triangles in all")
      ->type_name("N")
      ->check(whole_number_from_one_to(most_triangles));
  parser
      .add_option("--elements", options.elements,
                  "Mesh anew for simulation: edges of about MM, or quality: a size that fits")
      ->type_name("MM");
  parser.add_flag("--strict", options.strict, "Write nothing if the verdict is amber or --triangles is missed");
  add_dt_options(parser, options.dt);
  add_partition_options(parser, options.dt.partition);
  add_volume_options(parser, options.words);
  parser
      .add_flag("--as-given", options.as_given, "After --upright: put the finished model back to where the file has it")
      ->group("Volumes");
  add_foreign_options(parser, options.foreign);
  add_voxel_options(parser, options.voxels);
  add_db_options(parser, options.db);
}

}  // namespace

Command reconstruct_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("reconstruct", "Contours or a CT volume to a solid, certified model");
  const auto options = std::make_shared<ReconstructArguments>();
  add_options(*parser, *options);
  parser->footer(
      "Examples:\n"
      "  odontoscope reconstruct molar.json -o molar.glb --report molar-report.json\n"
      "  odontoscope reconstruct molar.json -o molar.stl -o molar.vtu --triangles 8000\n"
      "  odontoscope reconstruct tooth.nrrd --iso 120 --min-area 4 -o tooth.glb\n"
      "  odontoscope reconstruct rtss.dcm --structure Heart --repair -o heart.glb\n"
      "  odontoscope reconstruct molar.json --links mine.json -o molar.glb\n"
      "  odontoscope reconstruct molar.json --link pulp:12:5-5 -o molar.glb\n"
      "  odontoscope reconstruct whole.json --partition -o bonded.msh -o bonded.glb\n"
      "  odontoscope reconstruct whole.json --partition --elements 0.5 -o bonded.inp --report bonded.json\n"
      "  odontoscope reconstruct filled.json --together dentine,pulp -o hollow.glb\n"
      "  odontoscope reconstruct molar.json --voxels 0.1,0.1,0.1 -o molar.seg.nrrd\n"
      "  odontoscope reconstruct molar.json --method db --grid 128 --cases classic -o db.glb\n"
      "\n"
      "Surfaces: .glb or .gltf for viewers and the web, .stl for printers, .ply and .obj without loss,\n"
      ".3mf for printers of several materials, .wrl (VRML97) and .x3d, .vtp for ParaView. Tetrahedra: .vtu for\n"
      "ParaView, .msh for Gmsh, .inp for CalculiX and Abaqus. For viewers of images: .dcm (DICOM RTSTRUCT, the\n"
      "contours), .seg.dcm (DICOM SEG) and .nrrd or .seg.nrrd (label maps), whose voxels are those with their\n"
      "centres in the solid.\n"
      "--triangles keeps pieces, handles and cavities; where that needs more than N, what was reached is\n"
      "written, a warning says why, and the exit code is 1.\n"
      "--elements makes tetrahedra of good angles, which the exact ones are not; slices are then no longer cut\n"
      "exactly at their contours, and the report says by how much.\n"
      "The report lists every connection that was made, in the form that --links reads.\n"
      "The verdict is green, or amber: certified, but warnings name places where the data leave a choice, with\n"
      "the option that decides it. See docs/reconstruction.md.\n"
      "DB models are written as marching cubes makes them, cracks and all, with exit code 0; the last\n"
      "line and the report say what is wrong with them.\n");
  return {parser, [options](Session& session) { return make_model(*options, session); }};
}

}  // namespace odontoscope::app
