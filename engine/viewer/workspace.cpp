#include "engine/viewer/workspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "engine/navigate/moves.h"
#include "engine/navigate/screen.h"
#include "engine/navigate/section_handle.h"
#include "engine/scene/fit_visible.h"
#include "engine/viewer/load/load_mode.h"
#include "recon/core/error.h"

namespace odontoscope {

namespace {

constexpr double darken_seconds = 0.30, brighten_seconds = 0.40;

/// Letters, digits, - and _ only: titles come from files.
std::string as_file_name(const std::string& title) {
  std::string name;
  for (const char c : title) name += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' ? c : '-';
  return name.empty() ? "odontoscope" : name;
}

}  // namespace

void Fade::darken_then(std::function<void()> at_dark) {
  if (darkening()) std::exchange(at_dark_, nullptr)();
  seconds_ = 0;
  running_ = true;
  at_dark_ = std::move(at_dark);
}

void Fade::advance(double seconds) {
  if (!running_) return;
  seconds_ += seconds;
  bool done = !at_dark_;
  if (!done && seconds_ >= darken_seconds) {
    done = true;
    std::exchange(at_dark_, nullptr)();
  }
  const double light = (seconds_ - darken_seconds) / brighten_seconds;
  dark_ = done ? std::clamp(1 - light, 0.0, 1.0) : seconds_ / darken_seconds;
  if (done && light >= 1) running_ = false;
}

std::filesystem::path FileNames::next(const std::string& stem, const std::string& ending) {
  const std::filesystem::path folder = folder_.empty() ? std::filesystem::current_path() : folder_;
  constexpr int most = 10'000;
  for (int number = 1; number < most; ++number) {
    std::filesystem::path file = folder / fmt::format("{}-{:03}{}", as_file_name(stem), number, ending);
    std::error_code error;
    if (!std::filesystem::exists(file, error) && names_given_.insert(file).second) return file;
  }
  throw FileError(folder.string(), fmt::format("it holds {} files of that name", most), "Clear up a little.");
}

Workspace::Workspace(const Gl& context, const ShaderLibrary& library, ViewerOptions chosen)
    : gl(context),
      shaders(library),
      options(std::move(chosen)),
      interface(options.clipboard),
      picture(context, library),
      files(options.folder),
      modes(*this, options.modes) {
  state.settings = options.settings;
  std::error_code error;
  if (options.folder.empty() && std::filesystem::is_directory(state.settings.save_folder, error))
    files.move_to(state.settings.save_folder);
  state.languages = known_languages();
  if (std::none_of(state.languages.begin(), state.languages.end(),
                   [&](const Language& known) { return known == options.language; }))
    state.languages.push_back(options.language);
  interface.speak(options.language);
}

void Workspace::notice(std::string words, NoticeKind kind, double seconds) {
  constexpr std::size_t most = 3;
  std::erase_if(state.notices, [&](const Notice& shown) { return shown.words == words; });  // said again, not twice
  state.notices.push_back({std::move(words), kind, seconds});
  if (state.notices.size() > most) state.notices.erase(state.notices.begin());
}

void Workspace::open(LoadRequest request) { modes.get<LoadMode>().open(std::move(request)); }

void Workspace::show(std::shared_ptr<const LoadedModel> shown) {
  state.origin.draft = false;
  for (const auto& mode : modes) mode->leave();
  fade.stop();
  picture.take(shown->model);
  Scene& scene = state.scene;
  scene = shown->scene;
  // The same plane, its handle where the model is.
  if (auto& section = scene.section) section = with_offset(*section, offset_of(*section, shown->model), shown->model);
  if (!shown->given.back_faces) scene.back_faces = state.settings.back_faces;
  if (!shown->given.looks) apply_remembered(state.settings, scene);
  if (!shown->given.background) scene.background = background_of(state.settings.backdrop);
  if (!shown->given.camera)
    scene.camera = fit_without(hidden_in(scene), NamedView::three_quarter, shown->model, front().area.aspect(),
                               state.settings.projection);
  state.shown = std::move(shown);
  for (const auto& mode : modes) mode->model_shown();
  pointing.hit.reset();
  pointing.canal.reset();
  pointing.held.reset();
  motion = {};
}

Scene Workspace::scene_of_picture() const {
  const PictureSettings& settings = state.settings.picture;
  Scene scene = state.scene;
  if (settings.transparent) scene.background.kind = Background::Kind::transparent;
  scene.picture = {settings.width, settings.height, settings.side * settings.side};
  if (settings.as_seen)
    scene.picture->height = std::max(1, static_cast<int>(std::lround(settings.width / front().area.aspect())));
  return scene;
}

PictureOptions Workspace::options_of_picture(const Scene& scene) const {
  return {.size = {scene.picture->width, scene.picture->height}, .render = {.side = state.settings.picture.side}};
}

Image Workspace::image() {
  const Scene scene = scene_of_picture();
  return picture.image(state, scene, options_of_picture(scene));
}

void Workspace::go_to(const Camera& camera, double seconds) {
  motion.camera.emplace(state.scene.camera, camera, seconds);
}

void Workspace::jump_to(const Camera& camera) {
  motion.camera.reset();
  state.scene.camera = camera;
}

void Workspace::set_camera(const Camera& camera) {
  jump_to(within_reach(camera, state.shown->model));
  for (ViewPane& pane : layout.panes) pane.camera = state.scene.camera;
}

void Workspace::settle_looks() {
  if (!motion.looks) return;
  const Camera camera = state.scene.camera;
  state.scene = motion.looks->goal();
  state.scene.camera = camera;
  motion.looks.reset();
}

const ViewPane* Workspace::pane_at(double x, double y) const {
  if (interface.covers(x, y)) return nullptr;
  const auto found = std::find_if(layout.panes.begin(), layout.panes.end(),
                                  [&](const ViewPane& pane) { return pane.shown().holds(x, y); });
  return found == layout.panes.end() ? nullptr : &*found;
}

const Model& Workspace::model_of(const ViewPane& pane) const {
  return pane.db ? *modes.other_model()->model : state.shown->model;
}

const Pickable& Workspace::pickable_of(const ViewPane& pane) const {
  return pane.db ? *modes.other_model()->pickable : *state.shown->pickable;
}

std::optional<Hit> Workspace::hit_at(const ViewPane& pane, double x, double y) const {
  if (!state.shown) return std::nullopt;
  const SightLine line = sight_line(pane.camera, place_in(pane.area, x, y));
  return pick(pickable_of(pane), state.scene, {line.origin, line.direction});
}

glm::dvec3 Workspace::anchor_at(const ViewPane& pane, double x, double y) const {
  if (const auto hit = hit_at(pane, x, y)) return hit->point_mm;
  return point_at_depth_of(pane.camera, place_in(pane.area, x, y), pane.camera.target);
}

}  // namespace odontoscope
