#include "engine/navigate/tour_camera_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "engine/scene/glm_vector.h"

namespace odontoscope {
CameraPath camera_path(const Tour& tour, const std::string& name, double far_mm) {
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(camera_keys_per_second * tour.seconds())));
  CameraPath path{.name = name,
                  .field_of_view_deg = tour.at(0).camera.field_of_view_deg,
                  .near_mm = tour.at(0).camera.near_mm,
                  .far_mm = far_mm,
                  .keys = {}};
  for (std::size_t i = 0; i <= steps; ++i) {
    const double seconds = tour.seconds() * static_cast<double>(i) / static_cast<double>(steps);
    const auto [camera, along, clearance, width] = tour.at(seconds);
    const glm::dvec3& at = camera.position;
    path.keys.push_back(
        {seconds, point(at), direction(glm::normalize(camera.target - at)), direction(camera.up), along});
    path.near_mm = std::min(path.near_mm, camera.near_mm);
  }
  return path;
}

}  // namespace odontoscope
