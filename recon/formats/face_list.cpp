#include "recon/formats/face_list.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/core/limits.h"
#include "recon/formats/cut_polygon.h"
#include "recon/mesh/half_edges.h"

namespace odontoscope {
namespace {

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

void FaceList::add(const std::vector<PointIndex>& corners) {
  for (const PointIndex corner : corners) largest_corner_ = std::max(largest_corner_, corner);
  if (corners.size() == 3) {
    triangles_.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  const std::size_t first = corners_.size();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] != corners[(i + 1) % corners.size()]) corners_.push_back(corners[i]);
  }
  const std::size_t left = corners_.size() - first;
  if (left > 3) {
    polygons_.push_back({triangles_.size(), first, static_cast<std::uint32_t>(left)});
    triangles_.resize(triangles_.size() + left - 2);
    return;
  }
  if (left == 3)
    triangles_.push_back({corners_[first], corners_[first + 1], corners_[first + 2]});
  else
    ++without_area_;
  corners_.resize(first);
}

void FaceList::add_strip(const std::vector<PointIndex>& corners) {
  for (const PointIndex corner : corners) largest_corner_ = std::max(largest_corner_, corner);
  for (std::size_t i = 2; i < corners.size(); ++i) {
    Triangle t{corners[i - 2], corners[i - 1], corners[i]};
    if (i % 2 != 0) std::swap(t[0], t[1]);
    if (!repeats_a_vertex(t)) triangles_.push_back(t);
  }
}

void FaceList::cut_into(SurfaceMesh& mesh) {
  mesh.triangles = std::move(triangles_);
  for (const Polygon& polygon : polygons_) {
    const CutPolygon cut = cut_polygon(places_of(polygon, mesh));
    fill(polygon, cut.triangles, mesh);
    fans_ += cut.fan;
    if (cut.off_plane <= limits::flat_polygon * cut.size) continue;
    ++bent_;
    farthest_off_ = std::max(farthest_off_, cut.off_plane);
  }
  if (!polygons_.empty()) turn_crowded_diagonals(mesh);
}

std::vector<Point3> FaceList::places_of(const Polygon& polygon, const SurfaceMesh& mesh) const {
  std::vector<Point3> places;
  for (std::size_t i = 0; i < polygon.corners; ++i) places.push_back(mesh.points[corners_[polygon.first_corner + i]]);
  return places;
}

void FaceList::fill(const Polygon& polygon, const std::vector<std::array<std::uint32_t, 3>>& triangles,
                    SurfaceMesh& mesh) const {
  const PointIndex* corners = corners_.data() + polygon.first_corner;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    mesh.triangles[polygon.first_triangle + t] = {corners[a], corners[b], corners[c]};
  }
}

/// The polygon of four corners whose diagonal the half-edge is.
const FaceList::Polygon* FaceList::parted_by(HalfEdge h, const SurfaceMesh& mesh) const {
  const std::size_t triangle = h / 3;
  auto after = std::upper_bound(polygons_.begin(), polygons_.end(), triangle,
                                [](std::size_t t, const Polygon& polygon) { return t < polygon.first_triangle; });
  if (after == polygons_.begin()) return nullptr;
  const Polygon& polygon = *--after;
  if (polygon.corners != 4 || triangle >= polygon.first_triangle + 2) return nullptr;
  const PointIndex* corners = corners_.data() + polygon.first_corner;
  const PointIndex from = start(mesh, h), to = end(mesh, h);
  for (std::size_t i = 0; i < 2; ++i) {
    if ((corners[i] == from && corners[i + 2] == to) || (corners[i] == to && corners[i + 2] == from)) return &polygon;
  }
  return nullptr;
}

void FaceList::turn_crowded_diagonals(SurfaceMesh& mesh) const {
  const std::vector<HalfEdge> crowded = edge_mates(mesh).crowded;
  std::vector<const Polygon*> to_turn;
  const auto edge_of = [&](HalfEdge h) {
    return std::minmax({PointIndex{start(mesh, h)}, PointIndex{end(mesh, h)}});
  };  // by value: the other minmax gives references
  for (std::size_t i = 0; i < crowded.size();) {
    const std::pair<PointIndex, PointIndex> edge = edge_of(crowded[i]);
    std::size_t others = 0;
    std::vector<const Polygon*> parted;
    for (; i < crowded.size() && std::pair<PointIndex, PointIndex>(edge_of(crowded[i])) == edge; ++i) {
      const Polygon* polygon = parted_by(crowded[i], mesh);
      if (!polygon)
        ++others;
      else if (parted.empty() || parted.back() != polygon)
        parted.push_back(polygon);
    }
    // One may keep the diagonal if nobody else has an edge there.
    to_turn.insert(to_turn.end(), parted.begin() + (others == 0 && !parted.empty() ? 1 : 0), parted.end());
  }
  for (const Polygon* polygon : to_turn) {
    const PointIndex* corners = corners_.data() + polygon->first_corner;
    const bool along_first = mesh.triangles[polygon->first_triangle][0] == corners[0];
    if (const auto turned = cut_along_diagonal(places_of(*polygon, mesh), along_first ? 1 : 0))
      fill(*polygon, *turned, mesh);
  }
}

std::vector<std::string> FaceList::remarks() const {
  std::vector<std::string> lines;
  if (!polygons_.empty()) {
    std::string line =
        counted(polygons_.size(), "face of more than three corners was", "faces of more than three corners were") +
        " cut into triangles";
    if (bent_ > 0) {
      line += fmt::format("; {} not flat, by up to {:.3g} mm: cut as seen along the axis nearest to the normal",
                          counted(bent_, "is", "are"), farthest_off_);
    }
    if (fans_ > 0)
      line += fmt::format("; {} and {} cut as a fan from the first corner",
                          counted(fans_, "crosses itself", "cross themselves"), fans_ == 1 ? "was" : "were");
    lines.push_back(std::move(line));
  }
  if (without_area_ > 0)
    lines.push_back(
        counted(without_area_, "face of fewer than three corners was", "faces of fewer than three corners were") +
        " left out");
  return lines;
}

}  // namespace odontoscope
