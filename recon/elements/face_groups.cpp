#include "recon/elements/face_groups.h"

#include <algorithm>

#include "recon/mesh/collapse_star.h"

namespace odontoscope::elements {
namespace {

NumberedTriangle face_of(const InterfaceWeb& web, std::uint32_t f) {
  const Triangle& t = web.faces()[f].triangle;
  return numbered(t, {web.points()[t[0]], web.points()[t[1]], web.points()[t[2]]});
}

std::vector<MovingBox> boxes_of(const InterfaceWeb& web) {
  std::vector<MovingBox> boxes;
  for (std::uint32_t f = 0; f < web.faces().size(); ++f) boxes.push_back(box_of(face_of(web, f)));
  return boxes;
}

}  // namespace

NumberedTriangle numbered(const Triangle& triangle, const std::array<Point3, 3>& corners) {
  NumberedTriangle made{{triangle[0], triangle[1], triangle[2]}, {}};
  for (std::size_t i = 0; i < 3; ++i) made.corner[i] = {corners[i].x, corners[i].y, corners[i].z};
  return made;
}

FaceGroups::FaceGroups(const InterfaceWeb& web) : boxes_(boxes_of(web)), tree_(boxes_) {
  for (std::uint32_t f = 0; f < web.faces().size(); ++f) {
    faces_.push_back(face_of(web, f));
    group_.push_back(f);
    members_.push_back({f});
    if (web.alive(f)) continue;
    boxes_[f] = {};
    tree_.move(f, {});
  }
}

void FaceGroups::join(std::uint32_t made, std::uint32_t beside, const InterfaceWeb& web) {
  faces_.push_back(face_of(web, made));
  boxes_.push_back(box_of(faces_.back()));
  group_.push_back(group_[beside]);
  members_[group_[beside]].push_back(made);
  settle(group_[beside]);
}

void FaceGroups::update(std::uint32_t face, const InterfaceWeb& web) {
  faces_[face] = face_of(web, face);
  boxes_[face] = web.alive(face) ? box_of(faces_[face]) : MovingBox{};
  settle(group_[face]);
}

void FaceGroups::settle(std::uint32_t group) {
  MovingBox box;
  for (const std::uint32_t f : members_[group]) box.add(boxes_[f]);
  tree_.move(group, box);
}

bool FaceGroups::fit(const std::vector<NumberedTriangle>& triangles, const std::vector<std::uint32_t>& without) const {
  for (const NumberedTriangle& t : triangles)
    if (CGAL::collinear(t.corner[0], t.corner[1], t.corner[2])) return false;
  for (std::size_t m = 0; m < triangles.size(); ++m) {
    for (std::size_t n = m + 1; n < triangles.size(); ++n)
      if (meet_elsewhere(triangles[m], triangles[n])) return false;
  }
  for (const NumberedTriangle& t : triangles) {
    const MovingBox box = box_of(t);
    const bool cut = tree_.any(box, [&](std::uint32_t group) {
      return std::any_of(members_[group].begin(), members_[group].end(), [&](std::uint32_t f) {
        return boxes_[f].meets(box) && std::find(without.begin(), without.end(), f) == without.end() &&
               meet_elsewhere(t, faces_[f]);
      });
    });
    if (cut) return false;
  }
  return true;
}

}  // namespace odontoscope::elements
