#include "engine/app/tour_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/app/wall_marks.h"
#include "engine/app/whole_structures.h"
#include "engine/navigate/seen_within.h"
#include "recon/cavity/centre_lines.h"
#include "recon/cavity/tooth_axis.h"
#include "recon/core/lower_case.h"

namespace odontoscope::app {
namespace {

/// The lamp's reach, in local radii: the next bend is lit, what lies far behind it is dark.
constexpr double lamp_reach = 5;
/// From so many of its radii the orifice fills the picture.
constexpr double mouth_ahead = 2;

/// "mesiobuccal canal" as one types it.
std::string typed(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return lower_case(std::move(name));
}

struct NamedLine {
  std::string name, number;  // "mesiobuccal-canal", "canal-1"
  const CentreLine* line;
};

std::vector<NamedLine> named_lines(const CentreLines& lines) {
  std::vector<NamedLine> named;
  const auto add = [&](const std::vector<CentreLine>& some, const char* kind) {
    for (std::size_t i = 0; i < some.size(); ++i)
      named.push_back({typed(some[i].name), fmt::format("{}-{}", kind, i + 1), &some[i]});
  };
  add(lines.canals, "canal");
  add(lines.horns, "horn");
  add(lines.others, "branch");
  add(lines.loops, "loop");
  return named;
}

}  // namespace

Film film_of(const Shown& shown, const TourWords& wanted, Session& session) {
  const std::vector<NamedMesh> whole = whole_structures(shown.surfaces);
  const std::vector<Cavity> cavities = cavities_in(looked_at(whole));
  if (cavities.empty()) throw UsageError("--tour: there is no void inside", what_a_void_takes);
  const auto number = static_cast<std::size_t>(wanted.void_number);
  if (number > cavities.size())
    throw UsageError(fmt::format("--void {}: there {} {} inside", number, cavities.size() == 1 ? "is" : "are",
                                 cavities.size() == 1 ? "one void" : fmt::format("{} voids", cavities.size())),
                     "The largest is 1.");
  const Cavity& cavity = cavities[number - 1];
  const CentreLines lines = centre_lines(cavity, {tooth_axis(looked_at(whole)).along}, session.progress());
  std::string names;
  for (const NamedLine& line : named_lines(lines)) {
    if (typed(wanted.line) == line.name || typed(wanted.line) == line.number) {
      const bool from_chamber = lines.has_chamber && line.number.rfind("loop", 0) != 0;
      return {Tour(*line.line, {.back = wanted.reverse}), *line.line, wall_of(cavity, shown.model), from_chamber};
    }
    names += (names.empty() ? "" : ", ") +
             (line.name == line.number ? line.number : fmt::format("{} ({})", line.number, line.name));
  }
  throw UsageError(fmt::format("--tour: there is no line \"{}\"", wanted.line),
                   names.empty() ? "The void has no branches." : "There are " + names + ".");
}

std::string station(const Film& film, double seconds) {
  const TourInstant now = film.tour.at(seconds);
  const CentrePoint& orifice = film.line.points[film.line.orifice];
  if (film.line.orifice == 0) {
    if (film.from_chamber && now.along < 0.5 * film.line.points.front().radius) return "chamber";
    return fmt::format("{}, {:.1f} mm", film.line.name, now.along);
  }
  const double depth = now.along - orifice.along;
  // In a small chamber all of it is near the orifice.
  if (depth < -std::min(mouth_ahead * orifice.radius, 0.5 * orifice.along)) return "chamber";
  if (depth <= orifice.radius) return "orifice";
  const bool lit = film.line.points.back().along - now.along <= lamp_reach * now.width;  // the end
  return fmt::format("{}, {:.1f} mm deep", lit ? "apex" : "canal", depth);
}

std::vector<double> telling_moments(const Film& film, std::size_t count) {
  constexpr double fills = 2.5;  // radii from the end
  const double all = film.tour.seconds(), last = film.line.points.back().along;
  const bool back = film.tour.at(0).along > film.tour.at(all).along;
  // The first instant at which it is no longer before a place, by halves.
  const auto when = [&](const auto& before) {
    double low = 0, high = all;  // inwards from the line's start
    for (int halving = 0; halving < 40; ++halving)
      (before(film.tour.at(back ? all - (low + high) / 2 : (low + high) / 2)) ? low : high) = (low + high) / 2;
    return high;
  };
  const double near_end = when([&](const TourInstant& now) { return last - now.along > fills * now.width; });
  // Of a line that is short for its width the end fills the picture from the start.
  const double end = near_end < all / 2 ? all : near_end;
  std::vector<double> moments;
  for (std::size_t i = 0; i < count; ++i)
    moments.push_back(count == 1 ? 0 : end * static_cast<double>(i) / static_cast<double>(count - 1));
  const CentrePoint& orifice = film.line.points[film.line.orifice];
  if (film.line.orifice > 0 && count > 2) {
    const double at_mouth =
        when([&](const TourInstant& now) { return now.along < orifice.along - mouth_ahead * orifice.radius; });
    const auto nearest = std::min_element(moments.begin() + 1, moments.end() - 1, [&](double a, double b) {
      return std::abs(a - at_mouth) < std::abs(b - at_mouth);
    });
    const double apart = 0.25 * end / static_cast<double>(count - 1);  // else the first or the last picture shows it
    if (at_mouth > *(nearest - 1) + apart && at_mouth < *(nearest + 1) - apart) *nearest = at_mouth;
  }
  if (!back) return moments;
  for (double& moment : moments) moment = all - moment;
  std::reverse(moments.begin(), moments.end());
  return moments;
}

Scene frame_of(const Scene& scene, const Shown& shown, const Film& film, double seconds) {
  const TourInstant now = film.tour.at(seconds);
  Scene frame = seen_within(scene, shown.model, film.wall, lamp_reach * now.width);
  frame.camera = now.camera;
  frame.back_faces = BackFaces::cull;
  return frame;
}

}  // namespace odontoscope::app
