#include "recon/exchange/repeated_contours.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace odontoscope {
namespace {

using Numbers = std::vector<std::pair<double, double>>;

/// Where the least of all rotations begins (two candidates that drop out piece by piece; Y. Shiloach, "Fast
/// canonization of circular strings", Journal of Algorithms 2(2), 1981).
std::size_t least_rotation(const Numbers& ring) {
  const std::size_t n = ring.size();
  std::size_t a = 0, b = 1, equal = 0;
  while (a < n && b < n && equal < n) {
    const auto &x = ring[(a + equal) % n], &y = ring[(b + equal) % n];
    if (x == y) {
      ++equal;
      continue;
    }
    (y < x ? a : b) += equal + 1;
    if (a == b) ++b;
    equal = 0;
  }
  return std::min(a, b);
}

Numbers from_least(Numbers ring) {
  if (ring.size() > 1)
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(least_rotation(ring)), ring.end());
  return ring;
}

/// One and the same for all ways to write a contour down.
Numbers canonical(const Contour& contour) {
  Numbers ring;
  for (const Point2& p : contour.points) ring.emplace_back(p.x + 0.0, p.y + 0.0);  // -0 + 0 is +0
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  const Numbers backward(ring.rbegin(), ring.rend());
  return std::min(from_least(std::move(ring)), from_least(backward));
}

}  // namespace

std::vector<std::size_t> repeats_of_earlier(const std::vector<Contour>& contours) {
  std::set<std::pair<std::string_view, Numbers>> seen;
  std::vector<std::size_t> repeats;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    if (contours[c].points.empty()) continue;
    if (!seen.emplace(contours[c].structure, canonical(contours[c])).second) repeats.push_back(c);
  }
  return repeats;
}

}  // namespace odontoscope
