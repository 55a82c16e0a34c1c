#include "engine/scene/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <string>

#include "recon/core/error.h"
#include "recon/core/portable_math.h"

namespace odontoscope {

namespace {

/// Room left around a fitted model, as a factor on its size.
constexpr double margin = 1.06;
/// The nearest that the near plane comes, in radii of the model: 32 bit depth is exact enough from there.
constexpr double least_near = 2e-3;
constexpr double widest_angle_deg = 170;
/// Below this no depth in single precision is of use.
constexpr double least_near_mm = 1e-9;
/// Sine of the smallest angle between `up` and the line of sight.
constexpr double least_sine = 1e-6;

/// What the picture must hold, measured along its axes from a place in the model.
struct Extent {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double middle() const { return 0.5 * (low + high); }
};

/// Every vertex, in mm. A tooth fills its box badly, so the box would leave too much room.
template <class Visit>
void for_each_vertex(const Model& model, Visit visit) {
  for (const ModelPart& part : model.parts)
    for (const glm::vec3& position : part.positions) visit(model.origin_mm + glm::dvec3(position) / metres_per_mm);
}

}  // namespace

ViewDirection direction_of(NamedView view, const AnatomicalFrame& frame) {
  switch (view) {
    case NamedView::buccal:
      return {frame.buccal, frame.occlusal};
    case NamedView::lingual:
      return {-frame.buccal, frame.occlusal};
    case NamedView::mesial:
      return {frame.mesial, frame.occlusal};
    case NamedView::distal:
      return {-frame.mesial, frame.occlusal};
    case NamedView::occlusal:
      return {frame.occlusal, -frame.buccal};
    case NamedView::apical:
      return {-frame.occlusal, frame.buccal};
    case NamedView::three_quarter:
      break;
  }
  return {glm::normalize(0.80 * frame.buccal - 0.45 * frame.mesial + 0.40 * frame.occlusal), frame.occlusal};
}

Camera fit(const Camera& looking, const Model& model, double aspect) {
  Camera camera = looking;
  camera.target = model.bounds_mm.centre();
  const glm::dvec3 towards_eye = glm::normalize(looking.position - looking.target);
  const glm::dvec3 right = glm::normalize(glm::cross(looking.up, towards_eye));
  const glm::dvec3 up = glm::cross(towards_eye, right);
  Extent across, along;
  for_each_vertex(model, [&](const glm::dvec3& vertex) {
    across.add(glm::dot(vertex - camera.target, right));
    along.add(glm::dot(vertex - camera.target, up));
  });
  camera.target += across.middle() * right + along.middle() * up;
  const double slope = portable::tan(glm::radians(camera.field_of_view_deg) / 2);
  double distance = 0, half_height = 0;
  for_each_vertex(model, [&](const glm::dvec3& vertex) {
    const glm::dvec3 offset = vertex - camera.target;
    const double half = margin * std::max(std::abs(glm::dot(offset, up)), std::abs(glm::dot(offset, right)) / aspect);
    distance = std::max(distance, glm::dot(offset, towards_eye) + half / slope);
    half_height = std::max(half_height, half);
  });
  camera.position = camera.target + distance * towards_eye;
  camera.height_mm = 2 * half_height;
  return camera;
}

Camera fit(NamedView view, const Model& model, double aspect, Camera::Projection projection,
           const AnatomicalFrame& frame) {
  const ViewDirection direction = direction_of(view, frame);
  Camera camera;
  camera.projection = projection;
  camera.position = direction.towards_eye;
  camera.target = glm::dvec3(0);
  camera.up = direction.up;
  return fit(camera, model, aspect);
}

View view_of(const Camera& camera, const Model& model, double aspect) {
  const auto shifted = [&](const glm::dvec3& place) { return metres_per_mm * (place - model.origin_mm); };
  const glm::dvec3 eye = shifted(camera.position), target = shifted(camera.target);
  const glm::dvec3 sight = glm::normalize(target - eye);
  const double radius = metres_per_mm * model.radius_mm;
  const double depth_of_centre = glm::dot(shifted(model.bounds_mm.centre()) - eye, sight);
  const double far_distance = std::max(depth_of_centre + 1.01 * radius, 4 * least_near * radius);
  View view;
  view.world_to_eye = glm::mat4(glm::lookAt(eye, target, camera.up));
  if (camera.projection == Camera::Projection::parallel) {
    const double half = 0.5 * metres_per_mm * camera.height_mm;
    view.eye_to_clip = glm::mat4(
        glm::ortho(-half * aspect, half * aspect, -half, half, depth_of_centre - 1.01 * radius, far_distance));
  } else {
    double near_distance = std::max(depth_of_centre - 1.01 * radius, least_near * radius);
    if (camera.near_mm > 0) near_distance = std::min(near_distance, metres_per_mm * camera.near_mm);
    view.eye_to_clip =
        glm::mat4(glm::perspective(glm::radians(camera.field_of_view_deg), aspect, near_distance, far_distance));
  }
  return view;
}

void validate(const Camera& camera, std::string_view file) {
  Place place;
  place.file = file;
  const auto refuse = [&](std::string_view wrong) {
    throw InputError("bad-camera", place, wrong, "Take a camera that `odontoscope` saved as a pattern.");
  };
  for (const glm::dvec3& v : {camera.position, camera.target, camera.up})
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
      refuse("the camera has a coordinate that is no number");
  const glm::dvec3 sight = camera.target - camera.position;
  if (!(glm::length(sight) > 0)) refuse("the camera stands on what it looks at");
  if (!(glm::length(camera.up) > 0) ||
      glm::length(glm::cross(glm::normalize(sight), glm::normalize(camera.up))) < least_sine)
    refuse("the camera's up points along its line of sight");
  if (!(camera.field_of_view_deg > 0 && camera.field_of_view_deg < widest_angle_deg))
    refuse("the camera's angle of view is not between 0 and 170 degrees");
  if (!(camera.height_mm > 0) || !std::isfinite(camera.height_mm)) refuse("the camera's height is not positive");
  if (!(camera.near_mm == 0 || (camera.near_mm >= least_near_mm && std::isfinite(camera.near_mm))))
    refuse("the camera's near plane is neither 0 nor at a sensible distance");
}

}  // namespace odontoscope
