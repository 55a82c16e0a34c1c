#include "engine/scene/normals.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "recon/core/portable_math.h"

namespace odontoscope {

namespace {

glm::dvec3 position(const SurfaceMesh& mesh, PointIndex index) {
  const Point3& point = mesh.points[index];
  return {point.x, point.y, point.z};
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

double corner_angle(const SurfaceMesh& mesh, const Triangle& triangle, int corner) {
  const glm::dvec3 apex = position(mesh, triangle[corner]);
  const glm::dvec3 u = unit_or_zero(position(mesh, triangle[(corner + 1) % 3]) - apex);
  const glm::dvec3 v = unit_or_zero(position(mesh, triangle[(corner + 2) % 3]) - apex);
  return portable::acos(std::clamp(glm::dot(u, v), -1.0, 1.0));
}

/// The corners around each vertex: those of vertex v are list[first[v]] to list[first[v + 1]].
struct CornersAround {
  std::vector<std::size_t> first;
  std::vector<std::size_t> list;
};

CornersAround corners_around(const SurfaceMesh& mesh) {
  CornersAround around;
  around.first.assign(mesh.points.size() + 1, 0);
  for (const Triangle& triangle : mesh.triangles)
    for (const PointIndex vertex : triangle) ++around.first[vertex + 1];
  for (std::size_t v = 0; v < mesh.points.size(); ++v) around.first[v + 1] += around.first[v];
  around.list.resize(3 * mesh.triangles.size());
  std::vector<std::size_t> next(around.first.begin(), around.first.end() - 1);
  for (std::size_t corner = 0; corner < around.list.size(); ++corner)
    around.list[next[mesh.triangles[corner / 3][corner % 3]]++] = corner;
  return around;
}

}  // namespace

std::vector<glm::vec3> corner_normals(const SurfaceMesh& mesh, double crease_deg) {
  const double least_cosine = portable::cos(glm::radians(crease_deg));
  std::vector<glm::dvec3> face(mesh.triangles.size());
  std::vector<double> angle(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    const glm::dvec3 a = position(mesh, triangle[0]);
    face[t] = unit_or_zero(glm::cross(position(mesh, triangle[1]) - a, position(mesh, triangle[2]) - a));
    for (int corner = 0; corner < 3; ++corner) angle[3 * t + corner] = corner_angle(mesh, triangle, corner);
  }
  const CornersAround around = corners_around(mesh);
  std::vector<glm::vec3> normals(3 * mesh.triangles.size());
  for (std::size_t corner = 0; corner < normals.size(); ++corner) {
    const PointIndex vertex = mesh.triangles[corner / 3][corner % 3];
    const glm::dvec3 own = face[corner / 3];
    glm::dvec3 sum(0);
    for (std::size_t i = around.first[vertex]; i < around.first[vertex + 1]; ++i) {
      const std::size_t other = around.list[i];
      if (glm::dot(face[other / 3], own) >= least_cosine || other == corner) sum += angle[other] * face[other / 3];
    }
    const glm::dvec3 normal = unit_or_zero(sum);
    normals[corner] = normal == glm::dvec3(0) ? glm::vec3(0, 0, 1) : glm::vec3(normal);
  }
  return normals;
}

}  // namespace odontoscope
