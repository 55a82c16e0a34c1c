#include "recon/delaunay/strands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "recon/core/limits.h"
#include "recon/core/portable_math.h"

namespace odontoscope::delaunay {
namespace {

struct RingBox {
  Point2 low, high;
};

RingBox box_of(const Polygon& ring) {
  RingBox box{ring.front(), ring.front()};
  for (const Point2& p : ring)
    box = {{std::min(box.low.x, p.x), std::min(box.low.y, p.y)},
           {std::max(box.high.x, p.x), std::max(box.high.y, p.y)}};
  return box;
}

bool within(const RingBox& a, const RingBox& b, double reach) {
  return a.low.x <= b.high.x + reach && b.low.x <= a.high.x + reach && a.low.y <= b.high.y + reach &&
         b.low.y <= a.high.y + reach;
}

/// Twice the signed area of the triangle.
double twice_triangle(Point2 a, Point2 b, Point2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool cross(Point2 a, Point2 b, Point2 c, Point2 d) {
  return (twice_triangle(a, b, c) > 0) != (twice_triangle(a, b, d) > 0) &&
         (twice_triangle(c, d, a) > 0) != (twice_triangle(c, d, b) > 0);
}

/// 0 if what they enclose overlaps, else the distance of the two. Cost: the product of their sizes.
double gap_between(const Polygon& a, const Polygon& b) {
  if (encloses(a, b.front()) || encloses(b, a.front())) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Point2 a1 = a[i], a2 = a[(i + 1) % a.size()], b1 = b[j], b2 = b[(j + 1) % b.size()];
      if (cross(a1, a2, b1, b2)) return 0;
      least = std::min({least, distance_to_edge(a1, b1, b2), distance_to_edge(b1, a1, a2)});
    }
  return least;
}

}  // namespace

Strands::Strands(const Reconstruction& made, const ContourStack& ordered, const std::string& structure, Of what)
    : what_(what) {
  for (std::size_t k = 0; k < ordered.slices.size(); ++k) {
    heights_.push_back(ordered.slices[k].z);
    first_.push_back(sections_.size());
    const auto& contours = ordered.slices[k].contours;
    for (std::size_t c = 0; c < contours.size(); ++c) {
      if (contours[c].structure != structure) continue;
      const double area = signed_area(contours[c].points);
      if ((area > 0) != (what == Of::material)) continue;
      sections_.push_back({k, c, &contours[c].points, std::abs(area), centroid(contours[c].points)});
    }
  }
  first_.push_back(sections_.size());
  pieces_ = UnionFind(sections_.size());
  for (Section& section : sections_) section.open = section.slice == 0 || section.slice + 1 == ordered.slices.size();
  // NOLINTNEXTLINE(bugprone-branch-clone): links of two kinds
  if (what == Of::material) {
    for (const MadeLink& link : made.links)
      if (link.link.structure == structure) join(link.link.slice, link.link.lower, link.link.upper);
  } else {
    for (const MadeVoidLink& link : made.void_links)
      if (link.structure == structure) join(link.slice, link.lower, link.upper);
  }
}

std::optional<std::size_t> Strands::number(std::size_t slice, std::size_t contour) const {
  const auto begin = sections_.begin() + static_cast<std::ptrdiff_t>(first_[slice]),
             end = sections_.begin() + static_cast<std::ptrdiff_t>(first_[slice + 1]);
  const auto at =
      std::lower_bound(begin, end, contour, [](const Section& section, std::size_t c) { return section.contour < c; });
  if (at == end || at->contour != contour) return std::nullopt;
  return static_cast<std::size_t>(at - sections_.begin());
}

/// None: the outside, which ends a void openly and makes no two of them one.
void Strands::join(std::size_t slice, std::optional<std::size_t> lower, std::optional<std::size_t> upper) {
  const auto below = lower ? number(slice, *lower) : std::nullopt,
             above = upper ? number(slice + 1, *upper) : std::nullopt;
  if (below) sections_[*below].linked_above = true;
  if (above) sections_[*above].linked_below = true;
  if (below && above) {
    sections_[*below].area_above += sections_[*above].area;
    sections_[*above].area_below += sections_[*below].area;
  }
  if (below && !upper) sections_[*below].open = true;
  if (above && !lower) sections_[*above].open = true;
  if (below && above) pieces_.join(static_cast<std::uint32_t>(*below), static_cast<std::uint32_t>(*above));
}

/// Will its area be much smaller one slab on, if it goes on changing as it did?
bool Strands::runs_out(const Section& section, Towards next) const {
  const bool upwards = next == Towards::above;
  const double inner = upwards ? section.area_below : section.area_above;
  if (!(inner > 0)) return false;
  const double above = section.slice + 1 < heights_.size() ? heights_[section.slice + 1] - heights_[section.slice] : 0;
  const double below = section.slice > 0 ? heights_[section.slice] - heights_[section.slice - 1] : 0;
  const double onwards = upwards ? above : below, before = upwards ? below : above;
  return section.area + (section.area - inner) * onwards / before < limits::track_taper * section.area;
}

void Strands::face_in_slab(std::size_t slice, const std::vector<Link>& apart, std::vector<FacingEnds>& found) {
  std::vector<std::pair<RingBox, std::size_t>> upper;
  for (std::size_t b = first_[slice + 1]; b < first_[slice + 2]; ++b) upper.emplace_back(box_of(*sections_[b].ring), b);
  for (std::size_t a = first_[slice]; a < first_[slice + 1]; ++a) {
    const Section& below = sections_[a];
    const RingBox box = box_of(*below.ring);
    for (const auto& [other_box, b] : upper) {
      const Section& above = sections_[b];
      if ((below.linked_above && above.linked_below) || piece(a) == piece(b)) continue;
      const bool both_end = !below.linked_above && !above.linked_below;
      if (what_ == Of::voids && !both_end &&
          (below.linked_above ? runs_out(above, Towards::below) : runs_out(below, Towards::above)))
        continue;
      const double reach = both_end ? limits::facing_gap * std::sqrt(std::min(below.area, above.area)) : 0;
      if (!within(box, other_box, reach)) continue;
      const bool forbidden = std::any_of(apart.begin(), apart.end(), [&](const Link& link) {
        return link.lower == below.contour && link.upper == above.contour;
      });
      if (forbidden) continue;
      const double gap = gap_between(*below.ring, *above.ring);
      if (gap > reach) continue;
      found.push_back({a, b, gap, portable::hypot(below.centre.x - above.centre.x, below.centre.y - above.centre.y)});
    }
  }
}

std::vector<std::vector<FacingEnds>> Strands::facing(const std::vector<Link>& links) {
  std::vector<std::vector<FacingEnds>> groups;
  for (std::size_t k = 0; k + 2 < first_.size(); ++k) {
    std::vector<Link> apart;
    for (const Link& link : links)
      if (!link.connect && link.slice == k) apart.push_back(link);
    std::vector<FacingEnds> found;
    face_in_slab(k, apart, found);
    std::sort(found.begin(), found.end(), [](const FacingEnds& a, const FacingEnds& b) {
      return std::tie(a.gap, a.aside, a.lower, a.upper) < std::tie(b.gap, b.aside, b.lower, b.upper);
    });
    UnionFind common(first_[k + 2] - first_[k]);
    for (const FacingEnds& pair : found)
      common.join(static_cast<std::uint32_t>(pair.lower - first_[k]),
                  static_cast<std::uint32_t>(pair.upper - first_[k]));
    std::map<std::uint32_t, std::vector<FacingEnds>> by_end;
    for (const FacingEnds& pair : found)
      by_end[common.find(static_cast<std::uint32_t>(pair.lower - first_[k]))].push_back(pair);
    for (auto& [end, group] : by_end) groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace odontoscope::delaunay
