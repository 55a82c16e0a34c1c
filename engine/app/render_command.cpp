#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/contact_sheet.h"
#include "engine/app/data_colour_words.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/painter.h"
#include "engine/app/radiograph_options.h"
#include "engine/app/scene_options.h"
#include "engine/app/scene_words.h"
#include "engine/app/shown_input.h"
#include "engine/app/tour_film.h"
#include "engine/app/volume_look_words.h"
#include "engine/app/wall_marks.h"
#include "engine/picture/film_file.h"
#include "engine/picture/png.h"
#include "engine/scene/scene_json.h"
#include "engine/view/offscreen.h"
#include "recon/core/lower_case.h"

namespace odontoscope::app {
namespace {

constexpr int most_frames = 3600;

struct RenderArguments {
  std::string input;
  DtWords dt;
  VolumeWords volume;
  SceneWords scene;
  RadiographWords radiograph;
  VolumeLookWords look;
  std::string colour_by;
  std::string output, save_scene;
  std::string size;  // empty: as the scene says, or usual
  std::string backend = "auto";
  std::optional<int> samples;
  int turntable = 0;
  TourWords tour;
  int frames = 0;  // of a tour; 0: as usual
  std::string contact_sheet;
};

constexpr int usual_frames = 120;
constexpr double film_rate = 30;  // pictures a second

bool on_tour(const RenderArguments& options) { return !options.tour.line.empty(); }

bool to_film(const RenderArguments& options) {
  const std::string ending = lower_case(std::filesystem::path(options.output).extension().string());
  return on_tour(options) && options.contact_sheet.empty() &&
         std::find(film_endings().begin(), film_endings().end(), ending) != film_endings().end();
}

bool to_folder(const RenderArguments& options) {
  return on_tour(options) && options.contact_sheet.empty() && !to_film(options);
}

PictureFormat format_of(const RenderArguments& options) {
  return picture_format(options.size, options.samples, options.scene.scene_file,
                        options.contact_sheet.empty() ? PixelSize{1200, 900} : PixelSize{320, 240});
}

PixelSize size_of(const RenderArguments& options) {
  const PictureFormat format = format_of(options);
  return {format.width, format.height};
}

int frames_of(const RenderArguments& options) { return options.frames > 0 ? options.frames : usual_frames; }

/// x.png; x-000.png, x-001.png, ... for a turntable; for a tour FOLDER/frame-0000.png, ..., or the film or contact
/// sheet alone.
std::vector<std::string> picture_files(const RenderArguments& options) {
  if (to_folder(options)) {
    std::vector<std::string> frames;
    for (int i = 0; i < frames_of(options); ++i)
      frames.push_back((std::filesystem::path(options.output) / fmt::format("frame-{:04}.png", i)).string());
    return frames;
  }
  if (options.turntable == 0) return {options.output};
  const std::filesystem::path path(options.output);
  std::vector<std::string> files;
  for (int i = 0; i < options.turntable; ++i)
    files.push_back(
        (path.parent_path() / fmt::format("{}-{:03}{}", path.stem().string(), i, path.extension().string())).string());
  return files;
}

PlannedFiles planned_files(const RenderArguments& options) {
  PlannedFiles files{.inputs = {}, .outputs = picture_files(options)};
  for (const std::string* input :
       {&options.input, &options.dt.links, &options.scene.scene_file, &options.scene.camera_file})
    if (!input->empty()) files.inputs.push_back(*input);
  if (!options.save_scene.empty()) files.outputs.push_back(options.save_scene);
  return files;
}

PictureOptions picture_options(const RenderArguments& options) {
  return {.size = size_of(options), .render = {.side = side_of(format_of(options))}};
}

/// The folder must be there: files are written whole or not at all, folders are not made.
void refuse_senseless_tour(const RenderArguments& options) {
  if (options.turntable > 0) throw UsageError("--tour and --turntable both lead the camera", "Choose one.");
  if (!options.scene.section.empty()) throw UsageError("--section: on a tour nothing is cut open", "Leave it out.");
  if (!options.contact_sheet.empty()) {
    refuse_too_large(sheet_from(options.contact_sheet), size_of(options).width, size_of(options).height);
    known_ending(options.output, {".png"});
    if (options.frames > 0)
      throw UsageError("--frames: a contact sheet has as many pictures as it has places", "Leave it out.");
    return;
  }
  const PixelSize size = size_of(options);
  if (to_film(options)) {
    if (size.width % 2 != 0 || size.height % 2 != 0)
      throw UsageError(fmt::format("--size {}: a film's width and height are even", options.size),
                       "Add a pixel: colour is stored for two by two.");
    return need_ffmpeg(options.output);
  }
  if (!std::filesystem::is_directory(options.output))
    throw UsageError(fmt::format("-o {}: the frames of a tour go into a folder, and this is none", options.output),
                     "Make it first, or name a film: -o tour.mp4 or -o tour.webm");
}

void refuse_tour_words_without_tour(const RenderArguments& options) {
  if (options.frames > 0)
    throw UsageError("--frames without --tour: there is nothing to film", "Say which line: --tour canal-1.");
  if (!options.contact_sheet.empty() || options.tour.reverse || options.tour.void_number > 1)
    throw UsageError("--contact-sheet, --reverse and --void are about a tour", "Say which line: --tour canal-1.");
}

/// Makes the model on a thread of its own, so that the driver can start and compile meanwhile: each takes about half of
/// the time to a first picture. Stops the work when it is no longer wanted.
class ModelOnTheWay {
 public:
  ModelOnTheWay(const RenderArguments& options, const Session& session)
      : interrupted_(session.interrupts.token(), [this] { stop_.request_stop(); }), session_(session) {
    session_.watched = Progress{session.progress().report, stop_.get_token()};
    shown_ = std::async(std::launch::async, [&options, this] {
      return shown_from(options.input, options.volume, options.dt, session_,
                        [&options](const ContourStack& stack) { refuse_unknown_structures(options.scene, stack); });
    });
  }
  ~ModelOnTheWay() { stop_.request_stop(); }

  Shown get() { return shown_.get(); }

 private:
  std::stop_source stop_;
  std::stop_callback<std::function<void()>> interrupted_;
  Session session_;
  std::future<Shown> shown_;  // waits for the thread when it goes
};

std::vector<FileContent> single_pictures(const RenderArguments& options, const Shown& shown, const Scene& scene,
                                         const std::optional<Film>& film, Painter& painter) {
  const std::vector<std::string> names = picture_files(options);
  std::vector<FileContent> files;
  for (std::size_t i = 0; i < names.size(); ++i) {
    Scene frame = film ? frame_of(scene, shown, *film, moment(*film, i, names.size())) : scene;
    if (options.turntable > 0) frame.camera = turned(scene.camera, i, names.size());
    files.push_back({names[i], png_bytes(painter.draw(frame, i, names.size()))});
  }
  return files;
}

std::size_t pictures_of_film(const RenderArguments& options, const Film& film) {
  const auto as_it_is = static_cast<std::size_t>(std::lround(film_rate * film.tour.seconds())) + 1;
  return options.frames > 0 ? static_cast<std::size_t>(options.frames) : std::min<std::size_t>(as_it_is, most_frames);
}

FileContent film_file(const RenderArguments& options, const Shown& shown, const Scene& scene, const Film& film,
                      Painter& painter, Session& session) {
  const PixelSize size = size_of(options);
  const std::size_t count = pictures_of_film(options, film);
  FilmMaker maker(options.output, {size.width, size.height, film_rate});
  for (std::size_t i = 0; i < count; ++i)
    maker.add(painter.draw(frame_of(scene, shown, film, moment(film, i, count)), i, count), session.progress());
  return {options.output, maker.finish(session.progress())};
}

std::vector<FileContent> draw(const RenderArguments& options, const Shown& shown, const Scene& scene,
                              const std::optional<Film>& film, Painter& painter, Session& session) {
  if (to_film(options)) return {film_file(options, shown, scene, *film, painter, session)};
  if (!options.contact_sheet.empty())
    return {{options.output, png_bytes(sheet_of(shown, scene, *film, sheet_from(options.contact_sheet), painter))}};
  return single_pictures(options, shown, scene, film, painter);
}

void tell_tour(const RenderArguments& options, const Film& film, Console& console) {
  const double seconds = film.tour.seconds();
  if (to_film(options)) {
    const double lasts = static_cast<double>(pictures_of_film(options, film)) / film_rate;
    return console.say(fmt::format("The tour takes {:.1f} s, the film {:.1f} s at {:g} pictures a second.", seconds,
                                   lasts, film_rate));
  }
  if (to_folder(options))
    return console.say(fmt::format("The tour takes {:.1f} s; {:.3g} pictures a second show it as it is.", seconds,
                                   (frames_of(options) - 1) / seconds));
  console.say(fmt::format("The tour takes {:.1f} s.", seconds));
}

/// Which greys mean what; refuses a cap where nothing is cut.
void tell_cap(const RenderArguments& options, const Shown& shown, const Scene& scene, Console& console) {
  refuse_cap_without_section(options.scene, scene);
  if (!scene.section || scene.cap.shows != CapLook::Shows::ct) return;
  const ValueGrid& values = *shown.values;
  const ValueWindow window = scene.cap.window.value_or(values.usual);
  console.say(fmt::format("The cap shows CT values from {:.6g} (black) to {:.6g} (white){}.", window.low, window.high,
                          scene.cap.window
                              ? ""
                              : fmt::format(": of the values around the model {:g} % are lower and {:g} % higher",
                                            100 * usual_low, 100 * (1 - usual_high))));
  if (values.merged != std::array<std::size_t, 3>{1, 1, 1})
    console.say(fmt::format("  each value is the mean of {} x {} x {} voxels, to bound its memory", values.merged[0],
                            values.merged[1], values.merged[2]));
}

void refuse_words_about_pictures(const RenderArguments& options) {
  refuse_words_about_pictures(options.scene, options.look);
  if (!options.save_scene.empty()) throw UsageError("--save-scene: a film has no scene", "Leave it out.");
  if (on_tour(options)) throw UsageError("--radiograph and --tour: no film lies in a canal", "Choose one.");
  if (!options.size.empty()) throw UsageError("--size: a film's size is told in mm", "Give --film WxH and --pixel MM.");
}

ExitCode render_radiograph(const RenderArguments& options, Session& session) {
  refuse_words_about_pictures(options);
  refuse_unwritable(planned_files(options));
  const NamedView from = options.scene.view.empty() ? NamedView::buccal : view_named(options.scene.view);
  const std::vector<std::string> names = picture_files(options);
  std::vector<FileContent> files;
  radiographs(options.radiograph, {options.input, options.volume, options.dt},
              {from, options.scene.hide, std::max(options.turntable, 1)}, session, [&](Image&& film) {
                files.push_back({names[files.size()], png_bytes(film)});
              });
  session.progress().check();
  write_all(files, session.interrupts);
  session.console.say(files.size() == 1
                          ? fmt::format("Wrote {}", files[0].file.string())
                          : fmt::format("Wrote {} to {}", files.front().file.string(), files.back().file.string()));
  return ExitCode::done;
}

ExitCode render(const RenderArguments& as_typed, Session& session) {
  RenderArguments options = as_typed;
  if (!on_tour(options)) {
    refuse_tour_words_without_tour(options);
    known_ending(options.output, {".png"});
  } else {
    refuse_senseless_tour(options);
  }
  if (!options.save_scene.empty()) known_ending(options.save_scene, {".json"});
  const PictureOptions picture = picture_options(options);
  refuse_senseless(options.scene);
  refuse_senseless(options.dt);
  refuse_senseless(options.radiograph);
  refuse_senseless(options.look);
  refuse_senseless_colour_by(options.colour_by);
  if (options.radiograph.on && !options.colour_by.empty())
    throw UsageError("--colour-by: a film has no surfaces to colour", "Leave it out, or --radiograph.");
  options.volume.voxels = wants_voxels(options.look, options.scene.scene_file);
  if (!options.radiograph.on && !options.volume.voxels && !options.radiograph.grey.empty())
    throw UsageError("--grey says what values mean, and none are shown", "Ask for --radiograph or --show volume.");
  if (options.radiograph.on) return render_radiograph(options, session);
  const ContextOptions context_options{.backend = backend_named(options.backend), .window_allowed = true};
  refuse_unwritable(planned_files(options));
  ModelOnTheWay model(options, session);
  const std::unique_ptr<GlContext> context = make_context(context_options);
  refuse_undrawable(context->gl(), picture.size, picture.render);
  Renderer renderer(context->gl(), shaders_from_environment());

  Shown shown = model.get();
  Scene scene = scene_from(options.scene, shown.model, shown.overlays, shown.values.get(), picture.size);
  show_volume({options.look, options.radiograph.grey, options.radiograph.kv, options.scene.opacity,
               !options.scene.background.empty() || !options.scene.scene_file.empty()},
              shown, scene, session);
  colour_by_data(options.colour_by, options.scene.opacity, shown, scene, session);
  tell_cap(options, shown, scene, session.console);
  std::optional<Film> film;
  if (on_tour(options)) film.emplace(film_of(shown, options.tour, session));
  mark_walls(scene, shown.model, shown.surfaces, session.progress());
  Painter painter(picture, context->gl(), renderer, shown, scene, session);
  std::vector<FileContent> files = draw(options, shown, scene, film, painter, session);
  if (!options.save_scene.empty()) {
    scene.picture = format_of(options);
    files.push_back({options.save_scene, to_json(scene)});
  }
  session.progress().check();
  write_all(files, session.interrupts);
  session.console.say(fmt::format("Drawn with {}.", context->in_words()));
  if (film) tell_tour(options, *film, session.console);
  session.console.say(files.size() <= 2
                          ? fmt::format("Wrote {}", files[0].file.string())
                          : fmt::format("Wrote {} to {}", files.front().file.string(), files.back().file.string()));
  return ExitCode::done;
}

void add_options(CLI::App& parser, RenderArguments& options) {
  parser.add_option("INPUT", options.input, "Contour stack, mesh, or with --iso a volume; none: the sample molar")
      ->type_name("");
  parser.add_option("-o,--output", options.output, "The picture to write; of a tour its folder, .mp4 or .webm")
      ->required()
      ->type_name("FILE.png");
  parser.add_option("--size", options.size, "Width and height, pixels (default: the scene's, 1200x900; sheet 320x240)")
      ->type_name("WxH");
  parser.add_option("--samples", options.samples, "Samples a pixel: 1, 4, 9 or 16 (default: the scene's, or 4)")
      ->type_name("N")
      ->check(CLI::IsMember({1, 4, 9, 16}).description(""));
  parser.add_option("--backend", options.backend, "auto, window, egl or osmesa; the last two need no display")
      ->type_name("NAME")
      ->capture_default_str();
  parser.add_option("--turntable", options.turntable, "N pictures from all around: x-000.png, ...")
      ->type_name("N")
      ->check(whole_number_from_one_to(most_frames));
  parser.add_option("--tour", options.tour.line, "Film into -o along a line: canal-1, horn-2, ...")->type_name("LINE");
  parser.add_flag("--reverse", options.tour.reverse, "The tour from its end out");
  parser.add_option("--void", options.tour.void_number, "Which void the tour is in, by size (default: 1, the largest)")
      ->type_name("N")
      ->check(whole_number_from_one_to(most_frames));
  parser
      .add_option("--contact-sheet", options.contact_sheet, "The tour as one picture of so many columns and rows: 4x3")
      ->type_name("CxR");
  parser.add_option("--frames", options.frames, "Pictures of the tour (default: 120; a film: 30 a second)")
      ->type_name("N")
      ->check(whole_number_from_one_to(most_frames));
  parser.add_option("--save-scene", options.save_scene, "Camera and looks, for --scene or --camera")
      ->type_name("FILE.json");
  add_scene_options(parser, options.scene);
  add_volume_look_options(parser, options.look);
  add_colour_by_option(parser, options.colour_by);
  add_radiograph_options(parser, options.radiograph);
  add_dt_options(parser, options.dt);
  add_partition_options(parser, options.dt.partition);
  add_volume_options(parser, options.volume);
}

}  // namespace

Command render_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("render", "A picture of a model, with no display");
  const auto options = std::make_shared<RenderArguments>();
  add_options(*parser, *options);
  parser->footer(
      "Examples:\n"
      "  odontoscope render -o molar.png\n"
      "  odontoscope render molar.json -o cut.png --section buccal --opacity enamel=1 --opacity dentine=1\n"
      "  odontoscope render tooth.nrrd -o ct.png --iso 120 --min-area 4 --section buccal --view buccal --cap ct\n"
      "  odontoscope render scan.stl -o holes.png --cull tint\n"
      "  odontoscope render molar.glb -o turn.png --turntable 36 --background transparent\n"
      "  odontoscope render --tour canal-1 --size 1280x720 -o canal.mp4\n"
      "  odontoscope render --tour canal-1 --contact-sheet 4x3 -o canal.png\n"
      "  odontoscope render tooth.nrrd -o ct.png --show volume --transfer enamel\n"
      "  odontoscope render molar.json --radiograph --tube 20,0 -o film.png\n"
      "\n"
      "Films (.mp4, .webm) are made by ffmpeg, which must be installed (Debian: ffmpeg).\n");
  return {parser, [options](Session& session) { return render(*options, session); }};
}

}  // namespace odontoscope::app
