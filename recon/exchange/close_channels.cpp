#include "recon/exchange/close_channels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "recon/core/polygon.h"
#include "recon/core/portable_math.h"
#include "recon/core/union_find.h"
#include "recon/exchange/limits.h"
#include "recon/exchange/region_border.h"

namespace odontoscope {
namespace {

double distance(const Point2& a, const Point2& b) { return portable::hypot(a.x - b.x, a.y - b.y); }

double size_of(const std::vector<Point2>& contour) {
  Point2 low = contour.front(), high = low;
  for (const Point2& p : contour) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return std::max(high.x - low.x, high.y - low.y);
}

/// Points in square cells, found again by place.
class Cells {
 public:
  Cells(const std::vector<Point2>& points, double side) : side_(side) {
    for (std::uint32_t i = 0; i < points.size(); ++i) entries_.emplace_back(cell_of(points[i]), i);
    std::sort(entries_.begin(), entries_.end());
  }

  /// Calls `take` with the numbers of those in the cell of `place` and the eight around it.
  template <class Take>
  void near(const Point2& place, Take take) const {
    const Cell middle = cell_of(place);
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const Cell cell{middle.first + dx, middle.second + dy};
        auto entry = std::lower_bound(entries_.begin(), entries_.end(), std::pair(cell, std::uint32_t{0}));
        for (; entry != entries_.end() && entry->first == cell; ++entry) take(entry->second);
      }
    }
  }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;
  Cell cell_of(const Point2& p) const {
    return {static_cast<std::int64_t>(std::floor(p.x / side_)), static_cast<std::int64_t>(std::floor(p.y / side_))};
  }

  double side_;
  std::vector<std::pair<Cell, std::uint32_t>> entries_;
};

/// A corner beside an edge: how far along the edge, from 0 to 1.
struct Beside {
  std::uint32_t edge = 0, corner = 0;
  double along = 0;
};

class Channels {
 public:
  Channels(const std::vector<Point2>& contour, double width)
      : contour_(contour), width_(width), groups_(contour.size()) {
    along_.push_back(0);
    for (std::size_t i = 0; i < contour.size(); ++i) along_.push_back(along_.back() + distance(contour[i], at(i + 1)));
    inside_is_left_ = signed_area(contour) > 0;
  }

  bool find() {
    const double step = std::max(along_.back() / static_cast<double>(contour_.size()), 2 * width_);
    const Cells cells(contour_, step);
    std::size_t looked_at = 0;
    const std::size_t most = limits::channel_looks * contour_.size();
    for (std::uint32_t e = 0; e < contour_.size() && looked_at <= most; ++e) {
      const Point2 &a = contour_[e], &b = at(e + 1);
      const double steps = std::ceil(distance(a, b) / step);
      for (double s = 0; s <= steps && looked_at <= most; ++s) {
        const double t = s / steps;
        cells.near({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, [&](std::uint32_t corner) {
          ++looked_at;
          consider(e, corner);
        });
      }
    }
    return looked_at <= most && widest_ > 0;
  }

  ClosedChannel closed() {
    std::sort(beside_.begin(), beside_.end(), [](const Beside& a, const Beside& b) {
      return std::tie(a.edge, a.along, a.corner) < std::tie(b.edge, b.along, b.corner);
    });
    ClosedChannel result;
    result.width = widest_;
    auto next = beside_.begin();
    for (std::uint32_t i = 0; i < contour_.size(); ++i) {
      add(i, result.points);
      for (; next != beside_.end() && next->edge == i; ++next) add(next->corner, result.points);
    }
    while (result.points.size() > 1 && result.points.back() == result.points.front()) result.points.pop_back();
    return result;
  }

 private:
  const Point2& at(std::size_t i) const { return contour_[i % contour_.size()]; }

  void add(std::uint32_t corner, std::vector<Point2>& points) {
    const Point2& p = contour_[groups_.find(corner)];
    if (points.empty() || !(points.back() == p)) points.push_back(p);
  }

  /// Corner and edge are one side and the other of a channel if they are near in the plane, but not along the contour,
  /// and the contour's outside lies between them.
  void consider(std::uint32_t e, std::uint32_t corner) {
    constexpr double far = 8;
    const std::uint32_t after = static_cast<std::uint32_t>((e + 1) % contour_.size());
    if (corner == e || corner == after) return;
    const Point2 &a = contour_[e], &b = contour_[after], &p = contour_[corner];
    const double ux = b.x - a.x, uy = b.y - a.y, px = p.x - a.x, py = p.y - a.y, squared = ux * ux + uy * uy;
    const double t = nearest_share(p, a, b);
    const double gap = portable::hypot(px - t * ux, py - t * uy);
    if (!(gap <= width_) || gap == 0) return;
    const double aside = ux * py - uy * px;  // positive on the left
    if (inside_is_left_ ? aside > 0 : aside < 0) return;
    const double apart = std::abs(along_[e] + t * std::sqrt(squared) - along_[corner]);
    if (std::min(apart, along_.back() - apart) <= far * width_) return;
    widest_ = std::max(widest_, gap);
    if (distance(p, a) <= width_)
      groups_.join(corner, e);
    else if (distance(p, b) <= width_)
      groups_.join(corner, after);
    else
      beside_.push_back({e, corner, t});
  }

  const std::vector<Point2>& contour_;
  double width_;
  UnionFind groups_;
  std::vector<double> along_;  // of each corner, along the contour; at last all of it
  bool inside_is_left_ = true;
  std::vector<Beside> beside_;
  double widest_ = 0;
};

/// A clockwise border of more than 16 by 16 widths.
bool shuts_a_hole_in(const ClosedChannel& closed) {
  constexpr double widths = 16;
  if (closed.points.size() < 3) return false;
  for (const std::vector<Point2>& border : region_border({closed.points}, {})) {
    if (-signed_area(border) > widths * closed.width * widths * closed.width) return true;
  }
  return false;
}

}  // namespace

std::optional<ClosedChannel> close_channels(const std::vector<Point2>& contour) {
  if (contour.size() < 6) return std::nullopt;  // two corners at either end of a channel, and a hole
  const double width = std::min(limits::widest_channel, limits::channel_share * size_of(contour));
  if (!(width > 0)) return std::nullopt;
  Channels channels(contour, width);
  if (!channels.find()) return std::nullopt;
  ClosedChannel closed = channels.closed();
  return shuts_a_hole_in(closed) ? std::optional(std::move(closed)) : std::nullopt;
}

}  // namespace odontoscope
