#pragma once
// A tour as a camera that a file can carry.

#include <string>

#include "engine/navigate/tour.h"
#include "recon/formats/camera_path.h"

namespace odontoscope {

/// Keys a second. Straight lines between them stay within 1/100 of the clearance of the tour's places and within 0.2
/// degrees of its views, a test holds.
inline constexpr double camera_keys_per_second = 15;

/// `far_mm`: nothing to be seen lies farther away. The near plane is the nearest of the whole tour, since a file's
/// camera has one.
CameraPath camera_path(const Tour& tour, const std::string& name, double far_mm);

}  // namespace odontoscope
