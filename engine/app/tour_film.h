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

/// A tour, the line that it follows, and whose walls it leads past.
struct Film {
  Tour tour;
  CentreLine line;
  VoidWall wall;
  bool from_chamber = false;  // the line begins in the chamber's centre
};

struct TourWords {
  std::string
      line;  // "canal-1", "mesiobuccal-canal", "horn-2", "loop-1"; numbers always count as docs/navigation.md says
  int void_number = 1;   // by size
  bool reverse = false;  // from the end out
};

/// The tour through a void of what is shown. UsageError with the list of names if there is none such.
Film film_of(const Shown& shown, const TourWords& wanted, Session& session);

/// Where the eye is at `seconds`, in an anatomist's words: "chamber", "orifice", "canal, 3.2 mm deep", "apex, 9.8 mm
/// deep"; along other lines "horn 1, 2.0 mm". What begins in a chamber is in the "chamber" there.
std::string station(const Film& film, double seconds);

/// `count` moments that show a whole tour: evenly from its start to where the line's end fills the picture (nearer, a
/// wall is all that is seen; if that is less than half of it, to its end), but that the one nearest to the orifice is
/// moved before it, unless the first picture shows it. Strictly ascending; a tour in reverse has them the other way
/// round.
std::vector<double> telling_moments(const Film& film, std::size_t count);

/// How `scene` looks at `seconds` of the tour: a lamp carried along, only the wall, seen from within, and back faces
/// culled.
Scene frame_of(const Scene& scene, const Shown& shown, const Film& film, double seconds);

}  // namespace odontoscope::app
