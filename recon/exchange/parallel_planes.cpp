#include "recon/exchange/parallel_planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "recon/exchange/limits.h"
#include "recon/exchange/plane_frame.h"
#include "recon/formats/parsing.h"
#include "recon/input/counts.h"

namespace odontoscope {
namespace {

Vector vector_of(const Point3& p) { return {p.x, p.y, p.z}; }

/// M. Newell's: twice the area, seen along each axis.
Vector normal_of(const Outline& outline) {
  Vector normal{};
  const Vector o = vector_of(outline.points.front());
  for (std::size_t i = 0; i < outline.points.size(); ++i) {
    Vector a = vector_of(outline.points[i]), b = vector_of(outline.points[(i + 1) % outline.points.size()]);
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] -= o[k];
      b[k] -= o[k];
    }
    const Vector part = cross(a, b);
    for (std::size_t k = 0; k < 3; ++k) normal[k] += part[k];
  }
  return normal;
}

struct Span {
  double low = 0, high = 0;
};

Span span_along(const Outline& outline, const Vector& direction) {
  Span span{dot(vector_of(outline.points.front()), direction), 0};
  span.high = span.low;
  for (const Point3& p : outline.points) {
    const double height = dot(vector_of(p), direction);
    span.low = std::min(span.low, height);
    span.high = std::max(span.high, height);
  }
  return span;
}

bool all_flat_along(const std::vector<Outline>& outlines, const Vector& direction) {
  return std::all_of(outlines.begin(), outlines.end(), [&](const Outline& outline) {
    const Span span = span_along(outline, direction);
    return span.high - span.low <= limits::plane_jitter;
  });
}

/// Of all outlines together, the larger weighing more; its largest component is positive. Zero if none encloses
/// anything.
Vector common_normal(const std::vector<Outline>& outlines) {
  Vector sum{};
  for (const Outline& outline : outlines) {
    const Vector normal = normal_of(outline);
    const double sign = dot(sum, normal) < 0 ? -1 : 1;
    for (std::size_t k = 0; k < 3; ++k) sum[k] += sign * normal[k];
  }
  const double size = length(sum);
  if (!std::isnormal(size)) return {};
  const auto largest =
      std::max_element(sum.begin(), sum.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  return scaled(sum, (*largest < 0 ? -1 : 1) / size);
}

[[noreturn]] void refuse_tilted(const std::vector<Outline>& outlines, const Vector& normal, const Place& whole) {
  const Outline* worst = &outlines.front();
  double farthest = 0;
  for (const Outline& outline : outlines) {
    const Span span = span_along(outline, normal);
    if (span.high - span.low <= farthest) continue;
    farthest = span.high - span.low;
    worst = &outline;
  }
  parsing::refuse("not-parallel", whole,
                  fmt::format("contour {} of {} leaves the plane that is parallel to the others by {:.3g} mm",
                              worst->number, worst->structure, farthest),
                  "Only contours in parallel planes can be reconstructed; choose regions with --structure");
}

Frame common_frame(const std::vector<Outline>& outlines, const Place& whole, std::vector<std::string>& remarks) {
  constexpr Vector axes[] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  for (const Vector& axis : axes) {
    if (!all_flat_along(outlines, axis)) continue;
    if (axis[2] == 0)
      remarks.push_back(fmt::format("the planes lie across {}; the model's z is that axis", axis[0] == 1 ? 'x' : 'y'));
    return frame_of(axis);
  }
  const Vector normal = common_normal(outlines);
  if (length(normal) == 0 || !all_flat_along(outlines, normal))
    refuse_tilted(outlines, length(normal) == 0 ? axes[0] : normal, whole);
  const Frame frame = frame_of(normal);
  remarks.push_back(fmt::format(
      "the planes are oblique and were read in their own frame: x along ({:.6g}, {:.6g}, {:.6g}), y along ({:.6g}, "
      "{:.6g}, {:.6g}), "
      "z along ({:.6g}, {:.6g}, {:.6g}) of the patient",
      frame.u[0], frame.u[1], frame.u[2], frame.v[0], frame.v[1], frame.v[2], frame.n[0], frame.n[1], frame.n[2]));
  return frame;
}

/// Where sorted heights part: the first of each plane.
std::vector<std::size_t> firsts_of_planes(const std::vector<double>& heights, double apart) {
  std::vector<std::size_t> firsts;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (i == 0 || heights[i] - heights[i - 1] > apart) firsts.push_back(i);
  }
  return firsts;
}

double widest_plane(const std::vector<double>& heights, const std::vector<std::size_t>& firsts) {
  double widest = 0;
  for (std::size_t p = 0; p < firsts.size(); ++p) {
    const std::size_t last = (p + 1 < firsts.size() ? firsts[p + 1] : heights.size()) - 1;
    widest = std::max(widest, heights[last] - heights[firsts[p]]);
  }
  return widest;
}

/// How far outlines of one plane may be apart, see the header.
double jitter_of(const std::vector<double>& heights) {
  constexpr double share = 0.1;
  double least_distance = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < heights.size(); ++i) {
    const double gap = heights[i] - heights[i - 1];
    if (gap > limits::plane_jitter) least_distance = std::min(least_distance, gap);
  }
  const double jitter = std::min(limits::plane_jitter, share * least_distance);
  const bool runs_on = widest_plane(heights, firsts_of_planes(heights, jitter)) > jitter;
  return jitter <= limits::plane_thickness || runs_on ? limits::plane_thickness : jitter;
}

/// The one that comes most often; the lowest of those.
double most_frequent(const std::vector<double>& heights, std::size_t first, std::size_t end) {
  double best = heights[first];
  std::size_t most = 0;
  for (std::size_t i = first; i < end;) {
    std::size_t next = i;
    while (next < end && heights[next] == heights[i]) ++next;
    if (next - i > most) best = heights[i];
    most = std::max(most, next - i);
    i = next;
  }
  return best;
}

struct Levels {
  std::vector<double> heights;        // of the outlines, ascending
  std::vector<std::size_t> outlines;  // their numbers
  double off_plane = 0;
};

Levels levels_of(const std::vector<Outline>& outlines, const Vector& normal) {
  std::vector<std::pair<double, std::size_t>> by_height;
  Levels levels;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const Span span = span_along(outlines[i], normal);
    by_height.emplace_back(span.low == span.high ? span.low : (span.low + span.high) / 2, i);
    levels.off_plane = std::max(levels.off_plane, (span.high - span.low) / 2);
  }
  std::sort(by_height.begin(), by_height.end());
  for (const auto& [height, i] : by_height) {
    levels.heights.push_back(height);
    levels.outlines.push_back(i);
  }
  return levels;
}

}  // namespace

std::vector<Slice> slices_of(const std::vector<Outline>& outlines, const Place& whole,
                             std::vector<std::string>& remarks, PatientFrame& patient) {
  if (outlines.empty()) return {};
  const Frame frame = common_frame(outlines, whole, remarks);
  patient.axes = {frame.u, frame.v, frame.n};
  Levels levels = levels_of(outlines, frame.n);
  const double jitter = jitter_of(levels.heights);
  const std::vector<std::size_t> firsts = firsts_of_planes(levels.heights, jitter);
  check_slice_count(firsts.size(), whole);
  std::vector<Slice> slices;
  for (std::size_t p = 0; p < firsts.size(); ++p) {
    const std::size_t end = p + 1 < firsts.size() ? firsts[p + 1] : levels.heights.size();
    check_contours_in_slice(end - firsts[p], whole);
    Slice slice{most_frequent(levels.heights, firsts[p], end), {}};
    std::sort(levels.outlines.begin() + static_cast<std::ptrdiff_t>(firsts[p]),
              levels.outlines.begin() + static_cast<std::ptrdiff_t>(end));
    for (std::size_t i = firsts[p]; i < end; ++i) {
      const Outline& outline = outlines[levels.outlines[i]];
      Contour contour{outline.structure, {}};
      for (const Point3& point : outline.points)
        contour.points.push_back({dot(vector_of(point), frame.u), dot(vector_of(point), frame.v)});
      slice.contours.push_back(std::move(contour));
    }
    slices.push_back(std::move(slice));
  }
  if (const double widest = widest_plane(levels.heights, firsts); widest > limits::plane_thickness) {
    remarks.push_back(
        fmt::format("contours up to {:.3g} mm apart along z were taken as one plane (tolerance {:.3g} mm): {} planes",
                    widest, jitter, slices.size()));
  }
  if (levels.off_plane > limits::plane_thickness) {
    remarks.push_back(
        fmt::format("points lie up to {:.3g} mm off their planes and were projected onto them", levels.off_plane));
  }
  return slices;
}

}  // namespace odontoscope
