#include "recon/mesh/triangle_pairs.h"

#include <CGAL/intersections.h>

#include <algorithm>

namespace odontoscope {
namespace {

using Point = ExactKernel::Point_3;
using Triangle3 = ExactKernel::Triangle_3;
using Segment3 = ExactKernel::Segment_3;

/// Two triangles on one edge ab, with c and d opposite: do they lie upon each other?
bool folded(const Point& a, const Point& b, const Point& c, const Point& d) {
  return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
}

/// Two triangles with only the vertex `shared` in common: do they meet elsewhere?
bool meet_beside(const Point& shared, const Point& a, const Point& b, const Point& c, const Point& d) {
  return CGAL::do_intersect(Triangle3(shared, a, b), Segment3(c, d)) ||
         CGAL::do_intersect(Triangle3(shared, c, d), Segment3(a, b));
}

}  // namespace

bool meet_elsewhere(const NumberedTriangle& s, const NumberedTriangle& t) {
  std::array<int, 3> in_s{}, in_t{};  // corners that both have come first
  int shared = 0, rest_s = 2, rest_t = 2;
  for (int i = 0; i < 3; ++i) {
    const auto same = std::find(t.number.begin(), t.number.end(), s.number[i]);
    if (same == t.number.end()) {
      in_s[rest_s--] = i;
      continue;
    }
    in_s[shared] = i;
    in_t[shared++] = static_cast<int>(same - t.number.begin());
  }
  for (int i = 0; i < 3; ++i)
    if (std::find(s.number.begin(), s.number.end(), t.number[i]) == s.number.end()) in_t[rest_t--] = i;
  const auto of_s = [&](int i) -> const Point& { return s.corner[in_s[i]]; };
  const auto of_t = [&](int i) -> const Point& { return t.corner[in_t[i]]; };
  switch (shared) {
    case 0:
      return CGAL::do_intersect(Triangle3(s.corner[0], s.corner[1], s.corner[2]),
                                Triangle3(t.corner[0], t.corner[1], t.corner[2]));
    case 1:
      return meet_beside(of_s(0), of_s(1), of_s(2), of_t(1), of_t(2));
    case 2:
      return folded(of_s(0), of_s(1), of_s(2), of_t(2));
    default:
      return true;
  }
}

}  // namespace odontoscope
