#include "recon/partition/margin_ramp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "recon/core/union_find.h"
#include "recon/partition/limits.h"

namespace odontoscope::partition {
namespace {

using delaunay::Side;
using delaunay::SlabNumbers;
using delaunay::SlabPoint;
using delaunay::SlicePoint;
using delaunay::TriangleIndex;

using Labels = std::vector<Label>;  // ascending, each once

/// Of the faces that meet at the point, the void beyond the hull among them.
Labels labels_at(const PartitionSlice& slice, SlicePoint point) {
  Labels labels;
  const delaunay::Planar& planar = slice.planar;
  for (const delaunay::SpokeIndex s : planar.spokes_of(point)) {
    const TriangleIndex t = planar.spokes[s].triangle;
    labels.push_back(slice.label(t));
    if (t == delaunay::none) continue;
    const auto& triangle = planar.triangles[t];
    for (std::size_t k = 0; k < 3; ++k)
      if (triangle.v[k] != point && triangle.nb[k] == delaunay::none) labels.push_back(void_label);
  }
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  return labels;
}

/// Where two structures meet the void, by the labels.
using Meetings = std::map<Labels, std::vector<Point2>>;

bool is_meeting(const Labels& labels) { return labels.size() == 3 && labels.front() == void_label; }

Meetings meetings_of(const PartitionSlice& slice) {
  Meetings meetings;
  for (const SlicePoint p : slice.planar.points.indices())
    if (Labels labels = labels_at(slice, p); is_meeting(labels))
      meetings[std::move(labels)].push_back(slice.planar.points[p]);
  return meetings;
}

std::size_t count(const Meetings& meetings) {
  std::size_t sum = 0;
  for (const auto& [labels, places] : meetings) sum += places.size();
  return sum;
}

double distance(Point2 from, const std::vector<Point2>& to) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point2& p : to) least = std::min(least, (p.x - from.x) * (p.x - from.x) + (p.y - from.y) * (p.y - from.y));
  return std::sqrt(least);
}

/// Corners of the triangles, ascending, of those of one label that share corners together; by the first of them.
std::map<std::uint32_t, std::vector<SlicePoint>> corners_by_face(const PartitionSlice& slice,
                                                                 const std::vector<TriangleIndex>& triangles) {
  UnionFind faces(triangles.size());
  std::map<std::pair<SlicePoint, Label>, std::uint32_t> first;
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (const SlicePoint p : slice.planar.triangles[triangles[i]].v)
      faces.join(i, first.try_emplace({p, slice.label(triangles[i])}, i).first->second);
  std::map<std::uint32_t, std::vector<SlicePoint>> corners;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const auto& v = slice.planar.triangles[triangles[i]].v;
    auto& points = corners[faces.find(i)];
    points.insert(points.end(), v.begin(), v.end());
  }
  for (auto& [face, points] : corners) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }
  return corners;
}

/// Of those that meet there, the one that is neither the face's own nor void.
Label neighbour(const Labels& meeting, Label own) { return meeting[1] == own ? meeting[2] : meeting[1]; }

/// Adds those of one slice's points, as `number` numbers them in the slab. `beyond`: the other slice's meetings.
template <class Number>
void add_ramps(const PartitionSlice& slice, const std::vector<TriangleIndex>& triangles, const Meetings& beyond,
               const Materials& materials, Number number, std::vector<RaisedShare>& shares) {
  for (const auto& [face, points] : corners_by_face(slice, triangles)) {
    const Label own = slice.label(triangles[face]);
    Meetings here;
    for (const SlicePoint p : points) {
      const Labels labels = labels_at(slice, p);
      if (is_meeting(labels) && beyond.contains(labels) && materials.wins(neighbour(labels, own), own))
        here[labels].push_back(slice.planar.points[p]);
    }
    for (const SlicePoint p : points) {
      const Point2 at = slice.planar.points[p];
      const bool outside = labels_at(slice, p).front() == void_label;
      double nearest = std::numeric_limits<double>::infinity();
      RaisedShare one{number(p)};
      for (const auto& [labels, places] : here) {
        const double from = distance(at, places);
        if (from >= nearest) continue;
        nearest = from;
        const double way = from + distance(at, beyond.at(labels));
        one.share = outside && way > 0 ? limits::ramp_most * (from / way) : 0;
        one.beside = neighbour(labels, own);
      }
      if (one.beside != void_label) shares.push_back(one);
    }
  }
}

}  // namespace

std::vector<RaisedShare> margin_ramp(const PartitionSlice& lower, const PartitionSlice& upper,
                                     const Materials& materials, const std::vector<EndingTriangle>& ending) {
  std::vector<TriangleIndex> below, above;
  for (const EndingTriangle& one : ending)
    if ((one.slice == Side::lower ? lower : upper).label(one.triangle) != void_label)
      (one.slice == Side::lower ? below : above).push_back(one.triangle);
  if (below.empty() && above.empty()) return {};
  const Meetings lower_meetings = meetings_of(lower), upper_meetings = meetings_of(upper);
  if (ending.size() * (count(lower_meetings) + count(upper_meetings)) > limits::ramp_pairs) return {};
  std::vector<RaisedShare> shares;
  const SlabNumbers numbers(lower.planar);
  add_ramps(
      lower, below, upper_meetings, materials, [&](SlicePoint p) { return numbers.of_lower(p); }, shares);
  add_ramps(
      upper, above, lower_meetings, materials, [&](SlicePoint p) { return numbers.of_upper(p); }, shares);
  // A corner of two faces keeps the lower one.
  std::sort(shares.begin(), shares.end(), [](const RaisedShare& a, const RaisedShare& b) {
    return a.point != b.point ? a.point < b.point : a.share < b.share;
  });
  shares.erase(std::unique(shares.begin(), shares.end(),
                           [](const RaisedShare& a, const RaisedShare& b) { return a.point == b.point; }),
               shares.end());
  return shares;
}

}  // namespace odontoscope::partition
