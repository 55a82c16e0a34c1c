#include "recon/partition/structures_meet.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "recon/core/polygon.h"

namespace odontoscope {
namespace {

constexpr std::size_t asked_of_a_contour = 32, asked_of_a_slice = 4096;

struct Outline {
  const Contour* contour;
  Point2 low, high;

  explicit Outline(const Contour& one) : contour(&one), low{one.points.front()}, high{low} {
    for (const Point2& p : one.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  bool near(const Point2& p) const { return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y; }
};

/// Does a place lie within another structure (by parity, so not in its holes), or on one of its points?
bool meets_another(const std::vector<Outline>& outlines, const std::string& own, const Point2& at) {
  std::map<std::string_view, bool> within;
  for (const Outline& outline : outlines) {
    const Contour& contour = *outline.contour;
    if (contour.structure == own || !outline.near(at)) continue;
    if (std::find(contour.points.begin(), contour.points.end(), at) != contour.points.end()) return true;
    if (encloses(contour.points, at)) within[contour.structure] = !within[contour.structure];
  }
  return std::any_of(within.begin(), within.end(), [](const auto& one) { return one.second; });
}

bool meet_in(const Slice& slice) {
  std::vector<Outline> outlines;
  for (const Contour& contour : slice.contours)
    if (!contour.points.empty()) outlines.emplace_back(contour);
  const bool several = std::any_of(outlines.begin(), outlines.end(), [&](const Outline& one) {
    return one.contour->structure != outlines[0].contour->structure;
  });
  if (!several) return false;
  const std::size_t each = std::max<std::size_t>(1, std::min(asked_of_a_contour, asked_of_a_slice / outlines.size()));
  for (const Outline& outline : outlines) {
    const auto& points = outline.contour->points;
    const std::size_t step = std::max<std::size_t>(1, points.size() / each);
    for (std::size_t i = 0; i < points.size(); i += step)
      if (meets_another(outlines, outline.contour->structure, points[i])) return true;
  }
  return false;
}

}  // namespace

bool structures_meet(const ContourStack& stack) {
  return std::any_of(stack.slices.begin(), stack.slices.end(), meet_in);
}

}  // namespace odontoscope
