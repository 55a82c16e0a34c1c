#include "engine/measure/film_length.h"

#include <glm/geometric.hpp>
#include <vector>

namespace odontoscope {

double length_of(std::span<const glm::dvec3> points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += glm::distance(points[i - 1], points[i]);
  return sum;
}

double length_on_film(std::span<const glm::dvec3> points, const Camera& camera, const glm::dvec3& centre) {
  const glm::dvec3 ahead = glm::normalize(camera.target - camera.position);
  const double film = glm::dot(centre - camera.position, ahead);
  std::vector<glm::dvec3> shadow;
  for (const glm::dvec3& point : points) {
    const glm::dvec3 way = point - camera.position;
    const double depth = glm::dot(way, ahead);
    if (camera.projection == Camera::Projection::parallel)
      shadow.push_back(way - depth * ahead);
    else if (depth > 0)
      shadow.push_back(film / depth * way);
  }
  return length_of(shadow);
}

}  // namespace odontoscope
