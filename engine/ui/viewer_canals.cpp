// Canals pointed at from outside: through what is translucent, in the section, or in flight on the small picture of the
// tooth.

#include <algorithm>
#include <glm/geometric.hpp>

#include "engine/navigate/screen.h"
#include "engine/ui/annotations.h"
#include "engine/ui/fly_annotations.h"
#include "engine/ui/viewer.h"
#include "recon/core/lower_case.h"

namespace odontoscope {

namespace {

constexpr double slack_pixels = 5;
/// What is more opaque hides the pulp.
constexpr float see_through = 0.9f;

double slack_mm(const Camera& camera, const Area& area, float scale) {
  const double depth = std::max(depth_of(camera, camera.target), 1e-6);
  return slack_pixels * scale * 2 * half_height_at(camera, depth) / std::max(area.height, 1.0);
}

/// What fills the cavity, if a structure of the model does; else the cavity itself.
std::string pulp_of(const LoadedModel& shown, std::size_t cavity) {
  const auto pulp = std::find_if(shown.model.parts.begin(), shown.model.parts.end(), [](const ModelPart& part) {
    return !part.cavity && lower_case(part.structure).find("pulp") != std::string::npos;
  });
  return pulp != shown.model.parts.end() ? pulp->structure : shown.flight->cavities[cavity].structure;
}

/// From before all of the model: a parallel camera sees what lies behind its own place, too.
SightLine from_before(SightLine sight, const Camera& camera, const Model& model) {
  if (camera.projection == Camera::Projection::parallel)
    sight.origin -= (glm::length(sight.origin - model.bounds_mm.centre()) + 2 * model.radius_mm) * sight.direction;
  return sight;
}

}  // namespace

std::optional<CanalPick> Viewer::canal_at(const ViewPane& pane, double x, double y) const {
  if (!flight_possible() || pane.db || state_.fly.on) return std::nullopt;
  const SightLine sight =
      from_before(sight_line(pane.camera, place_in(pane.area, x, y)), pane.camera, state_.shown->model);
  CanalPickOptions options{.slack_mm = slack_mm(pane.camera, pane.area, scale_), .section = state_.scene.section};
  if (const auto hit =
          pick(pickable_of(pane), state_.scene, {sight.origin, sight.direction}, {.least_opacity = see_through}))
    options.sight_mm = hit->distance_mm;
  const auto found = pick_canal(*state_.shown->flight, sight, options);
  if (!found) return std::nullopt;
  // What has no wall in the picture cannot be pointed at, unless a section lays the hollow open.
  const Look* look = state_.scene.look_of(state_.shown->flight->cavities[found->cavity].structure);
  const bool drawn = look && look->visible && look->opacity > 0;
  return drawn || state_.scene.section ? found : std::nullopt;
}

/// For a question about the pulp a canal counts as soon as it is seen, whatever translucent lies before it.
std::optional<PointedAt> Viewer::pointed_at(const ViewPane& pane, double x, double y) const {
  const NotesState& notes = state_.notes;
  const LessonQuestion* question = notes.draft ? nullptr : lesson_.asked(notes);
  const auto is_pulp = [&](const std::string& structure) {
    const auto& cavities = state_.shown->flight->cavities;
    return lower_case(structure).find("pulp") != std::string::npos ||
           std::any_of(cavities.begin(), cavities.end(),
                       [&](const FlightSpace& space) { return space.structure == structure; });
  };
  const auto hit = hit_at(pane, x, y);
  if (const auto canal = canal_at(pane, x, y);
      canal && ((question && is_pulp(question->structure)) || (hit && is_pulp(hit->structure)) || !question))
    return PointedAt{question ? question->structure : pulp_of(*state_.shown, canal->cavity),
                     name_of(*canal, *state_.shown->flight)};
  return hit ? std::optional(PointedAt{hit->structure, ""}) : std::nullopt;
}

std::optional<CanalPick> Viewer::canal_in_small_picture(double x, double y) const {
  if (!state_.fly.on || !state_.fly.show_where || panes_.empty()) return std::nullopt;
  const Area area = where_area(panes_.front(), scale_);
  if (!area.holds(x, y)) return std::nullopt;
  const Camera camera = where_camera(state_.shown->model, state_.fly.inset_from, area);
  const SightLine sight = from_before(sight_line(camera, place_in(area, x, y)), camera, state_.shown->model);
  return pick_canal(*state_.shown->flight, sight, {.slack_mm = slack_mm(camera, area, scale_)});
}

void Viewer::ride_canal(std::size_t cavity, std::size_t line) {
  Track track = rideable_track(cavity, line);
  if (track.points.empty()) return;
  const bool there = state_.fly.on && state_.fly.cavity == cavity;
  if (there) {
    darken_then([this, line, cavity, track = std::move(track)]() mutable {
      if (state_.fly.on && state_.fly.cavity == cavity) start_ride(line, std::move(track));
    });
    return;
  }
  if (!state_.fly.on) camera_before_dive_ = transition_ ? transition_->goal() : state_.scene.camera;
  enter_cavity(cavity, [this, line, track = std::move(track)] { start_ride(line, track); });
}

void Viewer::enter_here() {
  if (state_.tool != Tool::look) {
    const ViewPane& pane = panes_.front();
    const double x = pane.area.left + pane.area.width / 2, y = pane.area.top + pane.area.height / 2;
    if (const auto hit = hit_at(pane, x, y))
      measure_at(pickable_of(pane), *hit);
    else
      notice("In the middle of the picture there is no surface: turn the model with the arrow keys.");
    return;
  }
  if (!state_.canal) return;
  if (state_.canal->in_chamber) {
    camera_before_dive_ = transition_ ? transition_->goal() : state_.scene.camera;
    enter_cavity(state_.canal->cavity);
    return;
  }
  ride_canal(state_.canal->cavity, state_.canal->line);
}

}  // namespace odontoscope
