#include "tests/volume/volumes.h"

#include "recon/core/error.h"
#include "recon/input/validate.h"
#include "tests/support/plane_check.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {

Volume volume_of(std::array<std::size_t, 3> size,
                 const std::function<double(std::size_t, std::size_t, std::size_t)>& value) {
  Volume volume;
  volume.size = size;
  for (std::size_t k = 0; k < size[2]; ++k) {
    for (std::size_t j = 0; j < size[1]; ++j) {
      for (std::size_t i = 0; i < size[0]; ++i) volume.values.push_back(static_cast<float>(value(i, j, k)));
    }
  }
  return volume;
}

Volume volume_of_rows(const std::vector<std::string>& rows, std::size_t slices) {
  return volume_of({rows.front().size(), rows.size(), slices},
                   [&rows](std::size_t i, std::size_t j, std::size_t) { return rows[j][i] - '0'; });
}

Volume noise(std::uint64_t seed, std::array<std::size_t, 3> size, int levels) {
  RandomNumbers random(seed);
  return volume_of(size, [&](std::size_t, std::size_t, std::size_t) { return random.below(levels); });
}

bool covers(const Slice& slice, const std::string& structure, Point2 at) {
  bool inside = false;
  for (const Contour& contour : slice.contours) {
    if (contour.structure != structure) continue;
    for (std::size_t n = 0; n < contour.points.size(); ++n) {
      const Point2 a = contour.points[n], b = contour.points[(n + 1) % contour.points.size()];
      if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
  }
  return inside;
}

double signed_area(const std::vector<Point2>& ring) {
  double twice = 0;
  for (std::size_t n = 0; n < ring.size(); ++n) {
    const Point2 a = ring[n], b = ring[(n + 1) % ring.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

double region_area(const Slice& slice, const std::string& structure) {
  double area = 0;
  for (const Contour& contour : slice.contours) {
    if (contour.structure == structure) area += signed_area(contour.points);
  }
  return area;
}

const Slice* slice_at(const ContourStack& stack, double z) {
  for (const Slice& slice : stack.slices) {
    if (slice.z == z) return &slice;
  }
  return nullptr;
}

ContourStack only(const ContourStack& stack, const std::string& structure) {
  ContourStack result = stack;
  for (Slice& slice : result.slices) {
    std::erase_if(slice.contours, [&](const Contour& contour) { return contour.structure != structure; });
  }
  return result;
}

std::string faults(const ContourStack& stack) {
  try {
    validate(stack);
  } catch (const InputError& error) {
    return error.what();
  }
  return breach(stack);
}

}  // namespace odontoscope::test
