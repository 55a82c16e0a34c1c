#include "tests/raycast/reference.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>
#include <limits>

namespace odontoscope::test {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// What is kept of a ray between two planes.
void clip(double origin, double speed, double low, double high, Span& span) {
  if (speed == 0) {
    if (origin < low || origin > high) span.to = -infinite;
    return;
  }
  span.from = std::max(span.from, std::min((low - origin) / speed, (high - origin) / speed));
  span.to = std::min(span.to, std::max((low - origin) / speed, (high - origin) / speed));
}

/// Each step of the ray's, cut off at both ends, by its middle and its length.
template <class Visit>
void for_each_step(double stride, const Span& whole, double from, double to, Visit visit) {
  for (double number = std::floor((from - whole.from) / stride); whole.from + number * stride < to; ++number) {
    const double near = std::max(whole.from + number * stride, from),
                 far = std::min(whole.from + (number + 1) * stride, to);
    if (near < far) visit(0.5 * (near + far), far - near);
  }
}

double part(const VolumeLook& look, double value) {
  return std::clamp((value - look.black) / (look.white - look.black), 0.0, 1.0);
}

}  // namespace

Ray ray_through(const Camera& camera, PixelSize size, int x, int y) {
  const glm::dvec3 ahead = glm::normalize(camera.target - camera.position),
                   right = glm::normalize(glm::cross(ahead, camera.up)), up = glm::cross(right, ahead);
  const double across = 2 * (x + 0.5) / size.width - 1, along = 1 - 2 * (y + 0.5) / size.height,
               aspect = static_cast<double>(size.width) / size.height;
  if (camera.projection == Camera::Projection::parallel) {
    const double half = 0.5 * camera.height_mm;
    return {camera.position + half * (aspect * across * right + along * up), ahead, -1e6};
  }
  const double slope = std::tan(0.5 * glm::radians(camera.field_of_view_deg));
  return {camera.position, glm::normalize(ahead + slope * (aspect * across * right + along * up)), 0};
}

double value_at(const ValueGrid& grid, const glm::dvec3& place) {
  const glm::dvec3 inside = (place - grid.first_mm) / grid.step_mm;
  double sum = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::size_t index[3];
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double last = static_cast<double>(grid.size[axis] - 1),
                   at = std::clamp(inside[static_cast<int>(axis)], 0.0, last),
                   low = std::min(std::floor(at), std::max(last - 1, 0.0));
      const bool upper = (corner >> axis & 1u) != 0;
      weight *= upper ? at - low : 1 - (at - low);
      index[axis] = static_cast<std::size_t>(std::min(low + (upper ? 1 : 0), last));
    }
    sum += weight * static_cast<double>(grid.values[(index[2] * grid.size[1] + index[1]) * grid.size[0] + index[0]]);
  }
  return sum;
}

double slope_at(const ValueGrid& grid, const glm::dvec3& place) {
  const glm::dvec3 aside = 0.6 * grid.step_mm;
  glm::dvec3 slope(0);
  for (const glm::dvec3& corner : {glm::dvec3{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})
    slope += value_at(grid, place + aside * corner) * corner / (4.0 * aside);
  return glm::length(slope);
}

Span span_of(const Ray& ray, const ValueGrid& grid, const std::optional<Section>& section) {
  Span span{ray.begin, infinite};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = grid.first_mm[axis] - 0.5 * grid.step_mm[axis];
    clip(ray.origin[axis], ray.direction[axis], low,
         low + static_cast<double>(grid.size[static_cast<std::size_t>(axis)]) * grid.step_mm[axis], span);
  }
  if (section)
    clip(glm::dot(section->normal, ray.origin - section->point_mm), glm::dot(section->normal, ray.direction), -1e12, 0,
         span);
  return span;
}

double stride_of(const ValueGrid& grid) { return 0.5 * std::min({grid.step_mm.x, grid.step_mm.y, grid.step_mm.z}); }

Seen over(const Seen& before, const Seen& behind) {
  return {before.light + (1 - before.covered) * behind.light, before.covered + (1 - before.covered) * behind.covered};
}

Seen shaded(const ValueGrid& grid, const VolumeLook& look, const Ray& ray, const Span& whole, double from, double to,
            double steps) {
  constexpr int parts = 64;
  Seen seen;
  if (whole.empty()) return seen;
  for_each_step(stride_of(grid) / steps, whole, std::max(from, whole.from), std::min(to, whole.to),
                [&](double way, double length) {
                  const double before = value_at(grid, ray.at(way - 0.5 * length)),
                               after = value_at(grid, ray.at(way + 0.5 * length));
                  double extinction = 0;
                  glm::dvec3 colour(0);
                  for (int part = 0; part < parts; ++part) {
                    const glm::dvec4 here(transferred(look.transfer, before + (after - before) * (part + 0.5) / parts));
                    extinction += here.a / parts;
                    colour += here.a / parts * glm::dvec3(here);
                  }
                  if (!(extinction > 0)) return;
                  const double share = look.slopes.count()
                                           ? std::clamp((slope_at(grid, ray.at(way)) - look.slopes.flat) /
                                                            (look.slopes.steep - look.slopes.flat),
                                                        0.0, 1.0)
                                           : 1;
                  const double covers = 1 - std::exp(-share * extinction * length);
                  seen = over(seen, {covers / extinction * colour, covers});
                });
  return seen;
}

double largest(const ValueGrid& grid, const VolumeLook& look, const Ray& ray, const Span& whole) {
  double most = 0;
  for_each_step(stride_of(grid), whole, whole.from, whole.to,
                [&](double way, double) { most = std::max(most, part(look, value_at(grid, ray.at(way)))); });
  return most;
}

double average(const ValueGrid& grid, const VolumeLook& look, const Ray& ray, const Span& whole) {
  double sum = 0;
  for_each_step(stride_of(grid), whole, whole.from, whole.to,
                [&](double way, double length) { sum += length * part(look, value_at(grid, ray.at(way))); });
  return sum / (whole.to - whole.from);
}

std::optional<double> crossing(const ValueGrid& grid, const VolumeLook& look, const Ray& ray, const Span& whole) {
  const double step = 0.25 * stride_of(grid);
  const auto below = [&](double way) { return value_at(grid, ray.at(way)) < look.iso; };
  if (whole.empty()) return std::nullopt;
  const bool first = below(whole.from);
  for (double from = whole.from; from < whole.to; from += step) {
    double near = from, far = std::min(from + step, whole.to);
    if (below(far) == first) continue;
    for (int halving = 0; halving < 40; ++halving)
      (below(0.5 * (near + far)) == first ? near : far) = 0.5 * (near + far);
    return near;
  }
  return std::nullopt;
}

std::optional<double> hit(const SurfaceMesh& mesh, const Ray& ray, const std::optional<Section>& section) {
  std::optional<double> nearest;
  const auto corner = [&](PointIndex index) {
    return glm::dvec3(mesh.points[index].x, mesh.points[index].y, mesh.points[index].z);
  };
  for (const Triangle& triangle : mesh.triangles) {
    // Moller and Trumbore, Journal of Graphics Tools 2(1), 1997.
    const glm::dvec3 a = corner(triangle[0]), u = corner(triangle[1]) - a, v = corner(triangle[2]) - a,
                     p = glm::cross(ray.direction, v);
    const double det = glm::dot(u, p);
    if (!(det > 0)) continue;  // edge-on, or from behind
    const glm::dvec3 s = ray.origin - a, q = glm::cross(s, u);
    const double b = glm::dot(s, p), c = glm::dot(ray.direction, q), way = glm::dot(v, q) / det;
    if (b < 0 || c < 0 || b + c > det || way < ray.begin) continue;
    if (section && glm::dot(section->normal, ray.at(way) - section->point_mm) > 0) continue;
    if (!nearest || way < *nearest) nearest = way;
  }
  return nearest;
}

double encoded(double light) {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}
double decoded(double shown) {
  const double part = shown / 255;
  return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

}  // namespace odontoscope::test
