#include "recon/cavity/tooth_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "recon/cavity/degrees.h"
#include "recon/cavity/limits.h"
#include "recon/core/portable_math.h"
#include "recon/core/symmetric_matrix.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {
namespace {

/// Volume and its first and second moments about an origin near the model.
struct Moments {
  double volume = 0;
  std::array<double, 3> first{};
  Matrix3 second{};

  void add_tetrahedron(const Direction& a, const Direction& b, const Direction& c) {
    const double v = dot(a, cross(b, c)) / 6;
    const std::array<std::array<double, 3>, 3> corners{{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}};
    volume += v;
    for (std::size_t i = 0; i < 3; ++i) {
      const double sum_i = corners[0][i] + corners[1][i] + corners[2][i];
      first[i] += v * sum_i / 4;
      for (std::size_t j = 0; j < 3; ++j) {
        const double sum_j = corners[0][j] + corners[1][j] + corners[2][j];
        double products = sum_i * sum_j;
        for (const auto& corner : corners) products += corner[i] * corner[j];
        second[i][j] += v * products / 20;
      }
    }
  }
};

}  // namespace

ToothAxis tooth_axis(const std::vector<StructureSurface>& model) {
  const Point3* origin = nullptr;
  Moments moments;
  for (const StructureSurface& part : model) {
    const SurfaceReport report = inspect(*part.surface);
    for (std::size_t t = 0; t < part.surface->triangles.size(); ++t) {
      if (report.shells[report.shell_of[t]].kind == Shell::Kind::open) continue;
      const auto& points = part.surface->points;
      const Triangle& corners = part.surface->triangles[t];
      if (origin == nullptr) origin = &points[corners[0]];
      moments.add_tetrahedron(points[corners[0]] - *origin, points[corners[1]] - *origin, points[corners[2]] - *origin);
    }
  }
  if (!(std::abs(moments.volume) > 0)) return {};
  Matrix3 spread{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      spread[i][j] = moments.second[i][j] / moments.volume -
                     moments.first[i] * moments.first[j] / (moments.volume * moments.volume);
  const Matrix3 vectors = eigenvectors(spread);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return spread[a][a] > spread[b][b]; });
  const std::size_t most = order[0];
  Direction along{vectors[0][most], vectors[1][most], vectors[2][most]};
  if (along.z < 0) along = -1.0 * along;
  const double tilt = degrees_per_radian * portable::atan2(portable::hypot(along.x, along.y), along.z);
  const bool is_long = spread[most][most] >= limits::axis_ratio * limits::axis_ratio * spread[order[1]][order[1]];
  if (!is_long || tilt < limits::axis_tilt_deg) return {};
  return {along, tilt, true};
}

Upright::Upright(const Direction& axis) : w_((1 / length(axis)) * axis) {
  const Direction side =
      cross(std::abs(w_.y) < 0.9 ? Direction{0, 1, 0} : Direction{0, 0, 1}, w_);  // of z itself no turn
  u_ = (1 / length(side)) * side;
  v_ = cross(w_, u_);
}

Point3 Upright::turned(const Point3& p) const {
  const Direction d{p.x, p.y, p.z};
  return {dot(d, u_), dot(d, v_), dot(d, w_)};
}

Point3 Upright::back(const Point3& p) const {
  const Direction d = p.x * u_ + p.y * v_ + p.z * w_;
  return {d.x, d.y, d.z};
}

SurfaceMesh Upright::turned(const SurfaceMesh& surface) const {
  SurfaceMesh made = surface;
  for (Point3& p : made.points) p = turned(p);
  return made;
}

CentreLines Upright::turned(const CentreLines& lines) const {
  CentreLines made = lines;
  made.chamber = turned(made.chamber);
  for (std::vector<CentreLine>* some : {&made.canals, &made.horns, &made.others, &made.loops}) {
    for (CentreLine& line : *some) {
      for (CentrePoint& p : line.points) p.at = turned(p.at);
      line.start = turned(line.start);
      line.end = turned(line.end);
    }
  }
  return made;
}

}  // namespace odontoscope
