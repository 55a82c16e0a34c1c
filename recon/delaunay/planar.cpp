#include "recon/delaunay/planar.h"

namespace odontoscope::delaunay {

std::vector<std::uint32_t> left_triangles(const Planar& planar) {
  std::vector<std::uint32_t> left(planar.points.size(), none);
  for (std::uint32_t t = 0; t < planar.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = planar.triangles[t].v[(k + 1) % 3], b = planar.triangles[t].v[(k + 2) % 3];
      if (planar.next[a] == b) left[a] = t;
    }
  return left;
}

void collect_spokes(Planar& planar) {
  const auto count = static_cast<std::uint32_t>(planar.points.size());
  std::vector<std::uint32_t> any(count, none), first(count, none);  // a triangle at v; the one after the hull's gap
  std::vector<std::uint32_t> degree(count + 1, 0);
  for (std::uint32_t t = 0; t < planar.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const PlanarTriangle& triangle = planar.triangles[t];
      const std::uint32_t v = triangle.v[k];
      any[v] = t;
      ++degree[v];
      if (triangle.nb[(k + 2) % 3] == none) {  // its edge from v to the next vertex lies on the hull
        first[v] = t;
        ++degree[v];
      }
    }
  planar.first_spoke.assign(count + 1, 0);
  for (std::uint32_t v = 0; v < count; ++v) planar.first_spoke[v + 1] = planar.first_spoke[v] + degree[v];
  planar.spokes.resize(planar.first_spoke[count]);
  const auto kind = [&planar](std::uint32_t v, std::uint32_t w, std::uint32_t beside) {
    if (planar.contour_edge(v, w)) return EdgeKind::contour;
    return planar.inside(beside) ? EdgeKind::internal : EdgeKind::external;
  };
  for (std::uint32_t v = 0; v < count; ++v) {
    std::uint32_t t = first[v] != none ? first[v] : any[v];
    for (std::uint32_t s = planar.first_spoke[v]; s < planar.first_spoke[v + 1]; ++s) {
      const PlanarTriangle& triangle = planar.triangles[t];
      const int k = triangle.v[0] == v ? 0 : triangle.v[1] == v ? 1 : 2;
      const std::uint32_t w = triangle.v[(k + 1) % 3];
      planar.spokes[s] = {w, t, kind(v, w, t)};
      if (triangle.nb[(k + 1) % 3] == none && s + 2 == planar.first_spoke[v + 1]) {  // the hull's gap follows
        const std::uint32_t last = triangle.v[(k + 2) % 3];
        planar.spokes[++s] = {last, none, kind(v, last, t)};
      } else {
        t = triangle.nb[(k + 1) % 3];
      }
    }
  }
}

}  // namespace odontoscope::delaunay
