#pragma once
// What joins two canals of a root sideways.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/cavity/cavity.h"
#include "recon/cavity/centre_lines.h"
#include "recon/core/polygon.h"
#include "recon/mesh/plane_section.h"

namespace odontoscope {

/// Y. Y. Hsu, S. Kim, "The resected root surface: the issue of canal isthmuses", 1997, by sections across the root: I
/// no notable connection (there is none of these then), II a hair-thin one between two canals, III the same with three
/// canals, IV a canal that extends towards the other without reaching it, V a wide corridor. What hair-thin, wide and
/// extended are, that paper leaves to the eye: see limits::isthmus_thin, isthmus_reach.
struct Isthmus {
  std::string type;                   // "II" to "V"
  std::size_t one = 0, other = 0;     // of the canals
  double from_apex = 0, to_apex = 0;  // heights above the end of the lower canal: the lower and the upper one, mm
  double narrowest = 0;               // width of the connection, mm; 0 for type IV
};

namespace cavity {

/// Whether two canals are one where they pass this height: in one loop, and not joined by a mere isthmus
/// (limits::isthmus_wide).
bool is_one_section(const std::vector<Polygon>& loops, const CentreLine& a, const CentreLine& b, double z);

/// Of one root, from the apex up. `fall`: heights times this fall towards the apex. Runs lower than a canal is wide are
/// left out, as where canals part.
std::vector<Isthmus> isthmuses_of(const Cavity& cavity, const CentreLines& lines,
                                  const std::vector<std::size_t>& canals, double fall);

}  // namespace cavity

}  // namespace odontoscope
