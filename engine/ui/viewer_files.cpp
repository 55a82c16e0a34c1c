// What the viewer saves: pictures and scenes.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>

#include "engine/gpu/graphics_error.h"
#include "engine/picture/png.h"
#include "engine/scene/scene_json.h"
#include "engine/ui/viewer.h"
#include "engine/view/offscreen.h"
#include "recon/core/atomic_file.h"

namespace odontoscope {

namespace {

/// Letters, digits, - and _ only: titles come from files.
std::string as_file_name(const std::string& title) {
  std::string name;
  for (const char c : title) name += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' ? c : '-';
  return name.empty() ? "odontoscope" : name;
}

}  // namespace

/// STEM-001.ENDING, the first that there is not yet; nothing is ever overwritten.
std::filesystem::path Viewer::new_file(const std::string& stem, const std::string& ending) {
  const std::filesystem::path folder = options_.folder.empty() ? std::filesystem::current_path() : options_.folder;
  constexpr int most = 10'000;
  for (int number = 1; number < most; ++number) {
    const std::filesystem::path file = folder / fmt::format("{}-{:03}{}", as_file_name(stem), number, ending);
    std::error_code error;
    if (!std::filesystem::exists(file, error) && names_given_.insert(file).second) return file;
  }
  throw FileError(folder.string(), fmt::format("it holds {} files of that name", most), "Clear up a little.");
}

Scene Viewer::scene_of_picture() const {
  const PictureSettings& settings = state_.settings.picture;
  Scene scene = state_.scene;
  if (settings.transparent) scene.background.kind = Background::Kind::transparent;
  scene.picture = {settings.width, settings.height, settings.side * settings.side};
  if (settings.as_seen)
    scene.picture->height = std::max(1, static_cast<int>(std::lround(settings.width / panes_.front().area.aspect())));
  return scene;
}

Image Viewer::picture() {
  const Scene scene = scene_of_picture();
  const PictureOptions options{.size = {scene.picture->width, scene.picture->height},
                               .render = {.side = state_.settings.picture.side}};
  refuse_undrawable(*gl_, options.size, options.render);
  return picture_of(*gl_, renderer_, gpu_model_, state_.shown->model, scene, options, &gpu_overlay_, cap_values(),
                    volume());
}

namespace {

/// Where there is no second context: words for which the picture is drawn in the window's.
constexpr const char* only_here = "";

/// With a context of its own, which takes its buffers along when it goes. Null: there is none besides the window's.
std::optional<Image> drawn_apart(const LoadedModel& shown, const Scene& scene, const PictureOptions& options,
                                 const ShaderLibrary& shaders) {
  std::unique_ptr<GlContext> context;
  try {
    context = make_context();
  } catch (const GraphicsError&) {
    return {};
  }
  const Gl& gl = context->gl();
  Renderer renderer(gl, shaders);
  const GpuModel model = upload(gl, shown.model);
  const GpuOverlay overlay = upload(gl, make_overlay(shown.overlays, scene.overlays, shown.model));
  const bool on_cap = scene.cap.shows == CapLook::Shows::ct && scene.section && shown.values,
             cast = scene.volume.shows_volume() && shown.values;
  std::optional<GpuValueGrid> values;
  std::optional<GpuVolume> volume;
  if (on_cap || cast) values = upload(gl, *shown.values, model);
  if (cast) volume.emplace(gl, *shown.values, values->field());
  return picture_of(gl, renderer, model, shown.model, scene, options, &overlay, on_cap ? &*values : nullptr,
                    volume ? &*volume : nullptr);
}

std::string kept_as(const Image& image, AtomicFile& place) {
  place.write(png_bytes(image));
  place.commit();
  return fmt::format("Saved {} ({} \xC3\x97 {})", place.target().string(), image.width, image.height);
}

}  // namespace

/// Drawn beside the window, which goes on meanwhile; one at a time, for the memory that each takes.
void Viewer::take_picture() {
  try {
    const std::filesystem::path file = new_file(state_.shown->title, ".png");
    AtomicFile place(file);  // trouble with the folder is told before the work
    const Scene scene = scene_of_picture();
    const PictureOptions options{.size = {scene.picture->width, scene.picture->height},
                                 .render = {.side = state_.settings.picture.side}};
    refuse_undrawable(*gl_, options.size, options.render);
    writing_.push_back(
        std::async(std::launch::async,
                   [this, shown = state_.shown, scene, options, place = std::move(place)]() mutable -> std::string {
                     const std::lock_guard alone(one_picture_);
                     const std::optional<Image> image = drawn_apart(*shown, scene, options, shaders_);
                     return image ? kept_as(*image, place) : only_here;
                   }));
    notice(fmt::format("The picture is being drawn: {} \xC3\x97 {}", options.size.width, options.size.height));
  } catch (const Error& error) {
    state_.trouble = error.what();
  }
}

void Viewer::take_picture_here() {
  try {
    AtomicFile place(new_file(state_.shown->title, ".png"));
    notice(kept_as(picture(), place));
  } catch (const Error& error) {
    state_.trouble = error.what();
  }
}

void Viewer::save_scene() {
  try {
    const std::filesystem::path file = new_file(state_.shown->title + "-scene", ".json");
    Scene scene = scene_of_picture();
    if (transition_) scene.camera = transition_->goal();
    AtomicFile written(file);
    written.write(to_json(scene));
    written.commit();
    notice(fmt::format("Saved {}. odontoscope render --scene draws it again.", file.string()));
  } catch (const Error& error) {
    state_.trouble = error.what();
  }
}

void Viewer::take_written() {
  std::erase_if(writing_, [this](std::future<std::string>& writing) {
    if (writing.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
    try {
      const std::string words = writing.get();
      if (words == only_here)
        take_picture_here();
      else
        notice(words);
    } catch (const std::exception& error) {
      state_.trouble = error.what();
    }
    return true;
  });
}

}  // namespace odontoscope
