#include "recon/delaunay/planar.h"

namespace odontoscope::delaunay {

Table<SlicePoint, TriangleIndex> left_triangles(const Planar& planar) {
  Table<SlicePoint, TriangleIndex> left(planar.points.size(), none);
  for (const TriangleIndex t : planar.triangles.indices())
    for (int k = 0; k < 3; ++k) {
      const SlicePoint a = planar.triangles[t].v[(k + 1) % 3], b = planar.triangles[t].v[(k + 2) % 3];
      if (planar.next[a] == b) left[a] = t;
    }
  return left;
}

void collect_spokes(Planar& planar) {
  const std::size_t count = planar.points.size();
  Table<SlicePoint, TriangleIndex> any(count, none),
      first(count, none);  // a triangle at v; the one after the hull's gap
  Table<SlicePoint, std::uint32_t> degree(count, 0);
  for (const TriangleIndex t : planar.triangles.indices())
    for (int k = 0; k < 3; ++k) {
      const PlanarTriangle& triangle = planar.triangles[t];
      const SlicePoint v = triangle.v[k];
      any[v] = t;
      ++degree[v];
      if (triangle.nb[(k + 2) % 3] == none) {  // its edge from v to the next vertex lies on the hull
        first[v] = t;
        ++degree[v];
      }
    }
  planar.first_spoke.assign(count + 1, SpokeIndex(0));
  for (const SlicePoint v : planar.points.indices())
    planar.first_spoke[SlicePoint(v + 1)] = SpokeIndex(planar.first_spoke[v] + degree[v]);
  planar.spokes.resize(planar.first_spoke.back());
  const auto kind = [&planar](SlicePoint v, SlicePoint w, TriangleIndex beside) {
    if (planar.contour_edge(v, w)) return EdgeKind::contour;
    return planar.inside(beside) ? EdgeKind::internal : EdgeKind::external;
  };
  for (const SlicePoint v : planar.points.indices()) {
    TriangleIndex t = first[v] != none ? first[v] : any[v];
    const Indices<SpokeIndex> spokes = planar.spokes_of(v);
    for (SpokeIndex s = *spokes.begin(); s != *spokes.end(); ++s) {
      const PlanarTriangle& triangle = planar.triangles[t];
      const int k = triangle.v[0] == v ? 0 : triangle.v[1] == v ? 1 : 2;
      const SlicePoint w = triangle.v[(k + 1) % 3];
      planar.spokes[s] = {w, t, kind(v, w, t)};
      if (triangle.nb[(k + 1) % 3] == none && s + 1 == spokes.back()) {  // the hull's gap follows
        const SlicePoint last = triangle.v[(k + 2) % 3];
        planar.spokes[++s] = {last, none, kind(v, last, t)};
      } else {
        t = triangle.nb[(k + 1) % 3];
      }
    }
  }
}

}  // namespace odontoscope::delaunay
