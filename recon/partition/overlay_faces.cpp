#include "recon/partition/overlay_faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace odontoscope::partition {
namespace {

/// Of a void triangle that touches two structures or more: the first of them by priority to whose borders, those at
/// its corners, all its corners are within the gap. None: void_label.
Label gap_taker(const Overlay& overlay, const Materials& materials, Overlay::Face_handle face) {
  const auto label = [&](Overlay::Face_handle one) { return label_of(overlay, one); };
  std::map<Label, std::vector<Kernel::Segment_2>> borders;  // at its corners
  for (int i = 0; i < 3; ++i) {
    const auto corner = face->vertex(i);
    auto around = overlay.incident_faces(corner), end = around;
    do {
      const int k = around->index(corner);
      for (const int side : {Overlay::ccw(k), Overlay::cw(k)}) {
        if (label(around) == void_label || label(around->neighbor(side)) == label(around)) continue;
        borders[label(around)].emplace_back(around->vertex(Overlay::ccw(side))->point(),
                                            around->vertex(Overlay::cw(side))->point());
      }
    } while (++around != end);
  }
  if (borders.size() < 2) return void_label;
  Label best = void_label;
  for (const auto& [one, segments] : borders) {
    if (!materials.wins(one, best)) continue;
    bool within = true;
    for (int i = 0; i < 3; ++i) {
      const auto& p = face->vertex(i)->point();
      within = within && std::any_of(segments.begin(), segments.end(), [&](const Kernel::Segment_2& segment) {
                 return CGAL::squared_distance(p, segment) <= materials.gap * materials.gap;
               });
    }
    if (within) best = one;
  }
  return best;
}

struct Piece {
  std::vector<Overlay::Face_handle> faces;
  double area = 0, around = 0;
  std::map<Label, double> beside;  // length of common border
  bool outer = false;
};

Piece piece_at(const Overlay& overlay, Overlay::Face_handle start) {
  const auto label = [&](Overlay::Face_handle one) { return label_of(overlay, one); };
  Piece piece;
  std::vector<Overlay::Face_handle> stack{start};
  start->info().known = true;
  while (!stack.empty()) {
    const auto face = stack.back();
    stack.pop_back();
    piece.faces.push_back(face);
    piece.area += std::abs(CGAL::area(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point()));
    for (int i = 0; i < 3; ++i) {
      const auto other = face->neighbor(i);
      if (label(other) != label(start)) {
        const double length = std::sqrt(
            CGAL::squared_distance(face->vertex(Overlay::ccw(i))->point(), face->vertex(Overlay::cw(i))->point()));
        piece.around += length;
        piece.beside[label(other)] += length;
      } else if (overlay.is_infinite(other)) {
        piece.outer = true;
      } else if (!other->info().known) {
        other->info().known = true;
        stack.push_back(other);
      }
    }
  }
  return piece;
}

}  // namespace

double close_gaps(Overlay& overlay, const Materials& materials) {
  std::vector<std::pair<Overlay::Face_handle, Label>> closed;
  double area = 0;
  for (auto face = overlay.finite_faces_begin(); face != overlay.finite_faces_end(); ++face) {
    if (face->info().label != void_label) continue;
    const Label taker = gap_taker(overlay, materials, face);
    if (taker == void_label) continue;
    closed.emplace_back(face, taker);
    area += std::abs(CGAL::area(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point()));
  }
  for (const auto& [face, label] : closed) face->info().label = label;
  return area;
}

void drop_slivers(Overlay& overlay, const Materials& materials) {
  for (auto face = overlay.all_faces_begin(); face != overlay.all_faces_end(); ++face) face->info().known = false;
  std::vector<std::pair<std::vector<Overlay::Face_handle>, Label>> dropped;
  for (auto face = overlay.finite_faces_begin(); face != overlay.finite_faces_end(); ++face) {
    if (face->info().known) continue;
    Piece piece = piece_at(overlay, face);
    if (piece.outer || 2 * piece.area >= materials.sliver * piece.around) continue;
    const auto longest = std::max_element(piece.beside.begin(), piece.beside.end(),
                                          [](const auto& p, const auto& q) { return p.second < q.second; });
    dropped.emplace_back(std::move(piece.faces), longest->first);
  }
  for (const auto& [faces, label] : dropped)
    for (const auto& face : faces) face->info().label = label;
}

}  // namespace odontoscope::partition
