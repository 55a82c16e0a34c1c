#include "recon/mesh/interface_web.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace odontoscope {
namespace {

bool has(const Triangle& t, PointIndex v) { return t[0] == v || t[1] == v || t[2] == v; }

}  // namespace

InterfaceWeb::InterfaceWeb(std::vector<Point3> points, std::vector<InterfaceTriangle> faces)
    : points_(std::move(points)), faces_(std::move(faces)), faces_of_(points_.size()) {
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
    for (const PointIndex v : faces_[f].triangle) faces_of_[v].push_back(f);
}

InterfaceWeb::Ring InterfaceWeb::ring(PointIndex v) const {
  std::vector<PointIndex> beside;
  for (const std::uint32_t f : faces_of_[v])
    for (const PointIndex w : faces_[f].triangle)
      if (w != v) beside.push_back(w);
  std::sort(beside.begin(), beside.end());
  Ring ring;
  for (const PointIndex w : beside) {
    if (ring.empty() || ring.back().vertex != w) ring.push_back({w, 0});
    ++ring.back().triangles;
  }
  return ring;
}

InterfaceWeb::Stratum InterfaceWeb::stratum(const Ring& ring) {
  std::vector<std::uint32_t> lines;
  for (const Neighbour& n : ring)
    if (!n.on_surface()) lines.push_back(n.triangles);
  if (lines.empty()) return Stratum::surface;
  // As many triangles along the line on either side, or something else begins here.
  return lines.size() == 2 && lines[0] == lines[1] ? Stratum::line : Stratum::point;
}

std::uint32_t InterfaceWeb::triangles_between(const Ring& ring, PointIndex other) {
  const auto at =
      std::lower_bound(ring.begin(), ring.end(), other, [](const Neighbour& n, PointIndex v) { return n.vertex < v; });
  return at != ring.end() && at->vertex == other ? at->triangles : 0;
}

bool InterfaceWeb::keeps_topology(const Ring& ring_a, PointIndex b, const Ring& ring_b) const {
  const std::uint32_t between = triangles_between(ring_a, b);
  const Stratum of_a = stratum(ring_a), of_b = stratum(ring_b);
  const bool surface_edge = between == 2;
  if (surface_edge && of_a != Stratum::surface && of_b != Stratum::surface)
    return false;  // two lines would meet, or one pinch itself
  if (of_a == Stratum::point && of_b == Stratum::point) return false;
  std::uint32_t common = 0;
  for (const Neighbour& n : ring_a) {
    const std::uint32_t others = triangles_between(ring_b, n.vertex);
    if (others == 0) continue;
    ++common;
    if (!surface_edge && !n.on_surface() && others != 2) return false;  // a line of three edges
  }
  return common == between;
}

std::vector<std::uint32_t> InterfaceWeb::collapse(PointIndex a, PointIndex b, const Point3& place) {
  std::vector<std::uint32_t> vanished, kept;
  for (const std::uint32_t f : faces_of_[b]) {
    if (has(faces_[f].triangle, a)) {
      vanished.push_back(f);
      continue;
    }
    kept.push_back(f);
    std::replace(faces_[f].triangle.begin(), faces_[f].triangle.end(), b, a);
  }
  for (const std::uint32_t f : vanished) {
    for (const PointIndex v : faces_[f].triangle)
      if (v != b) std::erase(faces_of_[v], f);
    faces_[f].inner = faces_[f].outer = void_label;
  }
  std::vector<std::uint32_t> together(faces_of_[a].size() + kept.size());
  std::merge(faces_of_[a].begin(), faces_of_[a].end(), kept.begin(), kept.end(), together.begin());
  faces_of_[a] = std::move(together);
  faces_of_[b].clear();
  points_[a] = place;
  return vanished;
}

std::vector<std::uint32_t> InterfaceWeb::faces_between(PointIndex a, PointIndex b) const {
  std::vector<std::uint32_t> both;
  std::set_intersection(faces_of_[a].begin(), faces_of_[a].end(), faces_of_[b].begin(), faces_of_[b].end(),
                        std::back_inserter(both));
  return both;
}

PointIndex InterfaceWeb::split(PointIndex a, PointIndex b, const Point3& place) {
  const auto middle = static_cast<PointIndex>(points_.size());
  points_.push_back(place);
  faces_of_.emplace_back();
  for (const std::uint32_t f : faces_between(a, b)) {
    const auto made = static_cast<std::uint32_t>(faces_.size());
    InterfaceTriangle half = faces_[f];
    std::replace(half.triangle.begin(), half.triangle.end(), a, middle);
    std::replace(faces_[f].triangle.begin(), faces_[f].triangle.end(), b, middle);
    std::erase(faces_of_[b], f);
    for (const PointIndex v : half.triangle) faces_of_[v].push_back(made);
    faces_of_[middle].push_back(f);
    faces_.push_back(half);
  }
  std::sort(faces_of_[middle].begin(), faces_of_[middle].end());
  return middle;
}

void InterfaceWeb::flip(PointIndex a, PointIndex b) {
  const std::vector<std::uint32_t> pair = faces_between(a, b);
  Triangle &s = faces_[pair[0]].triangle, &t = faces_[pair[1]].triangle;
  const auto opposite = [&](const Triangle& face) {
    return *std::find_if(face.begin(), face.end(), [&](PointIndex v) { return v != a && v != b; });
  };
  const PointIndex c = opposite(s), d = opposite(t);
  std::replace(s.begin(), s.end(), b, d);
  std::replace(t.begin(), t.end(), a, c);
  const auto insert = [&](PointIndex v, std::uint32_t face) {
    faces_of_[v].insert(std::lower_bound(faces_of_[v].begin(), faces_of_[v].end(), face), face);
  };
  std::erase(faces_of_[b], pair[0]);
  std::erase(faces_of_[a], pair[1]);
  insert(d, pair[0]);
  insert(c, pair[1]);
}

}  // namespace odontoscope
