#include "recon/formats/write_stl.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "recon/core/error.h"
#include "recon/core/portable_math.h"
#include "recon/formats/little_endian.h"
#include "recon/formats/single_precision.h"

namespace odontoscope {
namespace {

/// Unit normal of the triangle as written; zero if rounding left it without area, which STL allows.
FloatPoint normal(const FloatPoint& a, const FloatPoint& b, const FloatPoint& c) {
  double u[3], v[3];
  for (int i = 0; i < 3; ++i) {
    u[i] = double{b[i]} - a[i];
    v[i] = double{c[i]} - a[i];
  }
  const double n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double length = portable::hypot(n[0], n[1], n[2]);
  if (!(length > 0)) return {0, 0, 0};
  return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length), static_cast<float>(n[2] / length)};
}

}  // namespace

std::string stl_bytes(const WrittenModel& model) {
  constexpr std::size_t header_size = 80, record_size = 50;
  std::size_t triangles = 0;
  for (const WrittenSurface& solid : model.solids) triangles += solid.surface.triangles.size();
  if (triangles > std::numeric_limits<std::uint32_t>::max()) {
    throw UsageError("the model has too many triangles for STL", "Simplify it with --triangles");
  }
  std::string bytes;
  bytes.reserve(header_size + sizeof(std::uint32_t) + record_size * triangles);
  bytes = "odontoscope; millimetres; binary STL";  // must not begin with "solid"
  bytes.resize(header_size, ' ');
  append(bytes, static_cast<std::uint32_t>(triangles));
  const std::vector<std::vector<FloatPoint>> floats = distinct_floats(model, 1);
  for (std::size_t s = 0; s < model.solids.size(); ++s) {
    const std::vector<FloatPoint>& points = floats[s];
    for (const auto& [a, b, c] : model.solids[s].surface.triangles) {
      for (const FloatPoint& p : {normal(points[a], points[b], points[c]), points[a], points[b], points[c]}) {
        for (const float coordinate : p) append(bytes, coordinate);
      }
      append(bytes, std::uint16_t{0});
    }
  }
  return bytes;
}

}  // namespace odontoscope
