#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <future>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/scene_words.h"
#include "engine/app/shown_input.h"
#include "engine/app/tour_film.h"
#include "engine/picture/png.h"
#include "engine/scene/scene_json.h"
#include "engine/view/offscreen.h"

namespace odontoscope::app {
namespace {

constexpr int most_frames = 3600;

struct Options {
  std::string input;
  VolumeWords volume;
  SceneWords scene;
  std::string output, save_scene;
  std::string size = "1200x900";
  std::string backend = "auto";
  int samples = 4;
  int turntable = 0;
  std::string tour;
  int frames = 0;   // of a tour; 0: as usual
};

constexpr int usual_frames = 120;

int frames_of(const Options& options) { return options.frames > 0 ? options.frames : usual_frames; }

/// x.png; x-000.png, x-001.png, ... for a turntable; for a tour FOLDER/frame-0000.png, ....
std::vector<std::string> picture_files(const Options& options) {
  if (!options.tour.empty()) {
    std::vector<std::string> frames;
    for (int i = 0; i < frames_of(options); ++i) frames.push_back((std::filesystem::path(options.output) / fmt::format("frame-{:04}.png", i)).string());
    return frames;
  }
  if (options.turntable == 0) return {options.output};
  const std::filesystem::path path(options.output);
  std::vector<std::string> files;
  for (int i = 0; i < options.turntable; ++i)
    files.push_back((path.parent_path() / fmt::format("{}-{:03}{}", path.stem().string(), i, path.extension().string())).string());
  return files;
}

PlannedFiles planned_files(const Options& options) {
  PlannedFiles files{.inputs = {}, .outputs = picture_files(options)};
  for (const std::string& input : {options.input, options.scene.scene_file, options.scene.camera_file})
    if (!input.empty()) files.inputs.push_back(input);
  if (!options.save_scene.empty()) files.outputs.push_back(options.save_scene);
  return files;
}

/// The camera led round the axis of the tooth, through its target.
Camera turned(const Camera& camera, double degrees) {
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1), glm::radians(degrees), AnatomicalFrame().occlusal);
  Camera result = camera;
  result.position = camera.target + glm::dvec3(turn * glm::dvec4(camera.position - camera.target, 0));
  result.up = glm::dvec3(turn * glm::dvec4(camera.up, 0));
  return result;
}

PictureOptions picture_options(const Options& options) {
  PictureOptions picture{.size = size_from(options.size), .render = {.side = 1}};
  while (picture.render.side * picture.render.side < options.samples) ++picture.render.side;
  return picture;
}

/// The folder must be there: files are written whole or not at all, folders are not made.
void refuse_senseless_tour(const Options& options) {
  if (options.turntable > 0) throw UsageError("--tour and --turntable both lead the camera", "Choose one.");
  if (!options.scene.section.empty()) throw UsageError("--section: on a tour nothing is cut open", "Leave it out.");
  if (!std::filesystem::is_directory(options.output))
    throw UsageError(fmt::format("-o {}: the frames of a tour go into a folder, and this is none", options.output),
                     "Make it first. For a film join the frames: ffmpeg -framerate 30 -i FOLDER/frame-%04d.png film.mp4");
}

/// Makes the model on a thread of its own, so that the driver can start and compile meanwhile: each takes about half of the time to a first
/// picture. Stops the work when it is no longer wanted.
class ModelOnTheWay {
 public:
  ModelOnTheWay(const Options& options, const Session& session)
      : interrupted_(session.interrupts.token(), [this] { stop_.request_stop(); }), session_(session) {
    session_.watched = Progress{session.progress().report, stop_.get_token()};
    shown_ = std::async(std::launch::async, [&options, this] { return shown_from(options.input, options.volume, session_); });
  }
  ~ModelOnTheWay() { stop_.request_stop(); }

  Shown get() { return shown_.get(); }

 private:
  std::stop_source stop_;
  std::stop_callback<std::function<void()>> interrupted_;
  Session session_;
  std::future<Shown> shown_;   // waits for the thread when it goes
};

std::vector<FileContent> draw(const Options& options, GlContext& context, Renderer& renderer, const Shown& shown, const Scene& scene, const std::optional<Film>& film,
                              Session& session) {
  const PictureOptions picture = picture_options(options);
  const GpuModel gpu_model = upload(context.gl(), shown.model);
  const GpuOverlay overlay = upload(context.gl(), make_overlay(shown.overlays, scene.overlays, shown.model));
  const bool ct = scene.section && scene.cap.shows == CapLook::Shows::ct;
  const GpuValueGrid values = ct ? upload(context.gl(), *shown.values, gpu_model) : GpuValueGrid{};
  const std::vector<std::string> names = picture_files(options);
  std::vector<FileContent> files;
  for (std::size_t i = 0; i < names.size(); ++i) {
    session.progress().check();
    session.progress().tell("draw", static_cast<double>(i) / static_cast<double>(names.size()));
    Scene frame = scene;
    if (film) {
      const double last = static_cast<double>(std::max<std::size_t>(names.size() - 1, 1));
      frame = frame_of(scene, shown, *film, film->tour.seconds() * static_cast<double>(i) / last);
    }
    if (options.turntable > 0) frame.camera = turned(scene.camera, 360.0 * static_cast<double>(i) / static_cast<double>(names.size()));
    files.push_back({names[i], png_bytes(picture_of(context.gl(), renderer, gpu_model, shown.model, frame, picture, &overlay, ct ? &values : nullptr))});
  }
  return files;
}

/// Which greys mean what; refuses a cap where nothing is cut.
void tell_cap(const Options& options, const Shown& shown, const Scene& scene, Console& console) {
  if (!options.scene.cap.empty() && !scene.section)
    throw UsageError(fmt::format("--cap {}: nothing is cut open", options.scene.cap), "Say with --section where to cut.");
  if (!scene.section || scene.cap.shows != CapLook::Shows::ct) return;
  const ValueGrid& values = *shown.values;
  const ValueWindow window = scene.cap.window.value_or(values.usual);
  console.say(fmt::format("The cap shows CT values from {:.6g} (black) to {:.6g} (white){}.", window.low, window.high,
                          scene.cap.window ? "" : fmt::format(": of the values around the model {:g} % are lower and {:g} % higher", 100 * usual_low, 100 * (1 - usual_high))));
  if (values.merged != std::array<std::size_t, 3>{1, 1, 1})
    console.say(fmt::format("  each value is the mean of {} x {} x {} voxels, to bound its memory", values.merged[0], values.merged[1], values.merged[2]));
}

ExitCode render(const Options& options, Session& session) {
  if (options.tour.empty()) {
    if (options.frames > 0) throw UsageError("--frames without --tour: there is nothing to film", "Say which line: --tour canal-1.");
    known_ending(options.output, {".png"});
  } else {
    refuse_senseless_tour(options);
  }
  if (!options.save_scene.empty()) known_ending(options.save_scene, {".json"});
  const PictureOptions picture = picture_options(options);
  refuse_senseless(options.scene);
  const ContextOptions context_options{.backend = backend_named(options.backend), .window_allowed = true};
  refuse_unwritable(planned_files(options));
  ModelOnTheWay model(options, session);
  const std::unique_ptr<GlContext> context = make_context(context_options);
  refuse_undrawable(context->gl(), picture.size, picture.render);
  Renderer renderer(context->gl(), shaders_from_environment());

  const Shown shown = model.get();
  const Scene scene = scene_from(options.scene, shown.model, shown.overlays, shown.values.get(), picture.size);
  tell_cap(options, shown, scene, session.console);
  std::optional<Film> film;
  if (!options.tour.empty()) film = film_of(shown, options.tour, session);
  std::vector<FileContent> files = draw(options, *context, renderer, shown, scene, film, session);
  if (!options.save_scene.empty()) files.push_back({options.save_scene, to_json(scene)});
  session.progress().check();
  write_all(files, session.interrupts);
  session.console.say(fmt::format("Drawn with {}.", context->in_words()));
  if (film) session.console.say(fmt::format("The tour takes {:.1f} s; {:.3g} pictures a second show it as it is.", film->tour.seconds(), (frames_of(options) - 1) / film->tour.seconds()));
  session.console.say(files.size() <= 2 ? fmt::format("Wrote {}", files[0].file.string())
                                        : fmt::format("Wrote {} to {}", files.front().file.string(), files.back().file.string()));
  return ExitCode::done;
}

void add_options(CLI::App& parser, Options& options) {
  parser.add_option("INPUT", options.input, "Contour stack, mesh, or with --iso a volume; none: the sample molar")
      ->type_name("");
  parser.add_option("-o,--output", options.output, "The picture to write, or the folder for a tour")->required()->type_name("FILE.png");
  parser.add_option("--size", options.size, "Width and height in pixels")->type_name("WxH")->capture_default_str();
  parser.add_option("--samples", options.samples, "Samples a pixel: 1, 4, 9 or 16")
      ->type_name("N")
      ->check(CLI::IsMember({1, 4, 9, 16}).description(""))
      ->capture_default_str();
  parser.add_option("--backend", options.backend, "auto, window, egl or osmesa; the last two need no display")->type_name("NAME")->capture_default_str();
  parser.add_option("--turntable", options.turntable, "N pictures from all around: x-000.png, ...")
      ->type_name("N")
      ->check(whole_number_from_one_to(most_frames));
  parser.add_option("--tour", options.tour, "Film into the folder of -o along a line: canal-1, horn-2, ...")->type_name("LINE");
  parser.add_option("--frames", options.frames, "Pictures of the tour (default: 120)")->type_name("N")->check(whole_number_from_one_to(most_frames));
  parser.add_option("--save-scene", options.save_scene, "Camera and looks, for --scene or --camera")->type_name("FILE.json");
  add_scene_options(parser, options.scene);
  add_volume_options(parser, options.volume);
}

}  // namespace

Command render_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("render", "A picture of a model, with no display");
  const auto options = std::make_shared<Options>();
  add_options(*parser, *options);
  parser->footer(
      "Examples:\n"
      "  odontoscope render -o molar.png\n"
      "  odontoscope render molar.json -o cut.png --section buccal --opacity enamel=1 --opacity dentine=1\n"
      "  odontoscope render tooth.nrrd -o ct.png --iso 120 --min-area 4 --section buccal --view buccal --cap ct\n"
      "  odontoscope render scan.stl -o holes.png --cull tint\n"
      "  odontoscope render molar.glb -o turn.png --turntable 36 --background transparent\n"
      "  odontoscope render --tour canal-1 --frames 240 --size 1280x720 -o film\n");
  return {parser, [options](Session& session) { return render(*options, session); }};
}

}  // namespace odontoscope::app
