#include "engine/comparison/ridges.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include "recon/mesh/half_edges.h"

namespace odontoscope {

double ridges_mm(const SurfaceMesh& mesh, double degrees) {
  const auto at = [&](PointIndex i) { return glm::dvec3(mesh.points[i].x, mesh.points[i].y, mesh.points[i].z); };
  const auto across = [&](HalfEdge h) {
    const Triangle& t = mesh.triangles[h / 3];
    return glm::cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]));
  };
  const EdgeMates edges = edge_mates(mesh);
  const double least_cosine = std::cos(glm::radians(degrees));
  double length = 0;
  for (HalfEdge h = 0; h < edges.mate.size(); ++h) {
    const HalfEdge mate = edges.mate[h];
    if (mate >= EdgeMates::no_edge || mate < h) continue;
    const glm::dvec3 one = across(h), other = across(mate);
    const double sizes = glm::length(one) * glm::length(other);
    const double turned = start(mesh, mate) == start(mesh, h) ? -1 : 1;  // a misoriented pair
    if (sizes > 0 && turned * glm::dot(one, other) < least_cosine * sizes)
      length += glm::distance(at(start(mesh, h)), at(end(mesh, h)));
  }
  return length;
}

}  // namespace odontoscope
