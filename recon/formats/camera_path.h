#pragma once
// A camera that moves: what a file may carry beside its surfaces, so that a viewer can play it.

#include <string>
#include <vector>

#include "recon/mesh/vector.h"

namespace odontoscope {

/// An instant of it, in the model's coordinates. `view_direction` and `up` have length 1 and are at right angles.
struct CameraKey {
  double seconds = 0;
  Point3 at;  // mm
  Direction view_direction, up;
  double along = 0;  // mm, on the line that the camera follows
};

/// Perspective. Between keys place and turn go evenly.
struct CameraPath {
  std::string name;                // "mesiobuccal canal"
  double field_of_view_deg = 80;   // from top to bottom
  double near_mm = 0, far_mm = 0;  // the same at all times
  std::vector<CameraKey> keys;     // at least two, by ascending time from 0
};

}  // namespace odontoscope
