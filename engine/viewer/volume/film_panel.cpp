#include "engine/viewer/volume/film_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "engine/measure/film_length.h"
#include "engine/scene/glm_vector.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"

namespace odontoscope {
namespace {

constexpr double farthest_swing_deg = 40;
/// How far the camera stands to the right of buccal, seen from there.
double swing_of(const Camera& camera) {
  const AnatomicalFrame tooth;
  const glm::dvec3 towards = camera.position - camera.target, right = glm::cross(tooth.occlusal, tooth.buccal);
  return glm::degrees(std::atan2(glm::dot(towards, right), glm::dot(towards, tooth.buccal)));
}

bool film_possible(const LoadedModel& shown) {
  return shown.certificate.verdict != Certificate::Verdict::wanting &&
         std::any_of(shown.model.parts.begin(), shown.model.parts.end(),
                     [](const ModelPart& part) { return part.attenuation > 0; });
}

std::vector<glm::dvec3> points_of(const CentreLine& line) {
  std::vector<glm::dvec3> points;
  for (const CentrePoint& point : line.points) points.push_back(vec(point.at));
  points.push_back(vec(line.end));
  return points;
}

void lengths_on_film(const ViewerState& state, const Interface& interface) {
  if (!state.shown->flight || state.shown->flight->cavities.empty()) return;
  const std::vector<CentreLine>& canals = state.shown->flight->cavities.front().lines.canals;
  if (canals.empty() || !ImGui::BeginTable("##lengths", 3)) return;
  ImGui::TableSetupColumn("##line", ImGuiTableColumnFlags_WidthStretch);
  for (const char* column : {"##film", "##true"})
    ImGui::TableSetupColumn(column, ImGuiTableColumnFlags_WidthFixed, widgets::scaled(62));
  const auto cell = [&](const std::string& words) {
    ImGui::TableNextColumn();
    widgets::text(words);
  };
  for (const char* head : {"Line", "On film", "True"}) cell(head);
  for (const CentreLine& line : canals) {
    const std::vector<glm::dvec3> points = points_of(line);
    cell(line.name);
    cell(fmt::format("{:.1f} mm", length_on_film(points, state.scene.camera, state.shown->model.bounds_mm.centre())));
    cell(fmt::format("{:.1f} mm", length_of(points)));
  }
  ImGui::EndTable();
  widgets::remark(
      interface,
      "From the chamber to the end of the root. The film hangs at the middle of the tooth, square to the rays: what "
      "leans towards the tube or away from it is shown shorter, what lies nearer the tube larger.");
}

/// One of the usual films, upright or across, or none with an edge. true: another was chosen.
bool choose_film(glm::dvec2& film_mm, const Interface& interface) {
  const glm::dvec2 before = film_mm;
  const auto size = dental_film(film_mm);
  bool across = film_mm.x > film_mm.y;
  int chosen = size ? 1 + static_cast<int>(*size) : film_mm.x > 0 ? -1 : 0;
  const auto turned = [&](const glm::dvec2& upright) { return across ? glm::dvec2(upright.y, upright.x) : upright; };
  widgets::remark(interface, "Film, by its size");
  if (widgets::choice("film", chosen, {"No edge", "0", "1", "2", "3", "4"}))
    film_mm = chosen > 0 ? turned(dental_films_mm[static_cast<std::size_t>(chosen - 1)]) : glm::dvec2(0);
  if (film_mm.x > 0) {
    if (widgets::toggle("Lies across", across)) std::swap(film_mm.x, film_mm.y);
    widgets::remark(interface, fmt::format("{:g} x {:g} mm, at the middle of the tooth", film_mm.x, film_mm.y));
  }
  return film_mm != before;
}

/// The camera is the tube.
void choose_beam(ViewerState& state, const Interface& interface) {
  const Camera& camera = state.scene.camera;
  int beam = camera.projection == Camera::Projection::parallel ? 1 : 0;
  if (widgets::choice("beam", beam, {"Cone beam", "Parallel beam"}))
    state.pending_actions.push_back(Action::toggle_projection);
  const double focus_mm = glm::distance(camera.position, state.shown->model.bounds_mm.centre());
  widgets::remark(interface, beam == 1 ? "All rays run one way, and all is shown in its own size."
                                       : fmt::format("Rays come from a focus {:.0f} mm before the film.", focus_mm));
}

}  // namespace

void film_controls(VolumeAsked& asked, ViewerState& state, const Interface& interface) {
  widgets::toggle("Inverted", state.scene.volume.inverted);
  if (choose_film(state.scene.volume.film_mm, interface)) asked.film = true;
  choose_beam(state, interface);
  double swing = std::clamp(std::round(swing_of(state.scene.camera)), -farthest_swing_deg, farthest_swing_deg);
  if (widgets::slider("Tube swung by", swing, -farthest_swing_deg, farthest_swing_deg, "%.0f\xC2\xB0"))
    asked.tube = std::round(swing);
  widgets::remark(interface,
                  "Same lingual, opposite buccal: of two canals that lie one behind the other, the one that moves with "
                  "the tube lies lingually.");
  lengths_on_film(state, interface);
}

void film_section(VolumeAsked& asked, ViewerState& state, const Interface& interface) {
  if (!state.shown || (state.shown->values && state.shown->greys) || !film_possible(*state.shown)) return;
  if (!widgets::section(interface, "X-ray")) return;
  bool on = state.film_of_model();
  if (widgets::toggle("As an X-ray film shows it", on)) {
    state.scene.volume.cast = on ? VolumeLook::Cast::radiograph : VolumeLook::Cast::shaded;
    state.scene.volume.shows = on ? VolumeLook::Shows::volume : VolumeLook::Shows::surfaces;
  }
  if (!on) return;
  widgets::slider("White at attenuation", state.scene.volume.latitude, 0.5, 10, "%.1f");
  film_controls(asked, state, interface);
}

}  // namespace odontoscope
