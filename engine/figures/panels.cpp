#include "engine/figures/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <set>
#include <utility>

#include "assets/theme.h"
#include "engine/figures/papers_way.h"
#include "engine/scene/shells.h"
#include "recon/core/grouped.h"
#include "recon/delaunay/reconstruct.h"

namespace odontoscope::figures {
namespace {

constexpr Colour page_colour = colour_of(assets::theme::report::paper);

Panel fitted(std::string caption, Subject subject, double shape, const auto& camera_for) {
  Panel made{std::move(caption), std::move(subject.surfaces), std::move(subject.strokes), subject.crease_deg, {}};
  const Model model = make_model(made.surfaces, made.crease_deg);
  made.scene = usual_scene(model, shape);
  made.scene.camera = camera_for(model);
  made.scene.background = {Background::Kind::plain, page_colour, page_colour};
  set_opacity(made, 1);
  return made;
}

}  // namespace

Panel panel(std::string caption, Subject subject, double aspect, NamedView view) {
  return fitted(std::move(caption), std::move(subject), aspect,
                [&](const Model& model) { return fit(view, model, aspect); });
}

Panel panel(std::string caption, Subject subject, double aspect, const glm::dvec3& towards_eye, const glm::dvec3& up) {
  return fitted(std::move(caption), std::move(subject), aspect, [&](const Model& model) {
    Camera camera;
    camera.position = glm::normalize(towards_eye);
    camera.target = glm::dvec3(0);
    camera.up = up;
    return fit(camera, model, aspect);
  });
}

void paint(Panel& panel, const Colour& colour) {
  for (Look& look : panel.scene.looks) look.colour = colour;
}

void set_opacity(Panel& panel, float opacity) {
  for (Look& look : panel.scene.looks) look.opacity = opacity;
}

Panel with_mesh(std::string caption, Panel panel) {
  panel.caption = std::move(caption);
  panel.scene.wire = true;
  return panel;
}

void look_closer(Panel& panel, const glm::dvec3& at, double radius_mm) {
  Camera& camera = panel.scene.camera;
  const glm::dvec3 towards_eye = glm::normalize(camera.position - camera.target);
  camera.target = at;
  camera.position = at + radius_mm / std::sin(glm::radians(camera.field_of_view_deg) / 2) * towards_eye;
}

Strokes contour_strokes(const ContourStack& stack) {
  Strokes lines;
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours)
      for (std::size_t i = 0; i < contour.points.size(); ++i) {
        const Point2 &from = contour.points[i], &to = contour.points[(i + 1) % contour.points.size()];
        lines.ends.push_back({from.x, from.y, slice.z});
        lines.ends.push_back({to.x, to.y, slice.z});
      }
  return lines;
}

Strokes edge_strokes(const TetraMesh& mesh) {
  std::set<std::pair<PointIndex, PointIndex>> edges;
  for (const Tetrahedron& tetrahedron : mesh.tetrahedra)
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) edges.insert(std::minmax(tetrahedron[i], tetrahedron[j]));
  Strokes lines;
  for (const auto& [from, to] : edges) {
    lines.ends.push_back(mesh.points[from]);
    lines.ends.push_back(mesh.points[to]);
  }
  return lines;
}

Strokes strokes(LineKind kind, const std::vector<Point3>& ends) { return {kind, ends}; }

SurfaceMesh shrunk(const std::vector<Point3>& points, const std::vector<Tetrahedron>& tetrahedra, double shrink) {
  SurfaceMesh mesh;
  for (const Tetrahedron& tetrahedron : tetrahedra) {
    const auto first = static_cast<PointIndex>(mesh.points.size());
    Point3 centre{0, 0, 0};
    for (const PointIndex p : tetrahedron)
      centre = {centre.x + points[p].x / 4, centre.y + points[p].y / 4, centre.z + points[p].z / 4};
    const auto towards = [&](double c, double p) { return c + shrink * (p - c); };
    for (const PointIndex p : tetrahedron)
      mesh.points.push_back(
          {towards(centre.x, points[p].x), towards(centre.y, points[p].y), towards(centre.z, points[p].z)});
    for (const auto& face : outward_face)
      mesh.triangles.push_back({first + static_cast<PointIndex>(face[0]), first + static_cast<PointIndex>(face[1]),
                                first + static_cast<PointIndex>(face[2])});
  }
  return mesh;
}

std::vector<NamedSurface> dt_surfaces(const ContourStack& stack, const std::vector<Link>& links) {
  ReconstructOptions options = papers_way();
  options.links = links;
  std::vector<NamedSurface> surfaces;
  for (Solid& solid : reconstruct(stack, options).solids)
    surfaces.push_back({solid.structure, std::move(solid.surface), solid.structure});
  return surfaces;
}

std::vector<NamedSurface> db_surfaces(const ContourStack& stack, std::size_t grid, const std::vector<double>& splits) {
  DbOptions options;
  options.grid = {grid, grid, splits};
  options.cases = CaseTable::consistent;
  std::vector<NamedSurface> surfaces;
  for (DbSurface& one : reconstruct_by_distance(stack, options).surfaces)
    surfaces.push_back({one.structure, std::move(one.surface), one.structure});
  return surfaces;
}

std::size_t triangles_of(const std::vector<NamedSurface>& surfaces) {
  std::size_t count = 0;
  for (const NamedSurface& named : surfaces) count += named.surface.triangles.size();
  return count;
}

}  // namespace odontoscope::figures
