#include "recon/delaunay/conform.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "recon/core/error.h"
#include "recon/delaunay/predicates.h"
#include "recon/delaunay/refine.h"

namespace odontoscope::delaunay {
namespace {

// Regions spread over triangles from the left of each contour edge, never across one. A region takes the number that
// `region_of_contour` gives to the contour where its spreading begins.
template <class Visit>
void spread(Planar& planar, TriangleIndex seed, std::uint32_t region, Visit visit) {
  std::vector<TriangleIndex> stack{seed};
  planar.triangles[seed].region = region;
  while (!stack.empty()) {
    const TriangleIndex t = stack.back();
    stack.pop_back();
    for (int k = 0; k < 3; ++k) {
      const PlanarTriangle& triangle = planar.triangles[t];
      const SlicePoint a = triangle.v[(k + 1) % 3], b = triangle.v[(k + 2) % 3];
      if (planar.contour_edge(a, b)) {
        visit(a);
        continue;
      }
      const TriangleIndex other = triangle.nb[k];
      if (other == none) throw InternalError("a region reaches the hull without a contour");
      if (planar.triangles[other].region != none) continue;
      planar.triangles[other].region = region;
      stack.push_back(other);
    }
  }
}

Planar start_planar(Rings rings) {
  Planar planar;
  planar.next = rings.next();
  planar.previous.resize(planar.next.size());
  for (const SlicePoint p : planar.next.indices()) planar.previous[planar.next[p]] = p;
  planar.points = std::move(rings.points);
  planar.slice_point.resize(planar.points.size());
  std::iota(planar.slice_point.begin(), planar.slice_point.end(), 0u);
  planar.region_of.assign(planar.points.size(), none);
  return planar;
}

/// Sorted by `group_of`: of group g, list[first[g]] to list[first[g + 1]], ascending. What has group none is left out.
template <class I, class GroupOf>
void sort_by_group(std::size_t groups, Indices<I> all, GroupOf group_of, std::vector<std::uint32_t>& first,
                   std::vector<I>& list) {
  first.assign(groups + 1, 0);
  for (const I i : all)
    if (group_of(i) != none) ++first[group_of(i) + 1];
  for (std::size_t g = 0; g < groups; ++g) first[g + 1] += first[g];
  list.resize(first[groups]);
  std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
  for (const I i : all)
    if (group_of(i) != none) list[fill[group_of(i)]++] = i;
}

RegionLists lists_of(const Planar& planar, std::size_t regions) {
  RegionLists lists;
  sort_by_group(
      regions, planar.points.indices(), [&](SlicePoint p) { return planar.region_of[p]; }, lists.first_point,
      lists.points);
  sort_by_group(
      regions, planar.triangles.indices(), [&](TriangleIndex t) { return planar.triangles[t].region; },
      lists.first_triangle, lists.triangles);
  lists.rank.resize(planar.points.size());
  for (std::uint32_t i = 0; i < planar.insertion_order.size(); ++i) lists.rank[planar.insertion_order[i]] = i;
  return lists;
}

/// The entries of the chosen groups, ascending.
template <class I>
std::vector<I> gathered(const std::vector<std::uint32_t>& chosen, const std::vector<std::uint32_t>& first,
                        const std::vector<I>& list) {
  std::vector<I> all;
  for (const std::uint32_t g : chosen) all.insert(all.end(), list.begin() + first[g], list.begin() + first[g + 1]);
  std::sort(all.begin(), all.end());
  return all;
}

bool counter_clockwise(const Contour& contour) {
  const auto& p = contour.points;
  const auto lowest = static_cast<std::size_t>(
      std::min_element(p.begin(), p.end(), [](Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }) -
      p.begin());
  const std::size_t before = (lowest + p.size() - 1) % p.size(), after = (lowest + 1) % p.size();
  return turn(p[before], p[lowest], p[lowest], p[after]) > 0;
}

/// With the structure's contours only, and no triangulation yet.
ConformedSlice as_given(const Slice& slice, const std::string& structure) {
  ConformedSlice result;
  result.z = slice.z;
  for (std::size_t c = 0; c < slice.contours.size(); ++c)
    if (slice.contours[c].structure == structure) result.contour_number.push_back(c);
  return result;
}

Rings rings_of(const Slice& slice, const ConformedSlice& chosen) {
  Rings rings;
  for (const std::size_t c : chosen.contour_number) {
    const auto& points = slice.contours[c].points;
    rings.points.insert(rings.points.end(), points.begin(), points.end());
    rings.first_point.emplace_back(rings.points.size());
  }
  return rings;
}

struct Triangulated {
  Rings rings;
  Cdt cdt;
  std::vector<SlicePoint> order;
};

/// Finds the regions, and leaves everything in arrays.
void finish(const Slice& slice, Triangulated& made, ConformedSlice& result) {
  result.first_point = made.rings.first_point;
  if (made.rings.points.empty()) return;
  std::size_t given = 0;
  for (const std::size_t c : result.contour_number) given += slice.contours[c].points.size();
  result.steiner_points = made.rings.points.size() - given;

  Planar& planar = result.planar = start_planar(std::move(made.rings));
  planar.insertion_order = std::move(made.order);
  copy_triangles(made.cdt, planar);
  const Table<SlicePoint, TriangleIndex> left = left_triangles(planar);
  for (std::size_t c = 0; c < result.contour_number.size(); ++c) {
    if (!counter_clockwise(slice.contours[result.contour_number[c]])) continue;
    const TriangleIndex seed = left[result.first_point[c]];
    if (seed == none) throw InternalError("a contour edge is missing from the triangulation");
    const auto region = static_cast<std::uint32_t>(result.outer_contour.size());
    result.outer_contour.push_back(static_cast<std::uint32_t>(c));
    spread(planar, seed, region, [&planar, region](SlicePoint p) { planar.region_of[p] = region; });
  }
  if (std::count(planar.region_of.begin(), planar.region_of.end(), none) != 0)
    throw InternalError("a contour bounds no region");
  collect_spokes(planar);
  result.by_region = lists_of(planar, result.regions());
}

}  // namespace

void copy_triangles(const Cdt& cdt, Planar& planar) {
  std::uint32_t count = 0;
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face)
    face->info() = TriangleIndex(count++);
  planar.triangles.resize(count);
  planar.centres.resize(count);
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) {
    PlanarTriangle& triangle = planar.triangles[face->info()];
    for (int i = 0; i < 3; ++i) {
      triangle.v[i] = face->vertex(i)->info();
      const Face other = face->neighbor(i);
      triangle.nb[i] = cdt.is_infinite(other) ? TriangleIndex() : other->info();
    }
    planar.centres[face->info()] =
        circumcentre(planar.points[triangle.v[0]], planar.points[triangle.v[1]], planar.points[triangle.v[2]]);
  }
}

ConformedSlice conform(const Slice& slice, const std::string& structure, std::size_t number, const std::string& source,
                       const Progress& progress) {
  ConformedSlice result = as_given(slice, structure);
  const Rings given = rings_of(slice, result);
  Triangulated made{given, {}, {}};
  if (given.points.empty()) {
    finish(slice, made, result);
    return result;
  }
  try {
    refine(Fineness::gabriel, slice, number, source, progress, {made.rings, made.cdt, made.order});
  } catch (const InputError&) {
    made.rings = given;
    refine(Fineness::delaunay, slice, number, source, progress, {made.rings, made.cdt, made.order});
  }
  finish(slice, made, result);
  return result;
}

ConformedSlice constrained(const Slice& slice, const std::string& structure, std::size_t number,
                           const std::string& source, const Progress& progress) {
  ConformedSlice result = as_given(slice, structure);
  Triangulated made{rings_of(slice, result), {}, {}};
  refine(Fineness::constrained, slice, number, source, progress, {made.rings, made.cdt, made.order});
  finish(slice, made, result);
  result.conforming = false;
  return result;
}

Planar part_of(const ConformedSlice& slice, const std::vector<std::uint32_t>& chosen) {
  const Planar& whole = slice.planar;
  const RegionLists& lists = slice.by_region;
  const std::vector<SlicePoint> points = gathered(chosen, lists.first_point, lists.points);
  const auto number = [&points](SlicePoint p) {
    return SlicePoint(std::lower_bound(points.begin(), points.end(), p) - points.begin());
  };
  Planar part;
  for (const SlicePoint p : points) {
    part.points.push_back(whole.points[p]);
    part.slice_point.push_back(whole.slice_point[p]);
    part.region_of.push_back(whole.region_of[p]);
    part.next.push_back(number(whole.next[p]));
    part.previous.push_back(number(whole.previous[p]));
  }
  part.insertion_order = points;
  std::sort(part.insertion_order.begin(), part.insertion_order.end(),
            [&lists](SlicePoint a, SlicePoint b) { return lists.rank[a] < lists.rank[b]; });
  for (SlicePoint& p : part.insertion_order) p = number(p);

  // Every edge of the regions' triangles is constrained, so that cocircular points are cut the same way as in the
  // whole.
  Cdt cdt;
  const Table<SlicePoint, Vertex> vertices = insert_points(cdt, part.points, part.insertion_order);
  for (const TriangleIndex t : gathered(chosen, lists.first_triangle, lists.triangles)) {
    const PlanarTriangle& triangle = whole.triangles[t];
    for (int k = 0; k < 3; ++k) {
      const SlicePoint a = number(triangle.v[(k + 1) % 3]), b = number(triangle.v[(k + 2) % 3]);
      if (a < b || part.contour_edge(a, b)) cdt.insert_constraint(vertices[a], vertices[b]);
    }
  }
  copy_triangles(cdt, part);
  const Table<SlicePoint, TriangleIndex> left = left_triangles(part);
  for (const SlicePoint p : part.points.indices()) {
    if (left[p] == none) throw InternalError("a contour edge is missing from a component's triangulation");
    if (part.triangles[left[p]].region == none) spread(part, left[p], part.region_of[p], [](SlicePoint) {});
  }
  collect_spokes(part);
  return part;
}

}  // namespace odontoscope::delaunay
