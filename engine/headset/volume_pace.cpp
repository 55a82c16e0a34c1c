#include "engine/headset/volume_pace.h"

#include <algorithm>

namespace odontoscope {

namespace {

/// Of a beat: the rest is the runtime's, and surfaces and the panel are drawn in it, too.
constexpr double most_share = 0.7, easy_share = 1.0 / 3;
constexpr double most_at_once = 2, less_at_once = 0.95;

}  // namespace

void VolumePace::took(double drawing_seconds, double beat_seconds) {
  if (!(drawing_seconds > 0) || !(beat_seconds > 0)) return;
  const double share = drawing_seconds / beat_seconds;
  if (share > most_share)
    coarseness_ *= std::min(share / most_share, most_at_once);
  else if (share < easy_share)
    coarseness_ *= less_at_once;
  coarseness_ = std::clamp(coarseness_, 1.0, coarsest);
}

}  // namespace odontoscope
