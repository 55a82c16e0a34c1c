#include "recon/formats/join_seams.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "recon/core/union_find.h"
#include "recon/mesh/half_edges.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {
namespace {

/// A boundary edge by the places of its ends, the lesser number first.
struct SeamEdge {
  PointIndex low = 0, high = 0;
  HalfEdge edge = 0;
};

/// For each end of a boundary edge the number of its place; equal places have equal numbers.
std::vector<PointIndex> places_of(const SurfaceMesh& mesh, const std::vector<HalfEdge>& border) {
  SurfaceMesh ends;
  for (const HalfEdge h : border) {
    const auto first = static_cast<PointIndex>(ends.points.size());
    ends.points.push_back(mesh.points[start(mesh, h)]);
    ends.points.push_back(mesh.points[end(mesh, h)]);
    ends.triangles.push_back({first, first + 1, first});
  }
  std::vector<PointIndex> places;
  for (const Triangle& pair : weld(ends).triangles) places.insert(places.end(), {pair[0], pair[1]});
  return places;
}

std::vector<SeamEdge> seam_edges(const SurfaceMesh& mesh) {
  const EdgeMates mates = edge_mates(mesh);
  if (mates.boundary_edges == 0) return {};
  std::vector<HalfEdge> border;
  for (std::size_t h = 0; h < mates.mate.size(); ++h) {
    if (mates.mate[h] == EdgeMates::none) border.push_back(static_cast<HalfEdge>(h));
  }
  const std::vector<PointIndex> places = places_of(mesh, border);
  std::vector<SeamEdge> edges;
  for (std::size_t i = 0; i < border.size(); ++i) {
    const auto [low, high] = std::minmax(places[2 * i], places[2 * i + 1]);
    if (low != high) edges.push_back({low, high, border[i]});
  }
  std::sort(edges.begin(), edges.end(), [](const SeamEdge& a, const SeamEdge& b) {
    return std::tie(a.low, a.high, a.edge) < std::tie(b.low, b.high, b.edge);
  });
  return edges;
}

/// The vertices at either end become one each.
void join_ends(const SurfaceMesh& mesh, HalfEdge a, HalfEdge b, UnionFind& groups) {
  const PointIndex a_start = start(mesh, a), a_end = end(mesh, a), b_start = start(mesh, b), b_end = end(mesh, b);
  const bool opposite = mesh.points[a_start] == mesh.points[b_end];
  groups.join(a_start, opposite ? b_end : b_start);
  groups.join(a_end, opposite ? b_start : b_end);
}

/// Each group keeps its first vertex. Returns how many went.
std::size_t keep_first_of_groups(SurfaceMesh& mesh, UnionFind& groups) {
  std::vector<PointIndex> number(mesh.points.size());
  std::size_t kept = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const std::uint32_t first = groups.find(static_cast<std::uint32_t>(v));
    if (first != v) {
      number[v] = number[first];
      continue;
    }
    number[v] = static_cast<PointIndex>(kept);
    mesh.points[kept++] = mesh.points[v];
  }
  const std::size_t gone = mesh.points.size() - kept;
  mesh.points.resize(kept);
  for (Triangle& t : mesh.triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
  return gone;
}

}  // namespace

std::size_t join_seams(SurfaceMesh& mesh) {
  const std::vector<SeamEdge> edges = seam_edges(mesh);
  UnionFind groups(mesh.points.size());
  bool any = false;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t last = i;
    while (last < edges.size() && edges[last].low == edges[i].low && edges[last].high == edges[i].high) ++last;
    if (last - i == 2) {
      join_ends(mesh, edges[i].edge, edges[i + 1].edge, groups);
      any = true;
    }
    i = last;
  }
  return any ? keep_first_of_groups(mesh, groups) : 0;
}

void join_seams_told(NamedMesh& mesh) {
  const std::size_t gone = join_seams(mesh.surface);
  if (gone == 0) return;
  mesh.remarks.push_back(fmt::format("seams joined: {} with another at the same place",
                                     gone == 1 ? "1 vertex" : fmt::format("{} vertices", gone)));
}

}  // namespace odontoscope
