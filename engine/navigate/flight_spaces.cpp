#include "engine/navigate/flight_spaces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "recon/cavity/tooth_axis.h"
#include "recon/core/error.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {

namespace {

/// With room to turn, not only to be.
constexpr double least_clearance = 1.5;
/// Voids beyond are bubbles.
constexpr std::size_t most_cavities = 32;
/// How far outside the wall one comes out, in clearances.
constexpr double outdoors_ahead = 40;

CentreLines lines_of(const Cavity& cavity, const ToothAxis& axis, const Progress& progress) {
  try {
    return centre_lines(cavity, {axis.along}, progress);
  } catch (const UsageError&) {
    return {};  // one can fly without
  }
}

}  // namespace

bool FlightSpaces::outdoors(const glm::dvec3& place) const {
  const auto around = [&](const Walls& walls) { return walls.locate(place) != Walls::Side::outside; };
  return std::none_of(bodies.begin(), bodies.end(), around) &&
         std::none_of(cavities.begin(), cavities.end(), [&](const FlightSpace& space) { return around(space.walls); });
}

FlightSpaces flight_spaces(const std::vector<NamedSurface>& surfaces, const Model& model, const Progress& progress) {
  FlightSpaces spaces;
  spaces.rules = rules_for(model.radius_mm);
  std::vector<StructureSurface> structures;
  std::vector<const SurfaceMesh*> outer;
  for (const NamedSurface& named : surfaces) {
    structures.push_back({named.structure, &named.surface});
    if (named.cavity) continue;
    outer.push_back(&named.surface);
    spaces.bodies.emplace_back(named.surface);
  }
  spaces.outside = Walls(outer);
  const ToothAxis axis = tooth_axis(structures);
  for (const Cavity& cavity : cavities_in(structures)) {
    if (spaces.cavities.size() == most_cavities) break;
    progress.check();
    FlightSpace space;
    space.structure = cavity.structure;
    space.walls = Walls(cavity.wall);
    space.volume_mm3 = cavity.volume;
    const auto roomiest = place_of_largest_clearance(space.walls);
    if (!roomiest || roomiest->clearance < least_clearance * spaces.rules.clearance) continue;
    space.middle = roomiest->at;
    space.clearance_mm = roomiest->clearance;
    space.body = cavity.body;
    space.lines = lines_of(cavity, axis, progress);
    spaces.cavities.push_back(std::move(space));
  }
  return spaces;
}

std::optional<Passage> passage_ahead(const FlightSpaces& spaces, std::optional<std::size_t> from,
                                     const Flight& flight) {
  const double clearance = spaces.rules.clearance;
  std::vector<double> meetings = spaces.outside.meetings(flight.eye, flight.view_direction);
  for (const FlightSpace& space : spaces.cavities) {
    const std::vector<double> more = space.walls.meetings(flight.eye, flight.view_direction);
    meetings.insert(meetings.end(), more.begin(), more.end());
  }
  std::sort(meetings.begin(), meetings.end());
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    const bool last = i + 1 == meetings.size();
    const double ahead = last ? meetings[i] + outdoors_ahead * clearance : 0.5 * (meetings[i] + meetings[i + 1]);
    const glm::dvec3 at = flight.eye + ahead * flight.view_direction;
    for (std::size_t c = 0; c < spaces.cavities.size(); ++c) {
      const Walls& walls = spaces.cavities[c].walls;
      if (from != c && walls.locate(at) == Walls::Side::inside && walls.nearest(at).distance >= clearance)
        return Passage{c, at};
    }
    if (from && spaces.outdoors(at) && spaces.outside.nearest(at).distance >= clearance)
      return Passage{std::nullopt, at};
  }
  return std::nullopt;
}

}  // namespace odontoscope
