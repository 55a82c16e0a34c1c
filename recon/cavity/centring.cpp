#include "recon/cavity/centring.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "recon/cavity/limits.h"

namespace odontoscope::cavity {
namespace {

Point3 moved(const Point3& p, const Direction& by) { return {p.x + by.x, p.y + by.y, p.z + by.z}; }
Point3 between(const Point3& a, const Point3& b, double share) { return moved(a, share * (b - a)); }

double length_of(const std::vector<Point3>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += length(line[i] - line[i - 1]);
  return sum;
}

/// As many steps, each of the same weight; `weights`: one a piece of the line.
std::vector<Point3> spread_by(const std::vector<Point3>& line, const std::vector<double>& weights, std::size_t steps) {
  double whole = 0;
  for (const double weight : weights) whole += weight;
  const double step = whole / static_cast<double>(steps);
  std::vector<Point3> even{line.front()};
  double passed = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double piece = weights[i - 1];
    while (even.size() < steps && static_cast<double>(even.size()) * step <= passed + piece)
      even.push_back(
          between(line[i - 1], line[i], piece > 0 ? (static_cast<double>(even.size()) * step - passed) / piece : 0));
    passed += piece;
  }
  even.resize(steps, line.back());
  even.push_back(line.back());
  return even;
}

/// A line that is being centred. Closed lines hold their first point twice.
class Centring {
 public:
  Centring(std::vector<Point3> line, const WallTree& tree, LineEnd end)
      : line_(std::move(line)), tree_(tree), closed_(end == LineEnd::closed) {
    std::vector<double> radii;
    for (const Point3& p : line_) radii.push_back(std::max(tree_.clearance(p), 0.0));
    std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2), radii.end());
    median_ = std::max(radii[radii.size() / 2],
                       length_of(line_) / (limits::line_step * static_cast<double>(limits::line_points)));
  }

  /// So many local radii apart, so that smoothing reaches as far as the void is wide.
  void spread_by_width(double radii) {
    std::vector<double> weights;
    double whole = 0, before = width(line_.front());
    for (std::size_t i = 1; i < line_.size(); ++i) {
      const double here = width(line_[i]);
      weights.push_back(length(line_[i] - line_[i - 1]) * 2 / (before + here));
      before = here;
      whole += weights.back();
    }
    line_ = spread_by(line_, weights, steps_for(whole / radii));
  }

  void spread_evenly() {
    std::vector<double> weights;
    for (std::size_t i = 1; i < line_.size(); ++i) weights.push_back(length(line_[i] - line_[i - 1]));
    line_ = spread_by(line_, weights, steps_for(length_of(line_) / (limits::line_step * median_)));
  }

  /// Each point to the widest place near it in its cross-section; first and last step of the search over the radius.
  void centre(double first, double finest) {
    std::vector<Point3> there = line_;
    const std::size_t last = line_.size() - 1;
    for (std::size_t i = closed_ ? 0 : 1; i <= last; ++i) there[i] = widest_near(line_[i], tangent(i), first, finest);
    line_ = std::move(there);
    if (closed_) line_.front() = line_.back();
  }

  /// Only points that smoothing has taken off the widest place by more than a little.
  void correct() {
    std::vector<Point3> there = line_;
    const std::size_t last = line_.size() - 1;
    for (std::size_t i = closed_ ? 0 : 1; i < last; ++i) {
      const Point3 widest = widest_near(line_[i], tangent(i), 0.16, 0.04);
      if (tree_.clearance(line_[i]) < limits::line_share * tree_.clearance(widest)) there[i] = widest;
    }
    line_ = std::move(there);
    if (closed_) line_.back() = line_.front();
  }

  /// Low-pass filtering that does not shrink bends (G. Taubin, "A signal processing approach to fair surface design",
  /// 1995).
  void smooth(int times) {
    for (; times > 0; --times) {
      average(0.5);
      average(-0.53);
    }
  }

  void turn() { std::reverse(line_.begin(), line_.end()); }

  /// Without its last points where the way only leads into the corner between the wall and an end cut off flat: there
  /// clearance falls about as fast as the way is long.
  void cut_corner() {
    std::size_t widest = line_.size() - 1;
    double gone = 0, radius = tree_.clearance(line_.back());
    for (std::size_t i = line_.size() - 1; i-- > 1;) {
      gone += length(line_[i + 1] - line_[i]);
      const double here = tree_.clearance(line_[i]);
      if (here - limits::corner_fall * gone > radius) {
        radius = here;
        gone = 0;
        widest = i;
      }
      if (gone > 2 * radius) break;
    }
    if (widest >= 4) line_.resize(widest + 1);
  }

  /// On towards the wall, the way of the last radius and a half, and where it is hit.
  Point3 extend() {
    const std::size_t last = line_.size() - 1;
    std::size_t before = last - std::min<std::size_t>(last, 4);
    const double straight = 1.5 * std::max(tree_.clearance(line_[last]), 0.0);
    while (before > 1 && length(line_[last] - line_[before]) < straight) --before;
    const Direction way = line_[last] - line_[before];
    const Direction ahead = (1 / length(way)) * way;
    const double radius = std::max(tree_.clearance(line_[last]), 0.0);
    Point3 end = line_[last];
    bool leaves = false;
    // Each step is as long as the way is clear; the wall is reached in the limit.
    constexpr int most_steps = 100;
    for (int i = 0; i < most_steps; ++i) {
      const double clear = tree_.clearance(end);
      if (clear < 1e-3 * radius) break;
      const double least = limits::tip_clearance * radius;
      if (!leaves && clear > least) line_.push_back(end);
      leaves = leaves || clear <= least;
      end = moved(end, 0.5 * clear * ahead);
    }
    return end;
  }

  /// Without its last points where the void has closed to a gap: much narrower than a little before.
  void cut_gap() {
    std::size_t first = line_.size() - 1;
    const double part = 3 * median_;
    double far = 0, widest = 0;
    for (; first > 0 && far < part; --first) {
      far += length(line_[first] - line_[first - 1]);
      widest = std::max(widest, tree_.clearance(line_[first]));
    }
    while (line_.size() > 2 && line_.size() > first + 1 && tree_.clearance(line_.back()) < limits::tip_gap * widest)
      line_.pop_back();
  }

  std::vector<CentrePoint> points() {
    std::vector<CentrePoint> made;
    double along = 0;
    for (std::size_t i = 0; i < line_.size(); ++i) {
      along += i > 0 ? length(line_[i] - line_[i - 1]) : 0;
      const double radius = std::max(tree_.clearance(line_[i]), 0.0);
      // First as for the line, which keeps to its canal; then freely: in a flat canal the pull would stop short of the
      // widest place.
      const Point3 near = widest_near(line_[i], tangent(i), 0.16, 0.04);
      const double widest =
          tree_.clearance(widest_near(near, tangent(i), 0.04, limits::ball_fineness, limits::ball_pull));
      made.push_back({line_[i], radius, along, std::max(radius, widest)});
    }
    return made;
  }

 private:
  static std::size_t steps_for(double wanted) {
    return static_cast<std::size_t>(std::clamp(wanted, 8.0, static_cast<double>(limits::line_points)));
  }

  /// Clearance, but not so little that points would crowd.
  double width(const Point3& p) const { return std::max(tree_.clearance(p), 0.4 * median_); }

  Direction tangent(std::size_t i) const {
    const std::size_t last = line_.size() - 1;
    const Direction way = closed_ && (i == 0 || i == last) ? line_[1] - line_[last - 1]
                                                           : line_[std::min(i + 1, last)] - line_[i > 0 ? i - 1 : 0];
    const double size = length(way);
    return size > 0 ? (1 / size) * way : Direction{0, 0, 1};
  }

  /// Each point that share of the way towards the middle of its neighbours.
  void average(double share) {
    std::vector<Point3> there = line_;
    const std::size_t last = line_.size() - 1;
    for (std::size_t i = 1; i < last; ++i)
      there[i] = between(line_[i], between(line_[i - 1], line_[i + 1], 0.5), share);
    if (closed_) there.front() = there.back() = between(line_[0], between(line_[last - 1], line_[1], 0.5), share);
    line_ = std::move(there);
  }

  /// Places of the wall that were nearest to places looked at before: none of what is about can be clearer than the
  /// nearest of them tells.
  class Witnesses {
   public:
    void add(const Point3& at) {
      places_[next_] = at;
      next_ = (next_ + 1) % places_.size();
      count_ = std::min(count_ + 1, places_.size());
    }
    /// Surely: rounding cannot make it otherwise.
    bool nearer_than(double distance, const Point3& from) const {
      constexpr double rounding = 1e-9;
      const double square = (1 - rounding) * distance * distance;
      for (std::size_t i = 0; i < count_; ++i) {
        const Direction way = from - places_[i];
        if (dot(way, way) < square) return true;
      }
      return false;
    }

   private:
    std::array<Point3, 32> places_;
    std::size_t next_ = 0, count_ = 0;
  };

  /// `pull`: back, so that in a flat section points stay about where they are; in a round one it is next to nothing.
  Point3 widest_near(const Point3& start, const Direction& along, double first, double finest, double pull = 0.3) {
    // Two directions across.
    const Direction other = std::abs(along.x) <= std::abs(along.y) && std::abs(along.x) <= std::abs(along.z)
                                ? Direction{1, 0, 0}
                            : std::abs(along.y) <= std::abs(along.z) ? Direction{0, 1, 0}
                                                                     : Direction{0, 0, 1};
    const Direction side = cross(along, other);
    const Direction u = (1 / length(side)) * side, v = cross(along, u);
    const WallTree::Nearest here = tree_.nearest(start);
    witnesses_.add(here.at);
    double best = here.front ? here.distance : -here.distance, x = 0, y = 0;
    const double radius = std::max(best, 0.06 * median_);
    constexpr double directions[6][2] = {{1, 0},          {-0.5, 0.866025}, {-0.5, -0.866025},
                                         {0.5, 0.866025}, {-1, 0},          {0.5, -0.866025}};
    constexpr int most_moves = 40;
    int moves = 0;
    for (double size = first * radius; size >= finest * radius && moves < most_moves;) {
      double better = best, bx = x, by = y;
      // The distance to the wall changes no faster than the place.
      const double most = std::abs(best) + pull * (x * x + y * y) / radius + size;
      for (const auto& [du, dv] : directions) {
        const double nx = x + size * du, ny = y + size * dv;
        const double loss = pull * (nx * nx + ny * ny) / radius, least = std::max(better + loss, 0.0);
        const Point3 there = moved(start, nx * u + ny * v);
        if (least >= most || witnesses_.nearer_than(least, there)) continue;
        Point3 wall = here.at;
        const double clear = tree_.clearance_above(there, least, most, wall) - loss;
        witnesses_.add(wall);
        if (clear > better) {
          better = clear;
          bx = nx;
          by = ny;
        }
      }
      if (better > best) {
        best = better;
        x = bx;
        y = by;
        ++moves;
      } else {
        size /= 2;
      }
    }
    return moved(start, x * u + y * v);
  }

  std::vector<Point3> line_;
  const WallTree& tree_;
  bool closed_;
  double median_ = 0;  // radius
  Witnesses witnesses_;
};

}  // namespace

CentreLine centred(std::vector<Point3> path, const WallTree& tree, LineEnd end) {
  Centring line(std::move(path), tree, end);
  line.spread_by_width(0.5);
  line.smooth(4);
  line.centre(0.4, 0.2);
  line.smooth(4);
  line.spread_by_width(0.5);
  line.centre(0.2, 0.05);
  line.smooth(4);
  line.spread_by_width(limits::line_step);
  line.centre(0.08, 0.015);
  line.smooth(8);
  line.correct();
  CentreLine made;
  if (end == LineEnd::both_blind) {
    line.turn();
    line.cut_corner();
    made.start = line.extend();
    line.turn();
  }
  if (end == LineEnd::blind || end == LineEnd::both_blind) {
    line.cut_corner();
    made.end = line.extend();
    line.cut_gap();
  }
  line.spread_evenly();
  made.points = line.points();
  if (end != LineEnd::both_blind) made.start = made.points.front().at;
  if (end == LineEnd::closed || end == LineEnd::joined) made.end = made.points.back().at;
  return made;
}

}  // namespace odontoscope::cavity
