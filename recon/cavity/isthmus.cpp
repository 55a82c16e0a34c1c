#include "recon/cavity/isthmus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "recon/cavity/limits.h"
#include "recon/cavity/roots.h"
#include "recon/core/polygon.h"
#include "recon/core/portable_math.h"
#include "recon/mesh/plane_section.h"

namespace odontoscope::cavity {
namespace {

constexpr std::size_t heights = 120;

/// To the loop's nearest side: positive within.
double depth_in(const Polygon& loop, const Point2& p) {
  const double nearest = distance_to_border(p, loop);
  return encloses(loop, p) ? nearest : -nearest;
}

/// Of the corridor between two places in a loop: twice the least of the depths that are had by stepping aside, up to
/// half the way between the places.
double corridor_width(const Polygon& loop, const Point2& a, const Point2& b) {
  constexpr int along = 15, aside = 12;
  const double x = b.x - a.x, y = b.y - a.y;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 1; i < along; ++i) {
    const double t = static_cast<double>(i) / along;
    const auto depth = [&](double s) { return depth_in(loop, {a.x + t * x - s * y, a.y + t * y + s * x}); };
    double best = depth(0), place = 0;
    for (int k = -aside; k <= aside; ++k) {
      const double s = 0.5 * k / aside, here = depth(s);
      if (here <= best) continue;
      best = here;
      place = s;
    }
    // A thin corridor may lie between two such places.
    for (double step = 0.25 / aside; step > 1e-3; step /= 2) {
      const double left = depth(place - step), right = depth(place + step);
      if (std::max(left, right) <= best) continue;
      place += left > right ? -step : step;
      best = std::max(left, right);
    }
    least = std::min(least, std::max(best, 0.0));
  }
  return 2 * least;
}

/// How far the loop reaches from one place straight towards the other.
double reach_towards(const Polygon& loop, const Point2& from, const Point2& to) {
  const double x = to.x - from.x, y = to.y - from.y, far = portable::hypot(x, y);
  double most = 0;
  for (const Point2& p : loop) {
    const double ahead = ((p.x - from.x) * x + (p.y - from.y) * y) / far,
                 aside = std::abs((p.x - from.x) * y - (p.y - from.y) * x) / far;
    if (aside < ahead) most = std::max(most, ahead);
  }
  return most;
}

/// What a section shows between two canals.
struct Seen {
  std::string type;  // empty: nothing
  double width = 0;
};

struct Passing {
  Point2 at;
  double ball = 0;
};

std::optional<Passing> passing(const CentreLine& line, double z) {
  const std::optional<Point2> at = passes(line, z);
  if (!at) return std::nullopt;
  double nearest = std::numeric_limits<double>::infinity(), ball = 0;
  for (std::size_t i = line.orifice; i < line.points.size(); ++i) {
    const CentrePoint& p = line.points[i];
    const double far = length(p.at - Point3{at->x, at->y, z});
    if (far >= nearest) continue;
    nearest = far;
    ball = p.ball;
  }
  return Passing{*at, ball};
}

Seen between(const std::vector<Polygon>& loops, const Passing& a, const Passing& b, std::size_t canals_in_loop) {
  if (portable::hypot(a.at.x - b.at.x, a.at.y - b.at.y) < a.ball + b.ball) return {};  // one canal, or as good as one
  const std::size_t one = loop_round(loops, a.at), other = loop_round(loops, b.at);
  if (one == loops.size() || other == loops.size()) return {};
  if (one == other) {
    const double width = corridor_width(loops[one], a.at, b.at);
    if (width > limits::isthmus_thin * 2 * std::min(a.ball, b.ball)) return {"V", width};
    return {canals_in_loop > 2 ? "III" : "II", width};
  }
  const bool extended = reach_towards(loops[one], a.at, b.at) > limits::isthmus_reach * a.ball ||
                        reach_towards(loops[other], b.at, a.at) > limits::isthmus_reach * b.ball;
  return {extended ? "IV" : "", 0};
}

}  // namespace

bool is_one_section(const std::vector<Polygon>& loops, const CentreLine& a, const CentreLine& b, double z) {
  const std::optional<Passing> one = passing(a, z), other = passing(b, z);
  if (!one || !other) return false;
  const std::size_t loop = loop_round(loops, one->at);
  if (loop == loops.size() || loop != loop_round(loops, other->at)) return false;
  if (portable::hypot(one->at.x - other->at.x, one->at.y - other->at.y) < one->ball + other->ball) return true;
  return corridor_width(loops[loop], one->at, other->at) >= limits::isthmus_wide * 2 * std::min(one->ball, other->ball);
}

std::vector<Isthmus> isthmuses_of(const Cavity& cavity, const CentreLines& lines,
                                  const std::vector<std::size_t>& canals, double fall) {
  std::vector<Isthmus> found;
  if (canals.size() < 2) return found;
  double top = -std::numeric_limits<double>::infinity(), bottom = -top, width = 0;
  for (const std::size_t c : canals) {
    const CentreLine& line = lines.canals[c];
    top = std::max(top, fall * line.points[line.orifice].at.z);
    bottom = std::min(bottom, fall * line.end.z);
    width = std::max(width, 2 * line.points[(line.orifice + line.points.size()) / 2].ball);
  }
  const double step = (top - bottom) / heights;
  std::vector<Isthmus> open;                // those that the section before showed, too
  std::vector<std::vector<double>> widths;  // of these, section by section
  const auto close = [&](std::size_t i) {
    // Its lowest and highest section may cut its rim only.
    const std::size_t rim = widths[i].size() > 2 ? 1 : 0;
    open[i].narrowest = *std::min_element(widths[i].begin() + static_cast<std::ptrdiff_t>(rim),
                                          widths[i].end() - static_cast<std::ptrdiff_t>(rim));
    if (open[i].to_apex - open[i].from_apex + step >= width) found.push_back(open[i]);
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
    widths.erase(widths.begin() + static_cast<std::ptrdiff_t>(i));
  };
  for (std::size_t h = 0; h < heights && step > 0; ++h) {
    const double above = (static_cast<double>(h) + 0.5) * step, z = fall * (bottom + above);
    const std::vector<Polygon> loops = section_loops(cavity.wall, z);
    std::vector<std::optional<Passing>> at;
    for (const std::size_t c : canals) at.push_back(passing(lines.canals[c], z));
    std::vector<Isthmus> seen;
    for (std::size_t a = 0; a < canals.size(); ++a) {
      for (std::size_t b = a + 1; b < canals.size(); ++b) {
        if (!at[a] || !at[b]) continue;
        const std::size_t own = loop_round(loops, at[a]->at);
        const auto in_loop =
            std::count_if(at.begin(), at.end(), [&](const auto& p) { return p && loop_round(loops, p->at) == own; });
        const Seen one = between(loops, *at[a], *at[b], static_cast<std::size_t>(in_loop));
        if (!one.type.empty()) seen.push_back({one.type, canals[a], canals[b], above, above, one.width});
      }
    }
    const auto same = [](const Isthmus& a, const Isthmus& b) {
      return a.type == b.type && a.one == b.one && a.other == b.other;
    };
    for (std::size_t i = open.size(); i-- > 0;)
      if (std::none_of(seen.begin(), seen.end(), [&](const Isthmus& one) { return same(one, open[i]); })) close(i);
    for (const Isthmus& one : seen) {
      const auto known =
          std::find_if(open.begin(), open.end(), [&](const Isthmus& before) { return same(one, before); });
      if (known == open.end()) {
        open.push_back(one);
        widths.push_back({one.narrowest});
      } else {
        known->to_apex = above;
        widths[static_cast<std::size_t>(known - open.begin())].push_back(one.narrowest);
      }
    }
  }
  while (!open.empty()) close(0);
  std::stable_sort(found.begin(), found.end(),
                   [](const Isthmus& a, const Isthmus& b) { return a.from_apex < b.from_apex; });
  return found;
}

}  // namespace odontoscope::cavity
