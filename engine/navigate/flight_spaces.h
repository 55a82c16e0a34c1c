#pragma once
// Where one can fly in a model: the voids inside it, and the outside round it.

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "engine/navigate/flight.h"
#include "engine/navigate/seen_within.h"
#include "engine/navigate/walls.h"
#include "engine/scene/model.h"
#include "recon/cavity/centre_lines.h"
#include "recon/core/progress.h"

namespace odontoscope {

/// On a canal's wall, with the way from there to the nearest place on the outside.
struct ThinPlace {
  glm::dvec3 at{0};
  double mm = 0;
};

struct FlightSpace {
  std::string structure;  // the model's part whose triangles are the wall
  bool body = false;      // that part fills the void: its wall is seen when it is turned inside out
  Walls walls;
  double volume_mm3 = 0;
  glm::dvec3 middle{0};                     // its roomiest place
  double clearance_mm = 0;                  // clearance there
  CentreLines lines;                        // empty where none could be made
  std::vector<ThinPlace> thin_places = {};  // see thickness_colours.h

  VoidWall wall() const { return {structure, body}; }
};

struct FlightSpaces {
  std::vector<FlightSpace> cavities;  // largest first; only those that the flying ball fits into
  std::vector<Walls> bodies;          // the outer surfaces, one a structure,
  Walls outside;                      // and all of them together
  FlightRules rules;

  /// In no structure and in no cavity, exactly.
  bool outdoors(const glm::dvec3& place) const;
};

/// `surfaces` are those that `model` was made from. Stage "centre lines". Throws Cancelled. A surface that is no closed
/// manifold gives no cavities, but is a wall all the same.
FlightSpaces flight_spaces(const std::vector<NamedSurface>& surfaces, const Model& model,
                           const Progress& progress = {});

/// Where one comes out who goes on straight through the wall ahead.
struct Passage {
  std::optional<std::size_t> cavity;  // none: outdoors
  glm::dvec3 at{0};
};
/// The next free space beyond the wall ahead with room for the ball; none if all beyond is solid or too narrow. `from`
/// as above.
std::optional<Passage> passage_ahead(const FlightSpaces& spaces, std::optional<std::size_t> from, const Flight& flight);

}  // namespace odontoscope
