#include "engine/viewer/save/save_mode.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/gpu/graphics_error.h"
#include "engine/picture/png.h"
#include "engine/scene/scene_json.h"
#include "engine/ui/widgets.h"
#include "engine/view/offscreen.h"
#include "engine/viewer/workspace.h"
#include "recon/core/atomic_file.h"

namespace odontoscope {

SaveMode::~SaveMode() {
  for (std::future<std::string>& writing : writing_) writing.wait();
}

bool SaveMode::perform(Action action) {
  if (!state_.shown) return false;
  if (action == Action::take_picture) take_picture();
  if (action == Action::save_scene) save_scene();
  return action == Action::take_picture || action == Action::save_scene;
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
void SaveMode::take_picture() {
  try {
    const std::filesystem::path file = at_.files.next(state_.shown->title, ".png");
    AtomicFile place(file);  // trouble with the folder is told before the work
    const Scene scene = at_.scene_of_picture();
    const PictureOptions options = at_.options_of_picture(scene);
    refuse_undrawable(at_.gl, options.size, options.render);
    writing_.push_back(
        std::async(std::launch::async,
                   [this, shown = state_.shown, scene, options, place = std::move(place)]() mutable -> std::string {
                     const std::lock_guard alone(one_picture_);
                     const std::optional<Image> image = drawn_apart(*shown, scene, options, at_.shaders);
                     return image ? kept_as(*image, place) : only_here;
                   }));
    notice(fmt::format("The picture is being drawn: {} \xC3\x97 {}", options.size.width, options.size.height));
  } catch (const Error& error) {
    state_.trouble = error.what();
  }
}

void SaveMode::take_picture_here() {
  try {
    AtomicFile place(at_.files.next(state_.shown->title, ".png"));
    notice(kept_as(at_.image(), place));
  } catch (const Error& error) {
    state_.trouble = error.what();
  }
}

void SaveMode::save_scene() {
  try {
    const std::filesystem::path file = at_.files.next(state_.shown->title + "-scene", ".json");
    Scene scene = at_.scene_of_picture();
    scene.camera = at_.camera_goal();
    AtomicFile written(file);
    written.write(to_json(scene));
    written.commit();
    notice(fmt::format("Saved {}. odontoscope render --scene draws it again.", file.string()));
  } catch (const Error& error) {
    state_.trouble = error.what();
  }
}

void SaveMode::update() {
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

std::vector<PanelSection> SaveMode::panel() {
  return {{SectionPlace::picture, [this] { section(); }}};
}

void SaveMode::section() {
  if (!widgets::section(at_.interface, "Picture", widgets::AtFirst::folded)) return;
  PictureSettings& picture = state_.settings.picture;
  ImGui::AlignTextToFramePadding();
  widgets::text("Size");
  const float field = widgets::scaled(84);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 2 * field - widgets::scaled(22));
  ImGui::SetNextItemWidth(field);
  widgets::text_field("##width");
  ImGui::InputInt("##width", &picture.width, 0);
  widgets::noted("##width");
  ImGui::SameLine(0, widgets::scaled(6));
  ImGui::TextUnformatted("\xC3\x97");
  ImGui::SameLine(0, widgets::scaled(6));
  ImGui::SetNextItemWidth(field);
  ImGui::BeginDisabled(picture.as_seen);
  widgets::text_field("##height");
  ImGui::InputInt("##height", &picture.height, 0);
  widgets::noted("##height");
  ImGui::EndDisabled();
  if (!ImGui::IsAnyItemActive()) {
    picture.width = std::clamp(picture.width, 16, 16384);
    picture.height = std::clamp(picture.height, 16, 16384);
  }
  widgets::toggle("Same shape as the view", picture.as_seen);
  widgets::text("Samples a pixel");
  int samples = picture.side - 1;
  if (widgets::choice("samples", samples, {"1", "4", "9", "16"})) picture.side = samples + 1;
  widgets::toggle("Transparent background", picture.transparent);
  if (widgets::wide_button("Take a picture", widgets::Emphasis::strong))
    state_.pending_actions.push_back(Action::take_picture);
  if (widgets::wide_button("Save camera and looks")) state_.pending_actions.push_back(Action::save_scene);
  const std::filesystem::path& folder = at_.files.folder();
  widgets::remark(at_.interface, folder.empty() ? "Files go to the folder that the viewer was started in."
                                                : fmt::format("Files are saved in {}", folder.string()));
  if (widgets::wide_button("Another folder\xE2\x80\xA6")) state_.pending_actions.push_back(Action::choose_save_folder);
}

}  // namespace odontoscope
