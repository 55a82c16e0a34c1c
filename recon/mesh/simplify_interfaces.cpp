#include "recon/mesh/simplify_interfaces.h"

#include <algorithm>
#include <limits>

#include "recon/core/error.h"
#include "recon/mesh/collapse_interfaces.h"
#include "recon/mesh/collapse_star.h"
#include "recon/mesh/complex_parts.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {
namespace {

/// The surface of one material, or of the void, its shells, and which one each point of the complex belongs to.
struct MaterialShells {
  MaterialShells(const std::vector<Point3>& points, const std::vector<InterfaceTriangle>& faces, Label label)
      : of_point(points.size(), none) {
    SurfaceMesh surface{points, {}};
    for (const InterfaceTriangle& face : faces) {
      if (face.inner == void_label) continue;  // vanished
      const auto& [a, b, c] = face.triangle;
      if (face.inner == label) surface.triangles.push_back({a, b, c});
      if (face.outer == label) surface.triangles.push_back({a, c, b});
    }
    report = inspect(surface);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      for (const PointIndex v : surface.triangles[t]) of_point[v] = report.shell_of[t];
    first_point.resize(report.shells.size());
    for (std::size_t t = surface.triangles.size(); t-- > 0;) first_point[report.shell_of[t]] = surface.triangles[t][0];
  }
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  SurfaceReport report;
  std::vector<std::uint32_t> of_point;  // none: not on this surface
  std::vector<PointIndex> first_point;  // of each shell
};

/// Marks the points of all shells that have become another kind or genus: specks and thin plates that were turned
/// inside out, which no local test sees. Returns whether there are any.
bool keep_changed(const std::vector<MaterialShells>& full, const InterfaceWeb& web, std::vector<char>& keep) {
  bool changed = false;
  const auto end = static_cast<Label>(full.size());
  for (Label l = 0; l < end; ++l) {
    const MaterialShells now(web.points(), web.faces(), l);
    if (now.report.shells.size() != full[l].report.shells.size())
      throw InternalError("simplifying lost a piece of a material");
    for (std::size_t s = 0; s < now.first_point.size(); ++s) {
      const std::uint32_t before = full[l].of_point[now.first_point[s]];
      if (before == MaterialShells::none) throw InternalError("simplifying gave a point to another material");
      const Shell &is = now.report.shells[s], &was = full[l].report.shells[before];
      if (is.kind == was.kind && is.genus == was.genus) continue;
      changed = true;
      for (std::size_t v = 0; v < keep.size(); ++v) keep[v] = keep[v] || full[l].of_point[v] == before;
    }
  }
  return changed;
}

LabelledComplex what_is_left(const InterfaceWeb& web, const std::vector<std::string>& structures) {
  LabelledComplex left{structures, {web.points(), {}, {}}, {}};
  for (std::uint32_t f = 0; f < web.faces().size(); ++f)
    if (web.alive(f)) left.interfaces.push_back(web.faces()[f]);
  drop_unused(left);
  return left;
}

/// Held against each other once more, all of them, by a tree of their own.
void certify_embedded(const LabelledComplex& simple, const Progress& progress) {
  std::vector<NumberedTriangle> triangles;
  std::vector<MovingBox> boxes;
  for (const InterfaceTriangle& face : simple.interfaces) {
    NumberedTriangle one{face.triangle, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3& p = simple.mesh.points[face.triangle[i]];
      one.corner[i] = {p.x, p.y, p.z};
    }
    triangles.push_back(one);
    boxes.push_back(box_of(one));
  }
  const MovingBoxTree tree(boxes);
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    progress.check();
    if (tree.any(boxes[f],
                 [&](std::uint32_t other) { return other > f && meet_elsewhere(triangles[f], triangles[other]); }))
      throw InternalError("simplified interfaces cut through each other");
  }
}

}  // namespace

SimplifiedInterfaces simplify_interfaces(const LabelledComplex& complex, std::size_t triangles,
                                         const Progress& progress) {
  progress.tell("simplify", 0);
  std::vector<MaterialShells> full;
  const auto last = static_cast<Label>(complex.structures.size());
  for (Label l = 0; l <= last; ++l) full.emplace_back(complex.mesh.points, complex.interfaces, l);
  std::vector<char> keep(complex.mesh.points.size(), 0);
  SimplifiedInterfaces simple;
  for (;;) {
    InterfaceWeb web(complex.mesh.points, complex.interfaces);
    const SimplifiedSurfaces::Obstacles obstacles = collapse_interfaces(web, keep, triangles, progress);
    if (keep_changed(full, web, keep)) {
      ++simple.restarts;
      continue;
    }
    simple.complex = what_is_left(web, complex.structures);
    simple.obstacles = obstacles;
    break;
  }
  certify_embedded(simple.complex, progress);
  simple.triangles = triangles_of_surfaces(simple.complex.interfaces);
  simple.reached = simple.triangles <= triangles;
  if (simple.reached) simple.obstacles = {};
  simple.kept_vertices = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 1));
  return simple;
}

}  // namespace odontoscope
