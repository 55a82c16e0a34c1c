#include "tests/benchmark/inputs.h"

#include <cmath>
#include <filesystem>
#include <numbers>

#include "recon/sample/sample_tooth.h"
#include "recon/volume/iso_contours.h"
#include "recon/volume/read_volume.h"

namespace odontoscope::benchmark_inputs {

Molar molar() {
  const std::filesystem::path file = std::filesystem::path(ODONTOSCOPE_DATA) / "ct_molar" / "tooth.nrrd";
  if (std::string(ODONTOSCOPE_DATA).empty() || !std::filesystem::exists(file))
    return {"sample molar", sample_tooth(ToothKind::molar)};
  return {"CT molar", iso_contours(read_volume(file.string()), {{120, "tooth"}}, {.min_area = 4}).stack};
}

ContourStack made_up(std::size_t slices, std::size_t points) {
  ContourStack stack;
  const auto wavy = [](std::size_t count, double radius, double wave, Point2 centre) {
    Contour contour;
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * double(i) / double(count);
      const double r = radius * (1 + wave * std::sin(7 * angle));
      contour.points.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
    }
    return contour;
  };
  for (std::size_t k = 0; k < slices; ++k) {
    const double drift = 0.01 * double(k);
    const Point2 centre{std::sin(drift), std::cos(drift)};
    const std::size_t inner = points / 4;
    stack.slices.push_back({0.1 * double(k), {wavy(points - inner, 10, 0.1, {}), wavy(inner, 3, 0.2, centre)}});
  }
  return stack;
}

std::size_t points_of(const ContourStack& stack) {
  std::size_t points = 0;
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) points += contour.points.size();
  return points;
}

}  // namespace odontoscope::benchmark_inputs
