#include "tests/between/slabs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "recon/input/validate.h"

namespace odontoscope::test {
namespace {

bool in_ring(const Ring& ring, Point2 p) {
  bool within = false;
  for (std::size_t n = 0; n < ring.size(); ++n) {
    const Point2 a = ring[n], b = ring[(n + 1) % ring.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) within = !within;
  }
  return within;
}

double signed_area(const Ring& ring) {
  double twice = 0;
  for (std::size_t n = 0; n < ring.size(); ++n) {
    const Point2 a = ring[n], b = ring[(n + 1) % ring.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

double distance(const Ring& ring, Point2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < ring.size(); ++n) {
    const Point2 a = ring[n], b = ring[(n + 1) % ring.size()];
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    least = std::min(least, std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
  }
  return least;
}

}  // namespace

Ring hole(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

Outline moved(Outline outline, Point2 by) {
  for (Ring& ring : outline) {
    for (Point2& p : ring) p = {p.x + by.x, p.y + by.y};
  }
  return outline;
}

Outline outline_of(const Slice& slice, const std::string& structure) {
  Outline outline;
  for (const Contour& contour : slice.contours) {
    if (contour.structure == structure) outline.push_back(contour.points);
  }
  return outline;
}

Picture picture(const Outline& outline, Point2 low, double side, int columns) {
  Picture result{low, side / columns, columns, {}};
  std::vector<std::size_t> by_area(outline.size());
  std::iota(by_area.begin(), by_area.end(), std::size_t{0});
  std::stable_sort(by_area.begin(), by_area.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(signed_area(outline[a])) > std::abs(signed_area(outline[b]));
  });
  result.innermost.assign(static_cast<std::size_t>(columns * columns), between::outside);
  for (const std::size_t c : by_area) {
    const Ring& ring = outline[c];
    for (int j = 0; j < columns; ++j) {
      const double y = low.y + result.step * (j + 0.5);
      std::vector<double> crossings;
      for (std::size_t n = 0; n < ring.size(); ++n) {
        const Point2 a = ring[n], b = ring[(n + 1) % ring.size()];
        if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
      }
      std::sort(crossings.begin(), crossings.end());
      for (std::size_t n = 0; n + 1 < crossings.size(); n += 2) {
        for (int i = std::max(0, static_cast<int>(std::ceil((crossings[n] - low.x) / result.step - 0.5)));
             i < columns && low.x + result.step * (i + 0.5) < crossings[n + 1]; ++i) {
          result.innermost[static_cast<std::size_t>(j * columns + i)] = c;
        }
      }
    }
  }
  return result;
}

bool covers(const Outline& outline, Point2 at) {
  return std::count_if(outline.begin(), outline.end(), [at](const Ring& ring) { return in_ring(ring, at); }) % 2 == 1;
}

Links overlap_links(const Outline& lower, const Outline& upper) {
  Point2 low{0, 0}, high{0, 0};
  for (const Outline* outline : {&lower, &upper}) {
    for (const Ring& ring : *outline) {
      for (const Point2 p : ring) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
  }
  const double side = 1.01 * std::max(high.x - low.x, high.y - low.y);
  const Picture below = picture(lower, low, side, 300), above = picture(upper, low, side, 300);
  const auto is_void = [](const Outline& outline, std::size_t c) {
    return c == between::outside || signed_area(outline[c]) < 0;
  };
  std::set<std::pair<std::size_t, std::size_t>> material, voids;
  for (std::size_t p = 0; p < below.innermost.size(); ++p) {
    const std::size_t a = below.innermost[p], b = above.innermost[p];
    if (is_void(lower, a) != is_void(upper, b)) continue;
    if (!is_void(lower, a))
      material.insert({a, b});
    else if (a != between::outside || b != between::outside)
      voids.insert({a, b});
  }
  Links links;
  for (const auto& [a, b] : material) links.material.push_back({a, b});
  for (const auto& [a, b] : voids) links.voids.push_back({a, b});
  return links;
}

double distance(const Outline& outline, Point2 at) {
  double least = std::numeric_limits<double>::infinity();
  for (const Ring& ring : outline) least = std::min(least, distance(ring, at));
  return covers(outline, at) ? -least : least;
}

double area(const Outline& outline) {
  double sum = 0;
  for (const Ring& ring : outline) sum += signed_area(ring);
  return sum;
}

double area_in_wrong(const Outline& outline, const std::function<bool(Point2)>& shape, Point2 low, double side,
                     int columns) {
  const Picture made = picture(outline, low, side, columns);
  std::size_t wrong = 0;
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < columns; ++i) {
      const std::size_t c = made.innermost[static_cast<std::size_t>(j * columns + i)];
      const bool material = c != between::outside && signed_area(outline[c]) > 0;
      const Point2 at{low.x + made.step * (i + 0.5), low.y + made.step * (j + 0.5)};
      wrong += material != shape(at);
    }
  }
  return static_cast<double>(wrong) * made.step * made.step;
}

std::size_t points_in(const Outline& outline) {
  std::size_t count = 0;
  for (const Ring& ring : outline) count += ring.size();
  return count;
}

}  // namespace odontoscope::test
