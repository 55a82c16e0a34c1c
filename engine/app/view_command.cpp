#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "engine/app/certificate_text.h"
#include "engine/app/command.h"
#include "engine/app/data_colour_words.h"
#include "engine/app/draft.h"
#include "engine/app/outputs.h"
#include "engine/app/scene_options.h"
#include "engine/app/scene_words.h"
#include "engine/app/shown_input.h"
#include "engine/app/view_script.h"
#include "engine/app/volume_look_words.h"
#include "engine/app/volume_options.h"
#include "engine/headset_viewer/headset_loop.h"
#include "engine/language/language.h"
#include "engine/navigate/thickness_colours.h"
#include "engine/navigate/wall_depth.h"
#include "engine/picture/png.h"
#include "engine/view/desktop_dialog.h"
#include "engine/view/offscreen.h"
#include "engine/viewer/viewer.h"
#include "engine/viewer/window_loop.h"
#include "recon/cavity/canal_names.h"
#include "recon/core/system_processes.h"
#include "recon/radiograph/tissue.h"
#include "recon/sample/tooth_number.h"
#include "recon/volume/read_volume.h"

namespace odontoscope::app {
namespace {

struct ViewArguments {
  std::string input;
  DtWords dt;
  VolumeWords volume;
  VolumeLookWords look;
  std::string colour_by;
  std::string grey;
  SceneWords scene;
  std::string size;
  std::string screenshot;
  std::optional<std::string> script;
  bool headset = false;
  std::string language;
  int headset_samples = 1;
  double headset_resolution = 1;
};

/// About what the window will be, for the first camera.
constexpr PixelSize usual_view{1000, 800};

VolumeWords volume_words(const LoadRequest& request, const ViewArguments& options) {
  VolumeWords words = request.from_command_line ? options.volume : VolumeWords{};
  if (!request.series.empty()) words.series = request.series;
  words.voxels = true;  // the panel may show them at any time
  if (!request.volume) return words;
  if (request.volume->iso) words.isos = {fmt::format("{}", *request.volume->iso)};
  for (const std::int64_t label : request.volume->labels) words.labels.push_back(fmt::format("{}", label));
  words.min_area = fmt::format("{}", request.volume->min_area_pixels);
  return words;
}

/// On the viewer's thread for such work.
VolumePreview preview(const LoadRequest& request, const Progress& progress, const ViewArguments& options) {
  ReadVolumeOptions read = understood(volume_words(request, options)).read;
  read.part = previewed_part;
  try {
    return volume_preview(read_volume(request.file, read, progress));
  } catch (const SeveralSeries& several) {
    VolumePreview to_choose;
    to_choose.series = several.series();
    return to_choose;
  }
}

std::string title_of(const std::string& file) {
  if (file.empty()) return "Sample molar";
  std::filesystem::path path(file);
  if (!path.has_filename()) path = path.parent_path();
  return path.stem().string();
}

GreyValues grey_values(const Shown& shown) {
  const ValueGrid& grid = *shown.values;
  GreyValues greys{shown.greys->air,
                   shown.greys->dentine,
                   linear_attenuation(*tissue_called("dentine"), effective_energy_kev(usual_kv)),
                   {},
                   grid.range.low,
                   grid.range.high,
                   {}};
  for (const IsoOf& each : shown.isos) greys.isos.push_back(each.iso);
  constexpr std::size_t bars = 96;
  std::vector<double> counts(bars, 0);
  for (const float value : grid.values) {
    const double place = (static_cast<double>(value) - greys.low) / (greys.high - greys.low);
    ++counts[std::min(static_cast<std::size_t>(place * bars), bars - 1)];
  }
  const double most = std::log1p(*std::max_element(counts.begin(), counts.end()));
  for (const double count : counts) greys.bars.push_back(static_cast<float>(std::log1p(count) / most));
  return greys;
}

/// Runs on the viewer's thread for such work.
LoadedModel load(const LoadRequest& request, const Progress& progress, const ViewArguments& options, Session session) {
  session.watched = progress;
  const bool draft_there = request.show_meanwhile && request.file.empty();
  if (draft_there) request.show_meanwhile(draft_of_sample(title_of(request.file), progress));
  Shown shown = shown_from(request.file, volume_words(request, options),
                           request.from_command_line ? options.dt : DtWords{}, session, [&](const ContourStack& stack) {
                             if (request.from_command_line) refuse_unknown_structures(options.scene, stack);
                             if (!request.show_meanwhile || draft_there) return;
                             if (auto draft = draft_of(stack, title_of(request.file), progress))
                               request.show_meanwhile(std::move(*draft));
                           });
  LoadedModel loaded;
  loaded.title = title_of(request.file);
  loaded.certificate = shown.proven ? certificate_of(*shown.proven) : certificate_of(shown.surfaces, progress);
  for (const NamedSurface& named : shown.surfaces) loaded.triangles += named.surface.triangles.size();
  const SceneWords words = request.from_command_line ? options.scene : SceneWords{};
  loaded.scene = scene_from(words, shown.model, shown.overlays, shown.values.get(), usual_view);
  if (request.from_command_line)
    show_volume(
        {options.look, options.grey, usual_kv, words.opacity, !words.background.empty() || !words.scene_file.empty()},
        shown, loaded.scene, session);
  if (request.from_command_line) colour_by_data(options.colour_by, words.opacity, shown, loaded.scene, session);
  if (shown.values && shown.greys) loaded.greys = grey_values(shown);
  if (shown.values) loaded.isos = shown.isos;
  loaded.deviations = deviations_in(shown.model);
  loaded.pickable = std::make_shared<const Pickable>(shown.model, progress);
  FlightSpaces spaces = flight_spaces(shown.surfaces, shown.model, progress);
  mark_wall_depths(shown.model, spaces);
  mark_wall_thicknesses(shown.model, spaces, progress);
  loaded.flight = std::make_shared<const FlightSpaces>(std::move(spaces));
  if (!loaded.flight->cavities.empty())
    if (const auto kind = sample_of(loaded.flight->cavities.front().lines)) loaded.tooth = tooth_in_words(*kind);
  loaded.model = std::move(shown.model);
  loaded.overlays = std::move(shown.overlays);
  loaded.values = std::move(shown.values);
  const bool whole_scene = !words.scene_file.empty();
  loaded.given.camera =
      whole_scene || !words.camera_file.empty() || !words.view.empty() || words.zoom != 1 || words.parallel;
  loaded.given.background = whole_scene || !words.background.empty();
  loaded.given.looks = whole_scene || !words.opacity.empty() || !words.colour.empty();
  loaded.given.back_faces = whole_scene || !words.back_faces.empty();
  return loaded;
}

/// What was asked for, was chosen before, or the environment speaks. Pictures without a window depend on what is asked
/// alone.
Language language_of(const ViewArguments& options, const std::string& chosen, bool by_hand) {
  if (!options.language.empty()) return language_asked(options.language);
  return by_hand ? known_language(knows_language(chosen) ? chosen : environment_language()) : Language{};
}

ViewerOptions viewer_options(const ViewArguments& options, const Settings& settings, const Session& session) {
  ViewerOptions viewer;
  viewer.load = [&options, session](const LoadRequest& request, const Progress& progress) {
    return load(request, progress, options, session);
  };
  viewer.wants_level = [&options](const LoadRequest& request) {
    const bool said = request.volume || (request.from_command_line && options.volume.any_level());
    return !said && looks_like_a_volume(request.file);
  };
  viewer.preview = [&options](const LoadRequest& request, const Progress& progress) {
    return preview(request, progress, options);
  };
  viewer.settings = settings;
  return viewer;
}

LoadRequest first_request(const ViewArguments& options) {
  return {.file = options.input, .volume = {}, .from_command_line = true};
}

/// What the window would show, drawn without one, after what a script does in it.
ExitCode take_screenshots(const ViewArguments& options, Session& session) {
  Settings settings;
  settings.hints = false;  // nobody is there to follow them
  if (!options.size.empty()) settings.window = size_from(options.size);
  std::vector<ScriptStep> steps;
  if (options.script)
    steps = script_steps(*options.script);
  else
    known_ending(options.screenshot, {".png"});
  PlannedFiles files{.inputs = {}, .outputs = files_of(steps)};
  if (!options.input.empty()) files.inputs.push_back(options.input);
  if (!options.screenshot.empty()) files.outputs.push_back(options.screenshot);
  refuse_unwritable(files);
  const std::unique_ptr<GlContext> context = make_context();
  const Framebuffer pixels(context->gl(), {settings.window, {GL_RGBA8}});
  ViewerOptions viewer_settings = viewer_options(options, settings, session);
  viewer_settings.coarse_when_slow = false;
  viewer_settings.language = language_of(options, {}, false);
  viewer_settings.wants_level = [](const LoadRequest&) { return false; };  // nobody is there to answer
  Viewer viewer(context->gl(), shaders_from_environment(), std::move(viewer_settings));
  viewer.open(first_request(options));
  constexpr auto pause = std::chrono::milliseconds(5);
  constexpr int frames_after = 4;
  for (int left = frames_after; left > 0; left -= viewer.loading() ? 0 : 1) {
    session.progress().check();
    viewer.draw({settings.window, 1, viewer.loading() ? 0.0 : 1.0}, {pixels.id(), 0, 0, settings.window});
    if (viewer.loading()) std::this_thread::sleep_for(pause);
  }
  if (viewer.failure()) std::rethrow_exception(viewer.failure());
  std::vector<FileContent> saved;
  if (!steps.empty()) saved = run_script(steps, viewer, context->gl(), settings.window, session.progress());
  if (!options.screenshot.empty()) {
    viewer.draw({settings.window, 1, 0}, {pixels.id(), 0, 0, settings.window});
    saved.push_back({options.screenshot, png_bytes(read_pixels(context->gl(), pixels.id(), settings.window))});
  }
  write_all(saved, session.interrupts);
  for (const FileContent& file : saved) session.console.say(fmt::format("Wrote {}", file.file.string()));
  return ExitCode::done;
}

void enter_headset(const ViewArguments& options, Viewer& viewer, Window& window, Session& session) {
  // Where there is no runtime, OpenXR's loader writes pages to the terminal; our own message says it.
  system::set_environment("XR_LOADER_DEBUG", "none");
  HeadsetVisitOptions visit;
  visit.headset.resolution = options.headset_resolution;
  while (visit.quality.side * visit.quality.side < options.headset_samples) ++visit.quality.side;
  visit.say = [&session](const std::string& words) { session.console.say(words); };
  if (!visit_in_headset(viewer, window, shaders_from_environment(), session.interrupts.token(), visit))
    session.console.complain(viewer.state().trouble);
}

ExitCode show_window(const ViewArguments& options, const ReadSettings& read, const std::filesystem::path& remembered,
                     Session& session) {
  Settings settings = read.settings;
  if (!options.size.empty()) settings.window = size_from(options.size);
  const Language language = language_of(options, settings.language, true);
  if (!options.language.empty()) settings.language = language.tag;
  Window window({.size = settings.window});
  ViewerOptions viewer_settings = viewer_options(options, settings, session);
  viewer_settings.language = language;
  viewer_settings.with_drafts = true;
  viewer_settings.dialog_program = desktop_dialog_program();
  viewer_settings.clipboard = {[&window] { return window.clipboard(); },
                               [&window](const std::string& text) { window.set_clipboard(text); }};
  Viewer viewer(window.context().gl(), shaders_from_environment(), std::move(viewer_settings));
  if (!read.complaint.empty()) viewer.state().notices.push_back({read.complaint, NoticeKind::bad, 12});
  session.console.say(fmt::format("Drawn with {}.", window.context().in_words()));
  viewer.open(first_request(options));
  viewer.state().headset_possible = headsets_built_in();
  viewer.state().headset_asked = options.headset;
  do {
    if (viewer.state().headset_asked) enter_headset(options, viewer, window, session);
    viewer.state().headset_asked = false;
    run_in_window(viewer, window, session.interrupts.token());
  } while (viewer.state().headset_asked);
  const Settings& now = viewer.state().settings;
  if (!(now == read.settings)) {
    const auto held = session.interrupts.hold();
    write_settings(now, remembered);
  }
  session.progress().check();
  return ExitCode::done;
}

ExitCode view(const ViewArguments& options, Session& session) {
  refuse_senseless(options.scene);
  refuse_senseless(options.look);
  refuse_senseless_colour_by(options.colour_by);
  greys_from(options.grey);
  if (!options.grey.empty() && !wants_voxels(options.look, options.scene.scene_file))
    throw UsageError("--grey says what values mean, and none are shown", "Ask for --show volume or --show both.");
  if (options.volume.any_level()) understood(options.volume);
  refuse_senseless(options.dt);
  const std::filesystem::path remembered = settings_file();
  if (!options.size.empty()) size_from(options.size);
  if (!options.language.empty()) language_asked(options.language);
  const bool by_hand = options.screenshot.empty() && !options.script;
  const ReadSettings read = by_hand ? read_settings(remembered) : ReadSettings{};
  if (!read.complaint.empty()) session.console.complain(read.complaint);
  if (!by_hand) return take_screenshots(options, session);
  return show_window(options, read, remembered, session);
}

}  // namespace

Command view_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("view", "A window to look at a model: turn it, cut it open, measure it");
  const auto options = std::make_shared<ViewArguments>();
  parser->add_option("INPUT", options->input, "Contour stack, mesh or volume; none: the sample molar")->type_name("");
  parser->add_option("--size", options->size, "Width and height of the window (default: as it was last)")
      ->type_name("WxH");
  parser
      ->add_option("--screenshot", options->screenshot, "Write what the window would show and leave; needs no display")
      ->type_name("FILE.png");
  parser
      ->add_option("--script", options->script,
                   "Keys, clicks, waits and shots, without hands or display; @FILE holds them")
      ->type_name("STEPS");
  parser
      ->add_flag("--vr", options->headset,
                 "Show it in the headset, through OpenXR; the window shows what the left eye sees")
      ->excludes("--screenshot")
      ->excludes("--script");
  parser
      ->add_option("--vr-samples", options->headset_samples,
                   "In the headset, samples a pixel: 1, or 4 for calm edges where the graphics card has time for four "
                   "times the work")
      ->type_name("N")
      ->check(CLI::IsMember({1, 4}).description(""))
      ->capture_default_str();
  parser
      ->add_option("--vr-resolution", options->headset_resolution,
                   "In the headset, pixels along each side, of what its runtime recommends: 0.25 to 2")
      ->type_name("SHARE")
      ->check(CLI::Range(0.25, 2.0).description(""))
      ->capture_default_str();
  parser
      ->add_option("--language", options->language,
                   "Language: de, en, or a file of another; remembered (default: the environment's)")
      ->type_name("LANGUAGE");
  add_scene_options(*parser, options->scene);
  add_volume_look_options(*parser, options->look);
  add_colour_by_option(*parser, options->colour_by);
  add_grey_option(*parser, options->grey);
  add_dt_options(*parser, options->dt);
  add_partition_options(*parser, options->dt.partition);
  add_volume_options(*parser, options->volume);
  parser->footer(
      "Examples:\n"
      "  odontoscope view\n"
      "  odontoscope view molar.json --section buccal\n"
      "  odontoscope view tooth.nrrd --iso 120 --min-area 4\n"
      "  odontoscope view --script \"s wait:1 shot:cut.png picture:tooth.png scene:tooth.json\"\n"
      "  odontoscope view --language de\n"
      "  odontoscope view --vr molar.json      in the headset; see docs/headset.md\n"
      "\n"
      "Press ? in the window for mouse and keys; docs/viewer.md has more. Files can be dropped on the window.\n"
      "Settings: $XDG_CONFIG_HOME/odontoscope/viewer.json, which may be deleted.\n");
  return {parser, [options](Session& session) { return view(*options, session); }};
}

}  // namespace odontoscope::app
