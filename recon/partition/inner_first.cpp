#include "recon/partition/inner_first.h"

#include <algorithm>
#include <numeric>

#include "recon/core/polygon.h"

namespace odontoscope::partition {
namespace {

/// Votes of some points of each contour.
struct Votes {
  std::size_t inside = 0, all = 0;
};

void vote(const Slice& slice, const std::string& inner, const std::string& outer, Votes& votes) {
  constexpr std::size_t asked = 8;  // of a contour
  for (const Contour& contour : slice.contours) {
    if (contour.structure != inner) continue;
    const std::size_t step = std::max<std::size_t>(1, contour.points.size() / asked);
    for (std::size_t i = 0; i < contour.points.size(); i += step) {
      ++votes.all;
      votes.inside += std::any_of(slice.contours.begin(), slice.contours.end(), [&](const Contour& around) {
        return around.structure == outer && signed_area(around.points) > 0 &&
               encloses(around.points, contour.points[i]);
      });
    }
  }
}

}  // namespace

std::vector<std::uint32_t> inner_first(const ContourStack& stack, const std::vector<std::string>& structures) {
  const std::size_t count = structures.size();
  std::vector<double> area(count, 0);
  std::vector<std::size_t> enclosed_by(count, 0);
  for (std::size_t s = 0; s < count; ++s) {
    for (const Slice& slice : stack.slices)
      for (const Contour& contour : slice.contours)
        if (contour.structure == structures[s]) area[s] += signed_area(contour.points);
    for (std::size_t t = 0; t < count; ++t) {
      if (s == t) continue;
      Votes votes;
      for (const Slice& slice : stack.slices) {
        const bool both = std::any_of(slice.contours.begin(), slice.contours.end(),
                                      [&](const Contour& c) { return c.structure == structures[t]; });
        if (both) vote(slice, structures[s], structures[t], votes);
      }
      enclosed_by[s] += 2 * votes.inside > votes.all;
    }
  }
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return enclosed_by[a] != enclosed_by[b] ? enclosed_by[a] > enclosed_by[b] : area[a] < area[b];
  });
  return order;
}

}  // namespace odontoscope::partition
