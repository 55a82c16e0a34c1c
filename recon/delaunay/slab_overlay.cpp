#include "recon/delaunay/slab_overlay.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>

#include "recon/delaunay/predicates.h"
#include "recon/delaunay/witnesses.h"

namespace odontoscope::delaunay {
namespace {

using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const PlanarTriangle*>;

Point2 middle(const Planar& planar, const PlanarTriangle& t) {
  const Point2 a = planar.points[t.v[0]], b = planar.points[t.v[1]], c = planar.points[t.v[2]];
  return {a.x + ((b.x - a.x) + (c.x - a.x)) / 3, a.y + ((b.y - a.y) + (c.y - a.y)) / 3};
}

bool covers(const Planar& planar, const PlanarTriangle& t, Point2 p) {
  for (int i = 0; i < 3; ++i) {
    const Point2 a = planar.points[t.v[i]], b = planar.points[t.v[(i + 1) % 3]];
    if (turn(a, b, a, p) < 0) return false;
  }
  return true;
}

std::vector<Box> boxes_of(const Planar& planar) {
  std::vector<Box> boxes;
  for (const PlanarTriangle& t : planar.triangles) {
    const auto [x0, x1] = std::minmax({planar.points[t.v[0]].x, planar.points[t.v[1]].x, planar.points[t.v[2]].x});
    const auto [y0, y1] = std::minmax({planar.points[t.v[0]].y, planar.points[t.v[1]].y, planar.points[t.v[2]].y});
    boxes.emplace_back(std::array{x0, y0}.data(), std::array{x1, y1}.data(), &t);
  }
  return boxes;
}

/// For each triangle of `of` the one of `in` that its middle lies in, the first of several; none beyond the hull.
Table<TriangleIndex, TriangleIndex> located(const Planar& of, const Planar& in) {
  std::vector<Box> places, fields = boxes_of(in);
  for (const PlanarTriangle& t : of.triangles) {
    const Point2 p = middle(of, t);
    places.emplace_back(std::array{p.x, p.y}.data(), std::array{p.x, p.y}.data(), &t);
  }
  Table<TriangleIndex, TriangleIndex> found(of.triangles.size(), none);
  CGAL::box_intersection_d(places.begin(), places.end(), fields.begin(), fields.end(),
                           [&](const Box& place, const Box& field) {
                             const TriangleIndex t(place.handle() - of.triangles.data());
                             const TriangleIndex u(field.handle() - in.triangles.data());
                             if (u < found[t] && covers(in, *field.handle(), middle(of, *place.handle()))) found[t] = u;
                           });
  return found;
}

struct Labelled {
  const Planar& planar;
  const Table<TriangleIndex, std::uint32_t>& void_of_triangle;

  std::uint32_t region(TriangleIndex t) const { return t == none ? none : planar.triangles[t].region; }
  std::uint32_t hollow(TriangleIndex t) const { return t == none ? outside : void_of_triangle[t]; }
};

}  // namespace

SlabSurvey overlaid_slab(const ConformedSlice& lower, const ConformedSlice& upper, const SliceVoids& lower_voids,
                         const SliceVoids& upper_voids) {
  const PlanarVoids below = voids_in(lower.planar, lower, lower_voids),
                    above = voids_in(upper.planar, upper, upper_voids);
  const Labelled lows{lower.planar, below.of_triangle}, highs{upper.planar, above.of_triangle};
  Witnesses regions, voids;
  voids.add(outside, outside, LinkCriterion::reverse);
  const auto see = [&](TriangleIndex t, TriangleIndex u) {
    if (lows.region(t) != none && highs.region(u) != none)
      regions.add(lows.region(t), highs.region(u), LinkCriterion::medial);
    if (lows.region(t) == none && highs.region(u) == none)
      voids.add(lows.hollow(t), highs.hollow(u), LinkCriterion::medial);
  };
  const Table<TriangleIndex, TriangleIndex> up = located(lower.planar, upper.planar),
                                            down = located(upper.planar, lower.planar);
  for (const TriangleIndex t : up.indices()) see(t, up[t]);
  for (const TriangleIndex u : down.indices()) see(down[u], u);
  return {regions.links(), voids.links()};
}

}  // namespace odontoscope::delaunay
