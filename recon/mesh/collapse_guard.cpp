#include "recon/mesh/collapse_guard.h"

#include <CGAL/intersections.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>

namespace odontoscope {
namespace {

using Point = CollapseGuard::Point;
using Triangle3 = ExactKernel::Triangle_3;
using Segment3 = ExactKernel::Segment_3;

Point3 plain(const Point& p) { return {p.x(), p.y(), p.z()}; }

std::vector<MovingBox> boxes_of(const HalfEdgeMesh& mesh) {
  std::vector<MovingBox> boxes(mesh.num_faces());
  for (const auto face : mesh.faces()) {
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(face))) boxes[face.idx()].add(plain(mesh.point(v)));
  }
  return boxes;
}

/// Two triangles on one edge ab, with c and d opposite: do they lie upon each other?
bool folded(const Point& a, const Point& b, const Point& c, const Point& d) {
  return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
}

/// Two triangles with only the vertex `shared` in common: do they meet elsewhere?
bool meet_beside(const Point& shared, const Point& a, const Point& b, const Point& c, const Point& d) {
  return CGAL::do_intersect(Triangle3(shared, a, b), Segment3(c, d)) ||
         CGAL::do_intersect(Triangle3(shared, c, d), Segment3(a, b));
}

}  // namespace

CollapseGuard::CollapseGuard(const HalfEdgeMesh& mesh, const std::vector<std::uint32_t>& surface_of)
    : mesh_(mesh), surface_of_(surface_of), tree_(boxes_of(mesh)) {}

MovingBox CollapseGuard::box_of(Face face) const {
  MovingBox box;
  for (const Vertex v : mesh_.vertices_around_face(mesh_.halfedge(face))) box.add(plain(mesh_.point(v)));
  return box;
}

void CollapseGuard::moved(Vertex vertex) {
  for (const Face face : mesh_.faces_around_target(mesh_.halfedge(vertex))) {
    if (face != HalfEdgeMesh::null_face()) tree_.move(face.idx(), box_of(face));
  }
}

std::optional<CollapseGuard::Refusal> CollapseGuard::refusal(const Star& star, const Point& placed,
                                                             bool may_turn) const {
  if (strays(star, placed)) return Refusal::far;
  if (!may_turn && turns(star, placed)) return Refusal::turned;
  if (flattens(star, placed)) return Refusal::flat;
  if (cuts_itself(star, placed) || cuts_others(star, placed)) return Refusal::cuts;
  return std::nullopt;
}

/// Measured in doubles: nothing but quality hangs on it.
bool CollapseGuard::strays(const Star& star, const Point& placed) const {
  const Point &one = mesh_.point(star.one), &other = mesh_.point(star.other);
  const double allowed = CGAL::squared_distance(one, other);
  double placed_off = CGAL::squared_distance(placed, Segment3(one, other)), one_off = MovingBox::far, other_off = MovingBox::far;
  for (const Star::Triangle& t : star.triangles) {
    const Point &before = mesh_.point(t.before), &moved = mesh_.point(t.moved), &after = mesh_.point(t.after);
    if (placed_off > allowed) {
      placed_off = std::min(placed_off, CGAL::squared_distance(placed, Triangle3(before, moved, after)));
    }
    const Triangle3 made(before, placed, after);
    if (made.is_degenerate()) continue;
    if (one_off > allowed) one_off = std::min(one_off, CGAL::squared_distance(one, made));
    if (other_off > allowed) other_off = std::min(other_off, CGAL::squared_distance(other, made));
  }
  return !(std::max({placed_off, one_off, other_off}) <= allowed);
}

bool CollapseGuard::turns(const Star& star, const Point& placed) const {
  return std::any_of(star.triangles.begin(), star.triangles.end(), [&](const Star::Triangle& t) {
    const Point &before = mesh_.point(t.before), &moved = mesh_.point(t.moved), &after = mesh_.point(t.after);
    const auto was = CGAL::cross_product(before - moved, after - moved);
    const auto is = CGAL::cross_product(before - placed, after - placed);
    return !(was * is > 0);
  });
}

bool CollapseGuard::flattens(const Star& star, const Point& placed) const {
  return std::any_of(star.triangles.begin(), star.triangles.end(), [&](const Star::Triangle& t) {
    return CGAL::collinear(mesh_.point(t.before), placed, mesh_.point(t.after));
  });
}

bool CollapseGuard::cuts_itself(const Star& star, const Point& placed) const {
  for (std::size_t m = 0; m < star.triangles.size(); ++m) {
    const Star::Triangle& s = star.triangles[m];
    const Point &a = mesh_.point(s.before), &b = mesh_.point(s.after);
    for (std::size_t n = m + 1; n < star.triangles.size(); ++n) {
      const Star::Triangle& t = star.triangles[n];
      const Point &c = mesh_.point(t.before), &d = mesh_.point(t.after);
      const bool at_before = s.before == t.before || s.before == t.after;
      const bool at_after = s.after == t.before || s.after == t.after;
      if (at_before && at_after) return true;  // twice the same triangle
      if (at_before ? folded(a, placed, b, s.before == t.before ? d : c)
          : at_after ? folded(b, placed, a, s.after == t.before ? d : c)
                     : meet_beside(placed, a, b, c, d)) {
        return true;
      }
    }
  }
  return false;
}

bool CollapseGuard::cuts_others(const Star& star, const Point& placed) const {
  return std::any_of(star.triangles.begin(), star.triangles.end(), [&](const Star::Triangle& made) {
    MovingBox box;
    box.add(plain(placed));
    box.add(plain(mesh_.point(made.before)));
    box.add(plain(mesh_.point(made.after)));
    return tree_.any(box, [&](std::uint32_t number) {
      const Face face(number);
      const Vertex corner = mesh_.target(mesh_.halfedge(face));
      if (surface_of_[corner.idx()] != surface_of_[star.one.idx()]) return false;
      for (const Vertex v : mesh_.vertices_around_face(mesh_.halfedge(face))) {
        if (v == star.one || v == star.other) return false;  // of the star itself
      }
      return cuts(made, placed, face);
    });
  });
}

bool CollapseGuard::cuts(const Star::Triangle& made, const Point& placed, Face other) const {
  std::array<Vertex, 3> corners;
  std::size_t count = 0;
  for (const Vertex v : mesh_.vertices_around_face(mesh_.halfedge(other))) corners[count++] = v;
  const auto shared = [&](Vertex v) { return v == made.before || v == made.after; };
  const Point &before = mesh_.point(made.before), &after = mesh_.point(made.after);
  const auto shares = std::count_if(corners.begin(), corners.end(), shared);
  // Rotated so that what is shared comes first, or what is not comes last.
  if (shares == 1) std::rotate(corners.begin(), std::find_if(corners.begin(), corners.end(), shared), corners.end());
  if (shares == 2) {
    std::rotate(corners.begin(), std::find_if_not(corners.begin(), corners.end(), shared) + 1, corners.end());
    return folded(before, after, placed, mesh_.point(corners[2]));
  }
  const Point &a = mesh_.point(corners[0]), &b = mesh_.point(corners[1]), &c = mesh_.point(corners[2]);
  if (shares == 1) {
    return corners[0] == made.before ? meet_beside(before, after, placed, b, c)
                                     : meet_beside(after, before, placed, b, c);
  }
  return CGAL::do_intersect(Triangle3(before, after, placed), Triangle3(a, b, c));
}

}  // namespace odontoscope
