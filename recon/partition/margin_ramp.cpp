#include "recon/partition/margin_ramp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "recon/partition/limits.h"

namespace odontoscope::partition {
namespace {

using Labels = std::vector<Label>;  // ascending, each once

/// Of the faces that meet at the point, the void beyond the hull among them.
Labels labels_at(const PartitionSlice& slice, std::uint32_t point) {
  Labels labels;
  const delaunay::Planar& planar = slice.planar;
  for (std::uint32_t s = planar.first_spoke[point]; s < planar.first_spoke[point + 1]; ++s) {
    const std::uint32_t t = planar.spokes[s].triangle;
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
  for (std::uint32_t p = 0; p < slice.planar.points.size(); ++p)
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

/// Triangles of one slice that end, those of one label that share corners together.
class EndingFaces {
 public:
  EndingFaces(const PartitionSlice& slice, const std::vector<std::uint32_t>& triangles) : slice_(slice) {
    std::map<std::pair<std::uint32_t, Label>, std::size_t> first;
    of_.resize(triangles.size());
    std::iota(of_.begin(), of_.end(), std::size_t{0});
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (const std::uint32_t p : slice.planar.triangles[triangles[i]].v) {
        const auto [at, fresh] = first.try_emplace({p, slice.label(triangles[i])}, i);
        if (!fresh) of_[root(i)] = root(at->second);
      }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& corners = slice.planar.triangles[triangles[i]].v;
      auto& points = points_[root(i)];
      points.insert(points.end(), corners.begin(), corners.end());
    }
    for (auto& [face, points] : points_) {
      std::sort(points.begin(), points.end());
      points.erase(std::unique(points.begin(), points.end()), points.end());
    }
  }

  /// Their corners, ascending, by face.
  const std::map<std::size_t, std::vector<std::uint32_t>>& points() const { return points_; }

 private:
  std::size_t root(std::size_t i) {
    while (of_[i] != i) i = of_[i] = of_[of_[i]];
    return i;
  }

  const PartitionSlice& slice_;
  std::vector<std::size_t> of_;
  std::map<std::size_t, std::vector<std::uint32_t>> points_;
};

/// Adds those of one slice's points. `beyond`: the other slice's meetings.
void add_ramps(const PartitionSlice& slice, const std::vector<std::uint32_t>& triangles, const Meetings& beyond,
               const Materials& materials, std::uint32_t offset, std::vector<RaisedShare>& shares) {
  const EndingFaces faces(slice, triangles);
  for (const auto& [face, points] : faces.points()) {
    const Label own = slice.label(triangles[face]);
    Meetings here;
    for (const std::uint32_t p : points) {
      const Labels labels = labels_at(slice, p);
      if (is_meeting(labels) && beyond.contains(labels) &&
          materials.wins(labels[1] == own ? labels[2] : labels[1], own))
        here[labels].push_back(slice.planar.points[p]);
    }
    for (const std::uint32_t p : points) {
      const Point2 at = slice.planar.points[p];
      double nearest = std::numeric_limits<double>::infinity();
      RaisedShare one{p + offset};
      for (const auto& [labels, places] : here) {
        const double from = distance(at, places);
        if (from >= nearest) continue;
        nearest = from;
        const double way = from + distance(at, beyond.at(labels));
        const bool outside = labels_at(slice, p).front() == void_label;
        one.share = outside && way > 0 ? limits::ramp_most * (from / way) : 0;
        one.beside = labels[1] == own ? labels[2] : labels[1];
      }
      if (one.beside != void_label) shares.push_back(one);
    }
  }
}

}  // namespace

std::vector<RaisedShare> margin_ramp(const PartitionSlice& lower, const PartitionSlice& upper,
                                     const Materials& materials, const std::vector<EndingTriangle>& ending) {
  std::vector<std::uint32_t> below, above;
  for (const EndingTriangle& one : ending)
    if ((one.lower ? lower : upper).label(one.triangle) != void_label)
      (one.lower ? below : above).push_back(one.triangle);
  if (below.empty() && above.empty()) return {};
  const Meetings lower_meetings = meetings_of(lower), upper_meetings = meetings_of(upper);
  if (ending.size() * (count(lower_meetings) + count(upper_meetings)) > limits::ramp_pairs) return {};
  std::vector<RaisedShare> shares;
  add_ramps(lower, below, upper_meetings, materials, 0, shares);
  add_ramps(upper, above, lower_meetings, materials, static_cast<std::uint32_t>(lower.planar.points.size()), shares);
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
