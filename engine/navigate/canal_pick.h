#pragma once
// Which canal does one point at from outside, through what is translucent, or where a section lays it open?

#include <limits>

#include "engine/navigate/flight_spaces.h"
#include "engine/navigate/ride.h"
#include "engine/navigate/screen.h"
#include "engine/scene/scene.h"

namespace odontoscope {

struct CanalPick {
  std::size_t cavity = 0;   // of FlightSpaces::cavities
  std::size_t line = 0;     // of rideable() there
  bool in_chamber = false;  // before the line's orifice: pointed at is the chamber
  glm::dvec3 at{0};         // on the line
  friend bool operator==(const CanalPick&, const CanalPick&) = default;
};

struct CanalPickOptions {
  /// How far from the line of sight something opaque hides what is behind it.
  double sight_mm = std::numeric_limits<double>::infinity();
  /// A miss by so much is none: canals are thin.
  double slack_mm = 0;
  /// What it cut away is not pointed at.
  std::optional<Section> section = {};
};

/// Where the line of sight runs in a void: the centre line nearest to it there. Otherwise the nearest that it misses by
/// no more than the line's clearance and the slack. None: it points at no void, or at one without lines.
std::optional<CanalPick> pick_canal(const FlightSpaces& spaces, const SightLine& sight,
                                    const CanalPickOptions& options = {});

}  // namespace odontoscope
