// Rides along canals, and the small picture of the tooth from outside.

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/ui/fly_annotations.h"
#include "engine/ui/viewer.h"

namespace odontoscope {

namespace {

constexpr double scrub_share = 0.02;  // of the track, with one key
constexpr int where_side = 2;         // samples a pixel along one axis: drawn once, so fine

}  // namespace

Track Viewer::rideable_track(std::size_t cavity, std::size_t line) {
  const auto lines = rideable(state_.shown->flight->cavities[cavity].lines);
  if (line >= lines.size()) {
    notice(lines.empty() ? "No canals were found in this cavity." : "There are not so many canals here.");
    return {};
  }
  Track track = track_of(*lines[line], state_.shown->flight->rules.clearance);
  if (track.points.empty()) notice("That canal is too narrow to fly in.");
  return track;
}

void Viewer::start_ride(std::size_t line, Track track) {
  Ride ride{.line = line, .track = std::move(track)};
  ride.along = ride.track.points.front().along;
  ride.playing = !state_.settings.comfort.reduced_motion;
  state_.fly.ride = std::move(ride);
  state_.fly.flight = flight_of(*state_.fly.ride, flight_rules());
  state_.fly.trail = {state_.fly.flight.eye};
}

void Viewer::begin_ride(std::size_t line) {
  if (!flight_possible() || state_.shown->flight->cavities.empty()) {
    notice("There is no cavity in this model, so there are no canals to ride.");
    return;
  }
  ride_canal(state_.fly.on && state_.fly.cavity ? *state_.fly.cavity : 0, line);
}

/// Free flight from where the ride is.
void Viewer::leave_ride() {
  FlyState& fly = state_.fly;
  const Walls& walls = walls_now();
  const double clearance = state_.shown->flight->rules.clearance;
  if (walls.nearest(fly.flight.eye).distance < clearance) {
    // Between two of the line's points it may be a hair narrower than at them.
    const auto& points = fly.ride->track.points;
    const Track::Point* best = nullptr;
    for (const Track::Point& point : points)
      if (walls.nearest(point.at).distance >= clearance &&
          (!best || std::abs(point.along - fly.ride->along) < std::abs(best->along - fly.ride->along)))
        best = &point;
    if (!best) return;
    fly.flight.eye = best->at;
  }
  fly.flight.velocity = glm::dvec3(0);
  fly.flight.turning = glm::dvec2(0);
  fly.ride.reset();
}

void Viewer::advance_ride(const FlightWish& wish, double seconds) {
  FlyState& fly = state_.fly;
  if (wish.move != glm::dvec3(0)) {
    leave_ride();
    return;
  }
  const FlightRules rules = flight_rules();
  const glm::dvec2 aim = glm::radians(rules.turn_deg_per_second) * glm::clamp(wish.turn, -1.0, 1.0);
  fly.flight.turning += (1 - std::exp(-seconds / rules.settle_seconds)) * (aim - fly.flight.turning);
  if (aim == glm::dvec2(0) && glm::length(fly.flight.turning) < 1e-4) fly.flight.turning = glm::dvec2(0);
  Ride& ride = *fly.ride;
  ride.look += seconds * fly.flight.turning;
  odontoscope::advance(ride, rules, seconds);
  if (!ride.playing && std::abs(ride.pace) < 1e-3) ride.pace = 0;
  const glm::dvec2 turning = fly.flight.turning;
  fly.flight = flight_of(ride, rules);
  fly.flight.turning = turning;
}

bool Viewer::perform_on_ride(Action action) {
  FlyState& fly = state_.fly;
  switch (action) {
    case Action::toggle_labels:
      fly.show_labels = !fly.show_labels;
      return true;
    case Action::toggle_depth:
      state_.settings.comfort.wall_depth = !state_.settings.comfort.wall_depth;
      return true;
    case Action::toggle_where:
      fly.show_where = !fly.show_where;
      return true;
    case Action::turn_where:
      fly.inset_from = fly.inset_from == NamedView::buccal   ? NamedView::mesial
                       : fly.inset_from == NamedView::mesial ? NamedView::occlusal
                                                             : NamedView::buccal;
      return true;
    case Action::next_canal: {
      if (!fly.cavity) {
        begin_ride(0);
        return true;
      }
      const std::size_t count = rideable(state_.shown->flight->cavities[*fly.cavity].lines).size();
      begin_ride(fly.ride && count > 0 ? (fly.ride->line + 1) % count : 0);
      return true;
    }
    case Action::ride_play:
      if (!fly.ride) begin_ride(fly.place ? fly.place->line : 0);
      break;
    case Action::ride_back:
    case Action::ride_farther:
    case Action::ride_nearer:
    case Action::ride_to_start:
    case Action::ride_to_end:
      break;
    default:
      return false;
  }
  if (!fly.ride) return true;
  Ride& ride = *fly.ride;
  const double from = ride.track.points.front().along, to = ride.track.points.back().along;
  switch (action) {
    case Action::ride_play:
      ride.playing = !ride.playing;
      if (ride.playing && !ride.back && ride.along >= to) ride.along = from;  // once more
      if (ride.playing && ride.back && ride.along <= from) ride.along = to;
      ride.look = ride.playing ? glm::dvec2(0) : ride.look;
      break;
    case Action::ride_back:
      ride.back = !ride.back;
      ride.playing = true;
      break;
    case Action::ride_farther:
      ride.along = std::min(ride.along + scrub_share * (to - from), to);
      break;
    case Action::ride_nearer:
      ride.along = std::max(ride.along - scrub_share * (to - from), from);
      break;
    case Action::ride_to_start:
      ride.along = from;
      break;
    case Action::ride_to_end:
      ride.along = to;
      break;
    default:
      break;
  }
  return true;
}

void Viewer::draw_inset(const Target& target) {
  if (!state_.fly.on || !state_.fly.show_where || panes_.empty()) return;
  const Area area = where_area(panes_.front(), scale_);
  const PixelSize size{static_cast<int>(area.width), static_cast<int>(area.height)};
  if (size.width < 1 || size.height < 1) return;
  if (!(inset_.size() == size) || inset_of_ != state_.shown || inset_from_ != state_.fly.inset_from) {
    inset_ = Framebuffer(*gl_, {size, {GL_RGBA8}});
    inset_of_ = state_.shown;
    inset_from_ = state_.fly.inset_from;
    Scene scene = usual_scene(state_.shown->model, area.aspect());
    scene.camera = where_camera(state_.shown->model, state_.fly.inset_from, area);
    scene.background = {Background::Kind::plain, colour_of(0x14181c), colour_of(0x14181c)};
    scene.occlusion.on = false;
    const Pane eye{odontoscope::view_of(scene.camera, state_.shown->model, area.aspect()), {inset_.id(), 0, 0, size}};
    renderer_.draw(gpu_model_, scene, {&eye, 1}, {where_side});
  }
  const int left = target.left + static_cast<int>(area.left),
            bottom = target.bottom + target.size.height - static_cast<int>(area.top) - size.height;
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, inset_.id());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
  gl_->BlitFramebuffer(0, 0, size.width, size.height, left, bottom, left + size.width, bottom + size.height,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace odontoscope
