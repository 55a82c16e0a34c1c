#include "tests/segmentation/made.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

namespace odontoscope::made {

Ring polygon(int corners, double radius, Point2 centre, double first_angle) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = first_angle + 2 * std::numbers::pi * i / corners;
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return ring;
}

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

ContourStack tooth() {
  ContourStack stack;
  stack.source = "tooth.json";
  for (const double z : {0.5, 1.0, 1.5}) {
    Slice slice{z, {}};
    const auto add = [&](const std::string& structure, Ring ring) {
      slice.contours.push_back({structure, std::move(ring)});
    };
    add("enamel", polygon(60, 6));
    add("enamel", reversed(polygon(50, 4.5)));
    add("enamel", polygon(12, 0.3, {0.05, 0.02}));             // an island
    add("dentine", polygon(50, 4.5));                          // along the enamel's hole
    add("dentine", reversed(polygon(12, 0.3, {0.05, 0.02})));  // and around its island
    add("dentine", reversed(polygon(20, 1, {-2, 0.5 * z})));
    add("dentine", reversed(polygon(24, 1.2, {2, -0.3})));
    add("pulp", polygon(20, 1, {-2, 0.5 * z}));
    add("pulp", polygon(24, 1.2, {2, -0.3}));
    stack.slices.push_back(std::move(slice));
  }
  return stack;
}

std::vector<Ring> sieve(int columns, int rows) {
  std::vector<Ring> rings{{{-1, -1}, {columns * 2.0, -1}, {columns * 2.0, rows * 2.0}, {-1, rows * 2.0}}};
  for (int c = 0; c < columns; ++c)
    for (int r = 0; r < rows; ++r)
      rings.push_back(reversed(polygon(4 + (c + r) % 5, 0.6, {2.0 * c, 2.0 * r}, 0.3 * r)));
  return rings;
}

double signed_area(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

bool covers(const std::vector<Ring>& rings, Point2 at) {
  bool inside = false;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y <= at.y) == (b.y <= at.y)) continue;
      if (a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x) > at.x) inside = !inside;
    }
  }
  return inside;
}

double area(const Slice& slice, const std::string& structure) {
  std::vector<Ring> rings;
  for (const Contour& contour : slice.contours) {
    if (contour.structure == structure) rings.push_back(contour.points);
  }
  double sum = 0;
  for (std::size_t c = 0; c < rings.size(); ++c) {
    std::size_t around = 0;
    for (std::size_t d = 0; d < rings.size(); ++d) around += d != c && covers({rings[d]}, rings[c].front()) ? 1 : 0;
    sum += std::abs(signed_area(rings[c])) * (around % 2 == 0 ? 1 : -1);
  }
  return sum;
}

void Series::write(const std::filesystem::path& folder) const {
  using test::dicom_element;
  std::filesystem::create_directories(folder);
  for (int k = 0; k < count; ++k) {
    test::DicomSlice slice;
    slice.rows = 10;
    slice.columns = 12;
    slice.orientation = orientation;
    slice.position = orientation == "1\\0\\0\\0\\1\\0" ? fmt::format("-3\\4\\{}", 20 + k)
                                                       : fmt::format("-3\\{}\\{}", 4 - 0.6 * k, 20 + 0.8 * k);
    slice.spacing = "0.25\\0.5";  // between rows first
    slice.series = "1.2.3.4";
    slice.instance = fmt::format("1.2.3.4.{}", k + 1);
    slice.pixels.assign(120, 0);
    for (int j = 2; j < 8; ++j)
      for (int i = 3; i < 9; ++i)
        slice.pixels[static_cast<std::size_t>(12 * j + i)] = i == 5 && j == 4 ? 0 : 100;  // with a canal
    if (!character_set.empty()) slice.more += dicom_element(8, 5, "CS", character_set);
    slice.more += dicom_element(8, 0x20, "DA", "20200131") + dicom_element(8, 0x50, "SH", "A1") +
                  dicom_element(0x10, 0x10, "PN", patient) + dicom_element(0x10, 0x20, "LO", "0815") +
                  dicom_element(0x10, 0x40, "CS", "F") + dicom_element(0x20, 0x52, "UI", "1.2.3.99");
    std::ofstream(folder / fmt::format("{}.dcm", k + 1), std::ios::binary) << slice.bytes();
  }
}

}  // namespace odontoscope::made
