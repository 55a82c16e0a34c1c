#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "tests/support/oracle_parts.h"

namespace odontoscope::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

std::string words(const Point3& p) {
  return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z) + ")";
}

int orientation(const TetraMesh& mesh, const Tetrahedron& t) {
  std::array<Kernel::Point_3, 4> corner;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3 p = mesh.points[t[i]];
    corner[i] = Kernel::Point_3(p.x, p.y, p.z);
  }
  return int(CGAL::orientation(corner[0], corner[1], corner[2], corner[3]));
}

Triangle from_smallest(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// The triangles opposite one vertex in its tetrahedra.
using LinkComplex = std::vector<Triangle>;

/// One triangulated disc or sphere: every edge in one or two triangles, the triangles round each vertex one arc or one
/// circle, connected, Euler characteristic 1 with a boundary or 2 without.
std::string what_is_wrong(const LinkComplex& link) {
  std::map<std::array<PointIndex, 2>, std::vector<std::size_t>> at_edge;
  std::map<PointIndex, std::size_t> vertices;
  for (std::size_t t = 0; t < link.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const PointIndex a = link[t][i], b = link[t][(i + 1) % 3];
      at_edge[{std::min(a, b), std::max(a, b)}].push_back(t);
      ++vertices[a];
    }
  std::map<PointIndex, std::pair<int, int>> ends_and_edges;
  std::size_t boundary = 0;
  for (const auto& [edge, triangles] : at_edge) {
    if (triangles.size() > 2) return "an edge of the link in three triangles";
    boundary += triangles.size() == 1;
    for (PointIndex v : edge) {
      ends_and_edges[v].first += triangles.size() == 1;
      ends_and_edges[v].second += 1;
    }
  }
  // Around each vertex of the link the fans: connected components of its triangles across edges at it.
  for (const auto& [v, degree] : vertices) {
    std::map<std::size_t, std::size_t> parent;
    const auto find = [&](std::size_t t) {
      while (parent.at(t) != t) t = parent.at(t);
      return t;
    };
    for (const auto& [edge, triangles] : at_edge)
      if (edge[0] == v || edge[1] == v)
        for (std::size_t t : triangles) parent.emplace(t, t);
    std::size_t fans = parent.size();
    for (const auto& [edge, triangles] : at_edge)
      if ((edge[0] == v || edge[1] == v) && triangles.size() == 2) {
        const std::size_t a = find(triangles[0]), b = find(triangles[1]);
        if (a != b) --fans;
        parent[a] = b;
      }
    if (fans != 1) return "an edge with more than one fan of tetrahedra";
  }
  std::vector<std::size_t> parent(link.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](std::size_t t) {
    while (parent[t] != t) t = parent[t];
    return t;
  };
  std::size_t pieces = link.size();
  for (const auto& [edge, triangles] : at_edge)
    if (triangles.size() == 2) {
      const std::size_t a = find(triangles[0]), b = find(triangles[1]);
      pieces -= a != b;
      parent[a] = b;
    }
  if (pieces != 1) return "a vertex whose tetrahedra form more than one cone";
  const long euler = long(vertices.size()) - long(at_edge.size()) + long(link.size());
  if (euler != (boundary == 0 ? 2 : 1)) return "a vertex whose link is neither disc nor sphere";
  return {};
}

}  // namespace

void judge_points(const TetraMesh& mesh, const std::vector<JudgedSlice>& slices, Faults& faults) {
  std::vector<bool> used(mesh.points.size(), false);
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (PointIndex v : t) used[v] = true;
  std::map<std::array<double, 3>, std::size_t> seen;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Point3 p = mesh.points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) faults.add("a point that is not finite");
    if (!used[i]) faults.add("a point that no tetrahedron uses", words(p));
    if (!seen.insert({{p.x, p.y, p.z}, i}).second) faults.add("two points in one place", words(p));
    if (p.z < slices.front().z || p.z > slices.back().z) faults.add("a point beyond the stack", words(p));
  }
}

void judge_tetrahedra(const TetraMesh& mesh, const std::vector<JudgedSlice>& slices, Faults& faults) {
  if (mesh.tetrahedra.empty()) faults.add("no tetrahedra");
  if (mesh.labels.size() != mesh.tetrahedra.size()) faults.add("not one label for each tetrahedron");
  if (std::count(mesh.labels.begin(), mesh.labels.end(), void_label) > 0) faults.add("a tetrahedron labelled void");
  for (const Tetrahedron& t : mesh.tetrahedra) {
    const int sign = orientation(mesh, t);
    if (sign <= 0) faults.add(sign == 0 ? "a flat tetrahedron" : "an inverted tetrahedron", words(mesh.points[t[0]]));
    double low = mesh.points[t[0]].z, high = low;
    for (PointIndex v : t) {
      low = std::min(low, mesh.points[v].z);
      high = std::max(high, mesh.points[v].z);
    }
    for (const JudgedSlice& slice : slices)
      if (low < slice.z && slice.z < high) faults.add("a tetrahedron that crosses a slice", words(mesh.points[t[0]]));
  }
}

std::vector<Triangle> judge_faces(const TetraMesh& mesh, Faults& faults) {
  // Outward faces spelt out again, as the header describes them, rather than taken from its table.
  std::map<Triangle, int> count;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    const auto [a, b, c, d] = t;
    for (const Triangle& face : {Triangle{a, c, b}, Triangle{a, b, d}, Triangle{b, c, d}, Triangle{a, d, c}})
      ++count[from_smallest(face)];
  }
  std::vector<Triangle> boundary;
  for (const auto& [face, times] : count) {
    if (times > 1) faults.add("two tetrahedra on one side of a face", words(mesh.points[face[0]]));
    const auto other = count.find(from_smallest({face[0], face[2], face[1]}));
    if (other == count.end()) boundary.push_back(face);
  }
  return boundary;
}

void judge_vertex_links(const TetraMesh& mesh, Faults& faults) {
  std::vector<LinkComplex> links(mesh.points.size());
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (std::size_t i = 0; i < 4; ++i) links[t[i]].push_back({t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]});
  for (std::size_t v = 0; v < links.size(); ++v)
    if (!links[v].empty())
      if (const std::string wrong = what_is_wrong(links[v]); !wrong.empty()) faults.add(wrong, words(mesh.points[v]));
}

std::vector<std::size_t> components_of(const TetraMesh& mesh, std::size_t& count) {
  std::vector<std::size_t> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](std::size_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (std::size_t i = 1; i < 4; ++i) parent[find(t[i])] = find(t[0]);
  std::vector<std::size_t> component(mesh.points.size());
  std::map<std::size_t, std::size_t> numbers;
  for (std::size_t v = 0; v < component.size(); ++v)
    component[v] = numbers.emplace(find(v), numbers.size()).first->second;
  count = numbers.size();
  return component;
}

}  // namespace odontoscope::test
