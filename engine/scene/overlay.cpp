#include "engine/scene/overlay.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "recon/mesh/faulty_edges.h"

namespace odontoscope {

namespace {

glm::vec3 in_metres(const Point3& point, const glm::dvec3& origin_mm) {
  return glm::vec3(metres_per_mm * (glm::dvec3(point.x, point.y, point.z) - origin_mm));
}

LineSet& lines_of(std::vector<LineSet>& lines, LineKind kind, const std::string& structure) {
  const auto found = std::find_if(lines.begin(), lines.end(),
                                  [&](const LineSet& set) { return set.kind == kind && set.structure == structure; });
  return found != lines.end() ? *found : lines.emplace_back(LineSet{kind, structure, {}});
}

/// All of them, or those of the two slices that bound the slab.
void add_contours(const ContourStack& stack, std::optional<std::size_t> slab, const glm::dvec3& origin_mm,
                  std::vector<LineSet>& lines) {
  for (std::size_t k = 0; k < stack.slices.size(); ++k) {
    if (slab && k != *slab && k != *slab + 1) continue;
    const Slice& slice = stack.slices[k];
    for (const Contour& contour : slice.contours) {
      std::vector<glm::vec3>& points = lines_of(lines, LineKind::contour, contour.structure).points;
      for (std::size_t i = 0; i < contour.points.size(); ++i) {
        const Point2 &from = contour.points[i], &to = contour.points[(i + 1) % contour.points.size()];
        points.push_back(in_metres({from.x, from.y, slice.z}, origin_mm));
        points.push_back(in_metres({to.x, to.y, slice.z}, origin_mm));
      }
    }
  }
}

LineKind kind_of(EdgeFault fault) {
  switch (fault) {
    case EdgeFault::boundary:
      return LineKind::boundary_edge;
    case EdgeFault::misoriented:
      return LineKind::misoriented_edge;
    case EdgeFault::nonmanifold:
      break;
  }
  return LineKind::non_manifold_edge;
}

void add_faulty_edges(const NamedSurface& named, const glm::dvec3& origin_mm, std::vector<LineSet>& lines) {
  const SurfaceMesh& mesh = named.surface;
  for (const auto& [fault, h] : faulty_edges(mesh)) {
    std::vector<glm::vec3>& points = lines_of(lines, kind_of(fault), named.structure).points;
    points.push_back(in_metres(mesh.points[start(mesh, h)], origin_mm));
    points.push_back(in_metres(mesh.points[end(mesh, h)], origin_mm));
  }
}

void add_tetrahedron(const TetraMesh& mesh, const Tetrahedron& tetrahedron, const glm::dvec3& origin_mm, float shrink,
                     ModelPart& part) {
  glm::vec3 corners[4], centre(0);
  for (int i = 0; i < 4; ++i) {
    corners[i] = in_metres(mesh.points[tetrahedron[i]], origin_mm);
    centre += 0.25f * corners[i];
  }
  for (glm::vec3& corner : corners) corner = centre + shrink * (corner - centre);
  for (const auto& face : outward_face) {
    const glm::vec3 &a = corners[face[0]], &b = corners[face[1]], &c = corners[face[2]];
    const glm::vec3 across = glm::cross(b - a, c - a);
    const float size = glm::length(across);
    for (const glm::vec3& corner : {a, b, c}) {
      part.indices.push_back(static_cast<std::uint32_t>(part.positions.size()));
      part.positions.push_back(corner);
      part.normals.push_back(size > 0 ? across / size : glm::vec3(0, 0, 1));
    }
  }
}

/// By the height of its centre: every tetrahedron lies within one slab.
bool lies_between(const TetraMesh& mesh, const Tetrahedron& tetrahedron, double low, double high) {
  double sum = 0;
  for (const PointIndex point : tetrahedron) sum += mesh.points[point].z;
  return sum / 4 > low && sum / 4 < high;
}

SlabPart slab_part(const OverlaySource::Solid& solid, double low, double high, float shrink,
                   const glm::dvec3& origin_mm) {
  SlabPart part;
  part.surface.structure = part.surface.solid = solid.structure;
  for (const Tetrahedron& tetrahedron : solid.tetrahedra.tetrahedra) {
    if (!lies_between(solid.tetrahedra, tetrahedron, low, high)) continue;
    add_tetrahedron(solid.tetrahedra, tetrahedron, origin_mm, shrink, part.surface);
    ++part.tetrahedra;
  }
  return part;
}

}  // namespace

std::vector<LineSet> faulty_edges(const std::vector<NamedSurface>& surfaces, const Model& model) {
  std::vector<LineSet> lines;
  for (const NamedSurface& named : surfaces) add_faulty_edges(named, model.origin_mm, lines);
  return lines;
}

Overlay make_overlay(const OverlaySource& source, const OverlayChoice& choice, const Model& model) {
  Overlay overlay;
  if (choice.contours) add_contours(source.contours, choice.slab, model.origin_mm, overlay.lines);
  if (choice.edges) overlay.lines.insert(overlay.lines.end(), source.faulty_edges.begin(), source.faulty_edges.end());
  if (!choice.slab || *choice.slab >= source.slabs()) return overlay;
  const double low = source.contours.slices[*choice.slab].z, high = source.contours.slices[*choice.slab + 1].z;
  for (const OverlaySource::Solid& solid : source.solids) {
    SlabPart part = slab_part(solid, low, high, choice.shrink, model.origin_mm);
    if (part.tetrahedra > 0) overlay.slab.push_back(std::move(part));
  }
  return overlay;
}

}  // namespace odontoscope
