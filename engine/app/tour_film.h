#pragma once
// Pictures along a tour: which line is meant, and what each frame looks like.

#include <cstddef>
#include <string>
#include <vector>

#include "engine/app/shown_input.h"
#include "engine/navigate/seen_within.h"
#include "engine/navigate/tour.h"
#include "engine/scene/scene.h"

namespace odontoscope::app {

/// A tour, and whose walls it leads past.
struct Film {
  Tour tour;
  VoidWall wall;
};

/// The tour through the largest void of what is shown along the line that is called `wanted`: "canal-1", "mesiobuccal-canal", "horn-2", "loop-1"; numbers
/// always count as docs/navigation.md says. UsageError with the list of names if there is none such.
Film film_of(const Shown& shown, const std::string& wanted, Session& session);

/// How `scene` looks at `seconds` of the tour: a lamp carried along, only the wall, seen from within, and back faces culled.
Scene frame_of(const Scene& scene, const Shown& shown, const Film& film, double seconds);

}  // namespace odontoscope::app
