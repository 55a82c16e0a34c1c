#include "recon/mesh/half_edges.h"

#include <algorithm>

#include "recon/core/error.h"

namespace odontoscope {
namespace {

struct Entry {
  PointIndex high;  // the larger vertex of the edge; the smaller one is the bucket
  HalfEdge half_edge;
};

/// Half-edges in buckets by the smaller vertex of their edge; bucket v is [first[v], first[v + 1]).
struct Buckets {
  std::vector<std::uint32_t> first;
  std::vector<Entry> entries;
};

Buckets by_smaller_vertex(const SurfaceMesh& mesh) {
  Buckets buckets;
  buckets.first.assign(mesh.points.size() + 2, 0);
  for (const Triangle& t : mesh.triangles) {
    if (repeats_a_vertex(t)) continue;
    ++buckets.first[std::min(t[0], t[1]) + 2];
    ++buckets.first[std::min(t[1], t[2]) + 2];
    ++buckets.first[std::min(t[2], t[0]) + 2];
  }
  for (std::size_t v = 2; v < buckets.first.size(); ++v) buckets.first[v] += buckets.first[v - 1];
  buckets.entries.resize(buckets.first.back());
  // first[v + 1] counts up from the start of bucket v to its end, which is what it then should be.
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    if (repeats_a_vertex(corners)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const PointIndex a = corners[k], b = corners[k == 2 ? 0 : k + 1];
      buckets.entries[buckets.first[std::min(a, b) + 1]++] = {std::max(a, b), static_cast<HalfEdge>(3 * t + k)};
    }
  }
  buckets.first.pop_back();
  return buckets;
}

/// Half-edge order within a bucket is kept among equals, so that the result depends on the mesh alone.
void sort_bucket(Entry* first, Entry* last) {
  constexpr std::ptrdiff_t insertion_is_faster_below = 32;
  const auto before = [](const Entry& a, const Entry& b) {
    return a.high != b.high ? a.high < b.high : a.half_edge < b.half_edge;
  };
  if (last - first > insertion_is_faster_below) {
    std::sort(first, last, before);
    return;
  }
  for (Entry* next_one = first + (first != last); next_one < last; ++next_one) {
    const Entry moving = *next_one;
    Entry* hole = next_one;
    for (; hole > first && before(moving, hole[-1]); --hole) *hole = hole[-1];
    *hole = moving;
  }
}

void join_edge(const SurfaceMesh& mesh, const Entry* first, const Entry* last, EdgeMates& mates) {
  switch (last - first) {
    case 1:
      ++mates.boundary_edges;
      break;
    case 2: {
      const HalfEdge a = first[0].half_edge, b = first[1].half_edge;
      mates.mate[a] = b;
      mates.mate[b] = a;
      if (start(mesh, a) == start(mesh, b)) ++mates.misoriented_edges;
      break;
    }
    default:
      ++mates.nonmanifold_edges;
      for (; first != last; ++first) {
        mates.mate[first->half_edge] = EdgeMates::many;
        mates.crowded.push_back(first->half_edge);
      }
  }
}

}  // namespace

EdgeMates edge_mates(const SurfaceMesh& mesh) {
  if (mesh.triangles.size() >= EdgeMates::no_edge / 3) throw InternalError("too many triangles for 32-bit half-edges");
  EdgeMates mates;
  mates.mate.assign(3 * mesh.triangles.size(), EdgeMates::none);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!repeats_a_vertex(mesh.triangles[t])) continue;
    for (std::size_t k = 0; k < 3; ++k) mates.mate[3 * t + k] = EdgeMates::no_edge;
  }
  Buckets buckets = by_smaller_vertex(mesh);
  for (std::size_t v = 0; v + 1 < buckets.first.size(); ++v) {
    Entry* first = buckets.entries.data() + buckets.first[v];
    Entry* const last = buckets.entries.data() + buckets.first[v + 1];
    sort_bucket(first, last);
    while (first != last) {
      const Entry* edge = first;
      while (first != last && first->high == edge->high) ++first;
      join_edge(mesh, edge, first, mates);
    }
  }
  return mates;
}

}  // namespace odontoscope
