#include "engine/app/painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "engine/app/data_colour_words.h"
#include "engine/scene/wall_colours.h"

namespace odontoscope::app {

Painter::Painter(const PictureOptions& picture, const Gl& gl, Renderer& renderer, const Shown& shown,
                 const Scene& scene, Session& session)
    : picture_(picture),
      gl_(gl),
      renderer_(renderer),
      shown_(shown),
      session_(session),
      gpu_model_(upload(gl_, shown.model)),
      overlay_(upload(gl_, make_overlay(shown.overlays, scene.overlays, shown.model))),
      ct_(scene.section && scene.cap.shows == CapLook::Shows::ct),
      values_(ct_ || scene.volume.shows_volume() ? upload(gl_, *shown.values, gpu_model_) : GpuValueGrid{}) {
  if (scene.volume.shows_volume()) volume_.emplace(gl_, *shown.values, values_.field());
}

Image Painter::draw(const Scene& scene, std::size_t number, std::size_t count) {
  session_.progress().check();
  session_.progress().tell("draw", static_cast<double>(number) / static_cast<double>(count));
  Image image = picture_of(gl_, renderer_, gpu_model_, shown_.model, scene, picture_, &overlay_,
                           ct_ ? &values_ : nullptr, volume_ ? &*volume_ : nullptr);
  if (scene.data_colours) draw_legend(*scene.data_colours, image);
  if (const auto own = telling_thickness(scene, shown_.model)) draw_thickness_legend(*own, shown_.model, image);
  return image;
}

Camera turned(const Camera& camera, std::size_t number, std::size_t count) {
  const double degrees = 360.0 * static_cast<double>(number) / static_cast<double>(count);
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1), glm::radians(degrees), AnatomicalFrame().occlusal);
  Camera result = camera;
  result.position = camera.target + glm::dvec3(turn * glm::dvec4(camera.position - camera.target, 0));
  result.up = glm::dvec3(turn * glm::dvec4(camera.up, 0));
  return result;
}

double moment(const Film& film, std::size_t number, std::size_t count) {
  return film.tour.seconds() * static_cast<double>(number) / static_cast<double>(std::max<std::size_t>(count - 1, 1));
}

Image sheet_of(const Shown& shown, const Scene& scene, const Film& film, const SheetSize& size, Painter& painter) {
  const auto count = static_cast<std::size_t>(size.columns) * static_cast<std::size_t>(size.rows);
  const std::vector<double> moments = telling_moments(film, count);
  // A short tour's whole seconds would say the same of many.
  const int decimals = moments.back() - moments.front() < static_cast<double>(2 * count) ? 1 : 0;
  std::vector<SheetPicture> pictures;
  for (const double seconds : moments) {
    const std::size_t i = pictures.size();
    pictures.push_back({painter.draw(frame_of(scene, shown, film, seconds), i, count), station(film, seconds),
                        fmt::format("{:.{}f} s", seconds, decimals)});
  }
  return contact_sheet(pictures, size);
}

void refuse_cap_without_section(const SceneWords& words, const Scene& scene) {
  if (!words.cap.empty() && !scene.section)
    throw UsageError(fmt::format("--cap {}: nothing is cut open", words.cap), "Say with --section where to cut.");
}

}  // namespace odontoscope::app
