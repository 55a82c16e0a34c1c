#include "recon/delaunay/conform.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "recon/core/error.h"
#include "recon/delaunay/predicates.h"
#include "recon/delaunay/refine.h"

namespace odontoscope::delaunay {
namespace {

// ---- from CGAL's structure to arrays ------------------------------------------------------------------------------

void copy_triangles(const Cdt& cdt, Planar& planar) {
  std::uint32_t count = 0;
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) face->info().value = count++;
  planar.triangles.resize(count);
  planar.centres.resize(count);
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) {
    PlanarTriangle& triangle = planar.triangles[face->info().value];
    for (int i = 0; i < 3; ++i) {
      triangle.v[i] = face->vertex(i)->info().value;
      const Face other = face->neighbor(i);
      triangle.nb[i] = cdt.is_infinite(other) ? none : other->info().value;
    }
    planar.centres[face->info().value] =
        circumcentre(planar.points[triangle.v[0]], planar.points[triangle.v[1]], planar.points[triangle.v[2]]);
  }
}

// Regions spread over triangles from the left of each contour edge, never across one. A region takes the number that
// `region_of_contour` gives to the contour where its spreading begins.
template <class Visit>
void spread(Planar& planar, std::uint32_t seed, std::uint32_t region, Visit visit) {
  std::vector<std::uint32_t> stack{seed};
  planar.triangles[seed].region = region;
  while (!stack.empty()) {
    const std::uint32_t t = stack.back();
    stack.pop_back();
    for (int k = 0; k < 3; ++k) {
      const PlanarTriangle& triangle = planar.triangles[t];
      const std::uint32_t a = triangle.v[(k + 1) % 3], b = triangle.v[(k + 2) % 3];
      if (planar.contour_edge(a, b)) {
        visit(a);
        continue;
      }
      const std::uint32_t other = triangle.nb[k];
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
  for (std::uint32_t p = 0; p < planar.next.size(); ++p) planar.previous[planar.next[p]] = p;
  planar.points = std::move(rings.points);
  planar.slice_point.resize(planar.points.size());
  std::iota(planar.slice_point.begin(), planar.slice_point.end(), 0u);
  planar.region_of.assign(planar.points.size(), none);
  return planar;
}

bool counter_clockwise(const Contour& contour) {
  const auto& p = contour.points;
  const auto lowest = static_cast<std::size_t>(
      std::min_element(p.begin(), p.end(), [](Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }) - p.begin());
  const std::size_t before = (lowest + p.size() - 1) % p.size(), after = (lowest + 1) % p.size();
  return turn(p[before], p[lowest], p[lowest], p[after]) > 0;
}

}  // namespace

ConformedSlice conform(const Slice& slice, const std::string& structure, std::size_t number, const std::string& source,
                       const Progress& progress) {
  ConformedSlice result;
  result.z = slice.z;
  Rings rings;
  for (std::size_t c = 0; c < slice.contours.size(); ++c) {
    if (slice.contours[c].structure != structure) continue;
    const auto& points = slice.contours[c].points;
    rings.points.insert(rings.points.end(), points.begin(), points.end());
    rings.first_point.push_back(static_cast<std::uint32_t>(rings.points.size()));
    result.contour_number.push_back(c);
  }
  if (rings.points.empty()) {
    result.first_point = {0};
    return result;
  }
  const std::size_t given = rings.points.size();
  Cdt cdt;
  std::vector<std::uint32_t> order;
  const Rings as_given = rings;
  try {
    refine(Fineness::gabriel, slice, number, source, progress, {rings, cdt, order});
  } catch (const InputError&) {
    rings = as_given;
    refine(Fineness::delaunay, slice, number, source, progress, {rings, cdt, order});
  }
  result.steiner_points = rings.points.size() - given;
  result.first_point = rings.first_point;

  Planar& planar = result.planar = start_planar(std::move(rings));
  planar.insertion_order = std::move(order);
  copy_triangles(cdt, planar);
  const std::vector<std::uint32_t> left = left_triangles(planar);
  for (std::size_t c = 0; c < result.contour_number.size(); ++c) {
    if (!counter_clockwise(slice.contours[result.contour_number[c]])) continue;
    const std::uint32_t seed = left[result.first_point[c]];
    if (seed == none) throw InternalError("a contour edge is missing from the triangulation");
    const auto region = static_cast<std::uint32_t>(result.outer_contour.size());
    result.outer_contour.push_back(static_cast<std::uint32_t>(c));
    spread(planar, seed, region, [&planar, region](std::uint32_t p) { planar.region_of[p] = region; });
  }
  if (std::count(planar.region_of.begin(), planar.region_of.end(), none) != 0)
    throw InternalError("a contour bounds no region");
  collect_spokes(planar);
  return result;
}

Planar part_of(const Planar& whole, const std::vector<bool>& chosen) {
  Planar part;
  std::vector<std::uint32_t> number(whole.points.size(), none);
  for (std::uint32_t p = 0; p < whole.points.size(); ++p) {
    if (!chosen[whole.region_of[p]]) continue;
    number[p] = static_cast<std::uint32_t>(part.points.size());
    part.points.push_back(whole.points[p]);
    part.slice_point.push_back(whole.slice_point[p]);
    part.region_of.push_back(whole.region_of[p]);
  }
  part.next.resize(part.points.size());
  part.previous.resize(part.points.size());
  for (std::uint32_t p = 0; p < whole.points.size(); ++p)
    if (number[p] != none) {
      part.next[number[p]] = number[whole.next[p]];
      part.previous[number[p]] = number[whole.previous[p]];
    }
  for (const std::uint32_t p : whole.insertion_order)
    if (number[p] != none) part.insertion_order.push_back(number[p]);

  // Every edge of the regions' triangles is constrained, so that cocircular points are cut the same way as in the whole.
  Cdt cdt;
  const std::vector<Vertex> vertices = insert_points(cdt, part.points, part.insertion_order);
  for (const PlanarTriangle& triangle : whole.triangles) {
    if (triangle.region == none || !chosen[triangle.region]) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = number[triangle.v[(k + 1) % 3]], b = number[triangle.v[(k + 2) % 3]];
      if (a < b || part.contour_edge(a, b)) cdt.insert_constraint(vertices[a], vertices[b]);
    }
  }
  copy_triangles(cdt, part);
  const std::vector<std::uint32_t> left = left_triangles(part);
  for (std::uint32_t p = 0; p < part.points.size(); ++p) {
    if (left[p] == none) throw InternalError("a contour edge is missing from a component's triangulation");
    if (part.triangles[left[p]].region == none) spread(part, left[p], part.region_of[p], [](std::uint32_t) {});
  }
  collect_spokes(part);
  return part;
}

}  // namespace odontoscope::delaunay
