#include "recon/volume/label_meetings.h"

#include <algorithm>
#include <utility>

namespace odontoscope {
namespace {

using trace::Vertex;

/// The point of a cell at so many quarters of the way from its lower left corner.
Point2 within(const Lattice& lattice, const Vertex& low, int x, int y) {
  return {lattice.x_quarters(low.i, x), lattice.y_quarters(low.j, y)};
}

}  // namespace

LabelMeetings::LabelMeetings(std::vector<float> labels) : labels_(std::move(labels)) {
  std::sort(labels_.begin(), labels_.end());
  labels_.erase(std::unique(labels_.begin(), labels_.end()), labels_.end());
}

std::size_t LabelMeetings::index(float value) const {
  const auto at = std::lower_bound(labels_.begin(), labels_.end(), value);
  return at != labels_.end() && *at == value ? static_cast<std::size_t>(at - labels_.begin()) + 1 : 0;
}

void LabelMeetings::append(const Lattice& lattice, const Cell& cell, std::vector<Point2>& points) {
  const auto& l = cell.labels;
  std::array<std::size_t, 4> sorted = l;
  std::sort(sorted.begin(), sorted.end());
  const auto distinct = std::unique(sorted.begin(), sorted.end()) - sorted.begin();
  if (distinct < 3) return;
  Vertex low = cell.corners[0];
  for (const Vertex& corner : cell.corners) low = {std::min(low.i, corner.i), std::min(low.j, corner.j)};
  const bool first_pair = l[0] == l[2], second_pair = l[1] == l[3];  // of one label across the diagonal
  if (distinct == 3 && !first_pair && !second_pair) {
    points.push_back(within(lattice, low, 2, 2));
    return;
  }
  if ((first_pair && l[0] == 0) || (second_pair && l[1] == 0)) return;
  const bool first_is_cut = distinct == 3 ? first_pair : std::min(l[0], l[2]) < std::min(l[1], l[3]);
  const auto middle_of_cut = [&](std::size_t corner) {
    const Vertex& at = cell.corners[corner];
    return within(lattice, low, at.i == low.i ? 1 : 3, at.j == low.j ? 1 : 3);
  };
  if (first_is_cut) {
    points.push_back(middle_of_cut(0));
    return;
  }
  // Inside on its left: from the edge to corner 1 past that corner's cut, to the edge from corner 3.
  points.push_back(middle_of_cut(1));
  points.push_back(middle_of_cut(3));
}

}  // namespace odontoscope
