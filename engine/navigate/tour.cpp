#include "engine/navigate/tour.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/navigate/flight.h"
#include "recon/core/error.h"
#include "recon/core/portable_math.h"

namespace odontoscope {
namespace {

/// Between two frames of the table.
constexpr double table_step = 1.0 / 120;
/// Gentle start and stop, s each.
constexpr double ease_seconds = 1.2;
/// How far ahead the eye looks, in local radii.
constexpr double look_ahead = 2.5;
/// Samples for each piece between two points of the line.
constexpr std::size_t samples_a_piece = 4;
/// Near its end a canal is so narrow that its last hundredths would take forever: it is passed as if it were this share
/// of its median width.
constexpr double least_width = 0.2;
constexpr int most_slowdowns = 12;

/// Weights of a uniform cubic B-spline at `t` in [0, 1] between the second and the third of four points: smooth to the
/// second derivative.
std::array<double, 4> spline_weights(double t) {
  const double u = 1 - t;
  return {u * u * u / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * u * u * u - 6 * u * u + 4) / 6, t * t * t / 6};
}

/// Value of the spline at `place` in [0, n - 1]; it starts and ends in the first and the last value.
template <class Value, class Get>
Value spline(std::size_t count, double place, Get get) {
  const double held = std::clamp(place, 0.0, static_cast<double>(count - 1));
  const std::size_t piece = std::min(static_cast<std::size_t>(held), count - 2);
  const auto at = [&](std::ptrdiff_t i) -> Value {
    if (i < 0) return 2.0 * get(0) - get(1);
    if (i >= static_cast<std::ptrdiff_t>(count)) return 2.0 * get(count - 1) - get(count - 2);
    return get(static_cast<std::size_t>(i));
  };
  const std::array<double, 4> w = spline_weights(held - static_cast<double>(piece));
  const auto first = static_cast<std::ptrdiff_t>(piece) - 1;
  return w[0] * at(first) + w[1] * at(first + 1) + w[2] * at(first + 2) + w[3] * at(first + 3);
}

template <class Value>
void smooth(std::vector<Value>& values, std::size_t times) {
  for (; times > 0; --times) {
    std::vector<Value> there = values;
    for (std::size_t i = 1; i + 1 < values.size(); ++i)
      there[i] = 0.25 * values[i - 1] + 0.5 * values[i] + 0.25 * values[i + 1];
    values = std::move(there);
  }
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return portable::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// The line as samples evenly along it, with what the eye sees there.
struct Way {
  std::vector<glm::dvec3> at, view_direction;
  std::vector<double> along, clearance, width;  // width: the radius that sets the speed
};

glm::dvec3 place_ahead(const Way& way, std::size_t from, double distance) {
  std::size_t i = from;
  double left = distance;
  while (i + 1 < way.at.size()) {
    const double piece = glm::length(way.at[i + 1] - way.at[i]);
    if (piece >= left) return way.at[i] + (piece > 0 ? left / piece : 0) * (way.at[i + 1] - way.at[i]);
    left -= piece;
    ++i;
  }
  const std::size_t before = way.at.size() - 1 - std::min<std::size_t>(way.at.size() - 1, 4 * samples_a_piece);
  return way.at.back() + left * glm::normalize(way.at.back() - way.at[before]);
}

/// Takes out waves shorter than some ten points, and keeps bends where they are (Taubin's two steps, see the line's own
/// smoothing).
void even_out(std::vector<glm::dvec3>& places, std::size_t times) {
  for (; times > 0; --times) {
    for (const double share : {0.5, -0.503}) {
      std::vector<glm::dvec3> there = places;
      for (std::size_t i = 1; i + 1 < places.size(); ++i)
        there[i] += share * (0.5 * (places[i - 1] + places[i + 1]) - places[i]);
      places = std::move(there);
    }
  }
}

/// Takes out what little crookedness a line has left, which a fast eye would feel, and not more than a share of the
/// clearance; that then is less by as much.
void make_even(std::vector<CentrePoint>& points) {
  constexpr double most = 0.3;
  std::vector<glm::dvec3> places;
  for (const CentrePoint& p : points) places.emplace_back(p.at.x, p.at.y, p.at.z);
  const std::vector<glm::dvec3> before = places;
  for (const std::size_t times : {200u, 40u}) {
    even_out(places, times);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const glm::dvec3 off = places[i] - before[i];
      const double far = glm::length(off);
      if (far > most * points[i].radius) places[i] = before[i] + most * points[i].radius / far * off;
    }
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    points[i].at = {places[i].x, places[i].y, places[i].z};
    points[i].radius -= glm::length(places[i] - before[i]);
  }
}

Way way_along(const CentreLine& line, bool back) {
  std::vector<CentrePoint> points = line.points;
  if (back) std::reverse(points.begin(), points.end());
  make_even(points);
  std::vector<double> widths;
  for (const CentrePoint& p : points) widths.push_back(p.radius);
  std::nth_element(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2), widths.end());
  const double least = least_width * widths[widths.size() / 2];
  std::vector<double> logs;
  for (const CentrePoint& p : points) logs.push_back(portable::log(std::max(p.radius, least)));
  constexpr std::size_t over_two_radii = 16;
  smooth(logs, over_two_radii);
  Way way;
  const std::size_t samples = (points.size() - 1) * samples_a_piece;
  for (std::size_t k = 0; k <= samples; ++k) {
    const double place = static_cast<double>(k) / samples_a_piece;
    const std::size_t piece = std::min(k / samples_a_piece, points.size() - 2);
    way.at.push_back(spline<glm::dvec3>(points.size(), place, [&](std::size_t i) {
      return glm::dvec3(points[i].at.x, points[i].at.y, points[i].at.z);
    }));
    way.along.push_back(spline<double>(points.size(), place, [&](std::size_t i) { return points[i].along; }));
    way.width.push_back(portable::exp(spline<double>(points.size(), place, [&](std::size_t i) { return logs[i]; })));
    way.clearance.push_back(std::min(points[piece].radius, points[piece + 1].radius));
  }
  for (std::size_t k = 0; k <= samples; ++k)
    way.view_direction.push_back(glm::normalize(place_ahead(way, k, look_ahead * way.width[k]) - way.at[k]));
  smooth(way.view_direction, 4 * samples_a_piece * samples_a_piece);
  for (glm::dvec3& view_direction : way.view_direction) view_direction = glm::normalize(view_direction);
  return way;
}

/// mm a second at each sample: so many radii, less where the view turns fast.
std::vector<double> speeds(const Way& way, double radii_per_second) {
  constexpr double of_bound = 0.7;  // room for smoothing
  std::vector<double> logs;
  for (std::size_t k = 0; k < way.at.size(); ++k) {
    double speed = radii_per_second * way.width[k];
    if (k + 1 < way.at.size()) {
      const double piece = glm::length(way.at[k + 1] - way.at[k]),
                   turn = angle_between(way.view_direction[k], way.view_direction[k + 1]);
      if (turn * speed > of_bound * glm::radians(Tour::largest_turn_deg_s) * piece)
        speed = of_bound * glm::radians(Tour::largest_turn_deg_s) * piece / turn;
    }
    logs.push_back(portable::log(speed));
  }
  smooth(logs, 4 * samples_a_piece * samples_a_piece);
  for (double& speed : logs) speed = portable::exp(speed);
  return logs;
}

/// Share of the way gone after a share of the time, both 0 to 1: speed grows from nothing over `ease`, is even, and
/// fades likewise.
double eased(double share, double ease) {
  // The integral of t^2 (3 - 2 t) from 0.
  const auto grown = [](double t) { return t * t * t - t * t * t * t / 2; };
  const double even = 1 / (1 - ease);
  if (share < ease) return even * ease * grown(share / ease);
  if (share > 1 - ease) return 1 - even * ease * grown((1 - share) / ease);
  return even * (ease / 2 + share - ease);
}

}  // namespace

Tour::Tour(const CentreLine& line, const TourOptions& options) : options_(options) {
  if (!(options.radii_per_second >= 0.05 && options.radii_per_second <= 20))
    throw UsageError(fmt::format("a tour at {:g} radii a second makes no sense", options.radii_per_second),
                     "Choose 0.05 to 20.");
  const Way way = way_along(line, options.back);
  double slower = 1;
  for (int attempt = 0; attempt < most_slowdowns; ++attempt) {
    const std::vector<double> speed = speeds(way, options.radii_per_second / slower);
    std::vector<double> when{0};
    for (std::size_t k = 1; k < way.at.size(); ++k)
      when.push_back(when.back() + glm::length(way.at[k] - way.at[k - 1]) * 2 / (speed[k] + speed[k - 1]));
    const double ease_time = slower * ease_seconds, whole = when.back() + ease_time,
                 ease = std::min(0.5, ease_time / whole);
    const std::size_t steps = std::max<std::size_t>(8, static_cast<std::size_t>(std::ceil(whole / table_step)));
    step_ = whole / static_cast<double>(steps);
    frames_.assign(steps + 1, {});
    std::vector<glm::dvec3> view_directions(steps + 1);
    std::size_t k = 0;
    for (std::size_t i = 0; i <= steps; ++i) {
      const double time = when.back() * eased(static_cast<double>(i) / static_cast<double>(steps), ease);
      while (k + 2 < when.size() && when[k + 1] < time) ++k;
      const double place = static_cast<double>(k) + std::clamp((time - when[k]) / (when[k + 1] - when[k]), 0.0, 1.0);
      Frame& frame = frames_[i];
      frame.at = spline<glm::dvec3>(way.at.size(), place, [&](std::size_t j) { return way.at[j]; });
      frame.along = spline<double>(way.at.size(), place, [&](std::size_t j) { return way.along[j]; });
      frame.width = spline<double>(way.at.size(), place, [&](std::size_t j) { return way.width[j]; });
      frame.clearance = std::min(way.clearance[k], way.clearance[k + 1]);
      view_directions[i] =
          spline<glm::dvec3>(way.at.size(), place, [&](std::size_t j) { return way.view_direction[j]; });
    }
    // Between samples time runs evenly, so that speed changes in steps: both are smoothed over time, too.
    constexpr std::size_t over_a_fifth_second = 150;
    smooth(view_directions, over_a_fifth_second);
    std::vector<glm::dvec3> places;
    for (const Frame& frame : frames_) places.push_back(frame.at);
    smooth(places, over_a_fifth_second);
    for (std::size_t i = 0; i <= steps; ++i) frames_[i].at = places[i];
    for (std::size_t i = 0; i <= steps; ++i) frames_[i].view_direction = glm::normalize(view_directions[i]);
    double turn = 0, jerk = 0;
    for (std::size_t i = 1; i <= steps; ++i)
      turn = std::max(turn, angle_between(frames_[i - 1].view_direction, frames_[i].view_direction) / step_);
    for (std::size_t i = 3; i <= steps; ++i) {
      const glm::dvec3 third = frames_[i].at - 3.0 * frames_[i - 1].at + 3.0 * frames_[i - 2].at - frames_[i - 3].at;
      jerk = std::max(jerk, glm::length(third) / (step_ * step_ * step_) / frames_[i].width);
    }
    constexpr double margin = 0.95;
    const double factor =
        std::max(turn / (margin * glm::radians(largest_turn_deg_s)), portable::cbrt(jerk / (margin * largest_jerk)));
    if (factor <= 1) break;
    slower *= 1.02 * factor;
  }
  const glm::dvec3& view_direction = frames_.front().view_direction;
  constexpr double nearly_along = 0.9;
  const glm::dvec3 wanted = std::abs(glm::dot(view_direction, glm::normalize(options.upright))) < nearly_along
                                ? options.upright
                                : options.otherwise;
  frames_.front().up = glm::normalize(wanted - glm::dot(wanted, view_direction) * view_direction);
  for (std::size_t i = 1; i < frames_.size(); ++i) {
    // The smallest rotation from one line of view_direction to the next, as two reflections.
    const glm::dvec3 &a = frames_[i - 1].view_direction, &b = frames_[i].view_direction, &u = frames_[i - 1].up;
    const glm::dvec3 turned = u - glm::dot(u, b) / (1 + glm::dot(a, b)) * (a + b);
    frames_[i].up = glm::normalize(turned - glm::dot(turned, b) * b);
  }
}

TourInstant Tour::at(double seconds) const {
  const double place = std::clamp(seconds, 0.0, this->seconds()) / step_;
  const auto value = [&](glm::dvec3 Frame::*member) {
    return spline<glm::dvec3>(frames_.size(), place, [&](std::size_t i) { return frames_[i].*member; });
  };
  const std::size_t before = std::min(static_cast<std::size_t>(place), frames_.size() - 2);
  TourInstant instant;
  instant.clearance = std::min(frames_[before].clearance, frames_[before + 1].clearance);
  instant.along = spline<double>(frames_.size(), place, [&](std::size_t i) { return frames_[i].along; });
  instant.width = spline<double>(frames_.size(), place, [&](std::size_t i) { return frames_[i].width; });
  Camera& camera = instant.camera;
  camera.position = value(&Frame::at);
  const glm::dvec3 view_direction = glm::normalize(value(&Frame::view_direction)), up = value(&Frame::up);
  camera.target = camera.position + instant.clearance * view_direction;
  camera.up = glm::normalize(up - glm::dot(up, view_direction) * view_direction);
  camera.field_of_view_deg = options_.field_of_view_deg;
  constexpr double share = 0.5;  // of the clearance: points between those of the line are a little nearer to the wall
  camera.near_mm = safe_near_mm(share * instant.clearance, options_.field_of_view_deg, options_.widest_aspect);
  return instant;
}

}  // namespace odontoscope
