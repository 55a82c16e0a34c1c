#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "tests/support/oracle_parts.h"
#include "tests/support/plane_check.h"

namespace odontoscope::test {
namespace {

using Exact = CGAL::Exact_rational;
using Ring = std::vector<Point2>;

Point2 flat(const Point3& p) { return {p.x, p.y}; }

std::string at_height(const JudgedSlice& slice) { return "z = " + std::to_string(slice.z); }

/// What the solid has in a slice's plane.
struct Section {
  std::set<PointIndex> points;
  std::set<std::array<PointIndex, 2>> edges;  // smaller index first
  std::set<Triangle> triangles;               // counter-clockwise from +z, smallest index first
};

Section section_of(const TetraMesh& mesh, double z) {
  Section section;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    std::vector<PointIndex> flat_part;
    for (PointIndex v : t)
      if (mesh.points[v].z == z) flat_part.push_back(v);
    section.points.insert(flat_part.begin(), flat_part.end());
    for (PointIndex a : flat_part)
      for (PointIndex b : flat_part)
        if (a < b) section.edges.insert({a, b});
    if (flat_part.size() < 3) continue;
    Triangle face{flat_part[0], flat_part[1], flat_part[2]};
    if (turn(flat(mesh.points[face[0]]), flat(mesh.points[face[1]]), flat(mesh.points[face[2]])) < 0)
      std::swap(face[1], face[2]);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    section.triangles.insert(face);
  }
  return section;
}

/// The outline of the section's triangles: each directed edge that has a triangle on its left only.
std::map<PointIndex, PointIndex> outline_of(const Section& section, const JudgedSlice& slice, Faults& faults) {
  std::set<std::array<PointIndex, 2>> directed;
  for (const Triangle& t : section.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (!directed.insert({t[i], t[(i + 1) % 3]}).second)
        faults.add("triangles that overlap in a slice's plane", at_height(slice));
  std::map<PointIndex, PointIndex> next;
  for (const auto& [a, b] : directed)
    if (!directed.contains({b, a}) && !next.emplace(a, b).second)
      faults.add("an outline that meets itself in a slice's plane", at_height(slice));
  return next;
}

void judge_nothing_loose(const Section& section, const JudgedSlice& slice, Faults& faults) {
  std::set<PointIndex> corners;
  std::set<std::array<PointIndex, 2>> sides;
  for (const Triangle& t : section.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      corners.insert(t[i]);
      sides.insert({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
    }
  if (corners != section.points) faults.add("a point in a slice's plane outside its regions", at_height(slice));
  if (sides != section.edges) faults.add("an edge in a slice's plane that is in no triangle there", at_height(slice));
}

/// Is `p` between a and b, and off their line by no more than `tolerance`? Exact.
bool along(Point2 a, Point2 b, Point2 p, double tolerance) {
  const Exact dx = Exact(b.x) - a.x, dy = Exact(b.y) - a.y, px = Exact(p.x) - a.x, py = Exact(p.y) - a.y;
  const Exact length2 = dx * dx + dy * dy, forward = dx * px + dy * py, off = dx * py - dy * px;
  return forward > 0 && forward < length2 && off * off <= Exact(tolerance) * Exact(tolerance) * length2;
}

/// Strictly further along a to b than q.
bool further(Point2 a, Point2 b, Point2 q, Point2 p) {
  return (Exact(b.x) - a.x) * (Exact(p.x) - q.x) + (Exact(b.y) - a.y) * (Exact(p.y) - q.y) > 0;
}

/// Follows the outline from the ring's first point right round and takes it out of `next`. Empty if it strays from the
/// ring.
Ring follow(const Ring& ring, const TetraMesh& mesh, const std::map<std::pair<double, double>, PointIndex>& point_at,
            std::map<PointIndex, PointIndex>& next) {
  double largest = 0;
  for (Point2 p : ring) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  const double ulp = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
  const auto first = point_at.find({ring[0].x, ring[0].y});
  if (first == point_at.end()) return {};
  Ring outline;
  PointIndex at = first->second;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 from = ring[i], to = ring[(i + 1) % ring.size()];
    Point2 here = from;
    do {
      const auto step = next.find(at);
      if (step == next.end()) return {};
      outline.push_back(here);
      at = step->second;
      next.erase(step);
      const Point2 p = flat(mesh.points[at]);
      if (!(p == to) && (!along(from, to, p, steiner_ulps * ulp) || !further(from, to, here, p))) return {};
      here = p;
    } while (!(here == to));
  }
  return outline;
}

Exact twice_area(const Ring& ring) {
  Exact twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
    twice += Exact(a.x) * b.y - Exact(b.x) * a.y;
  }
  return twice;
}

}  // namespace

void judge_section(const TetraMesh& mesh, const JudgedSlice& slice, Faults& faults) {
  const Section section = section_of(mesh, slice.z);
  judge_nothing_loose(section, slice, faults);
  std::map<PointIndex, PointIndex> next = outline_of(section, slice, faults);
  std::map<std::pair<double, double>, PointIndex> point_at;
  for (PointIndex v : section.points) point_at[{mesh.points[v].x, mesh.points[v].y}] = v;
  std::vector<Ring> outlines;
  Exact wanted = 0, found = 0;
  for (const Ring& ring : slice.rings) {
    const Ring outline = follow(ring, mesh, point_at, next);
    if (outline.empty()) {
      faults.add("a contour that is not an outline of the solid in its plane", at_height(slice));
      continue;
    }
    outlines.push_back(outline);
    wanted += twice_area(outline);
  }
  if (!next.empty()) faults.add("an outline in a slice's plane that is no contour", at_height(slice));
  for (const auto& [a, b, c] : section.triangles)
    found += twice_area({flat(mesh.points[a]), flat(mesh.points[b]), flat(mesh.points[c])});
  if (wanted != found) faults.add("the area in a slice's plane is not that of its regions", at_height(slice));
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (!is_simple(outlines[i])) faults.add("an outline that crosses itself", at_height(slice));
    for (std::size_t j = 0; j < i; ++j)
      if (!are_disjoint(outlines[i], outlines[j])) faults.add("two outlines that meet", at_height(slice));
  }
}

}  // namespace odontoscope::test
