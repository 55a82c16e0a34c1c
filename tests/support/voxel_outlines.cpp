#include "tests/support/voxel_outlines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace odontoscope::test {
namespace {

/// An edge of the lattice: from (x, y) one step along x (axis 0) or y (axis 1).
using LatticeEdge = std::array<int, 3>;

struct Samples {
  int size;
  std::vector<double> values;
  double at(int x, int y) const {
    return x < 0 || y < 0 || x > size || y > size ? -1 : values[std::size_t(y * (size + 1) + x)];
  }
};

/// In each cell, contour pieces from one crossed side to the next, the inside on the left. Where two inside corners
/// face each other across a diagonal they stay apart.
void add_cell(const Samples& samples, int x, int y, std::map<LatticeEdge, LatticeEdge>& next) {
  const std::array<bool, 4> inside{samples.at(x, y) > 0, samples.at(x + 1, y) > 0, samples.at(x + 1, y + 1) > 0,
                                   samples.at(x, y + 1) > 0};
  const std::array<LatticeEdge, 4> sides{LatticeEdge{x, y, 0}, {x + 1, y, 1}, {x, y + 1, 0}, {x, y, 1}};
  // Walking counter-clockwise round the cell, side i leads from corner i to i + 1. A run of inside corners is left over
  // the side where it ends; the piece starts there and ends at the side where the run began, which keeps the run on its
  // left.
  for (std::size_t out = 0; out < 4; ++out) {
    if (!inside[out] || inside[(out + 1) % 4]) continue;
    std::size_t in = out;
    while (inside[in]) in = (in + 3) % 4;
    next[sides[out]] = sides[in];
  }
}

Point2 place(const Samples& samples, const LatticeEdge& edge, OutlineOptions options) {
  const auto [x, y, axis] = edge;
  const double a = samples.at(x, y), b = axis == 0 ? samples.at(x + 1, y) : samples.at(x, y + 1);
  const double wanted = options.interpolated ? std::clamp(a / (a - b), 0.02, 0.98) : 0.5;
  const double t = std::round(wanted * 0x1p40) * 0x1p-40;
  return axis == 0 ? Point2{x + t, double(y)} : Point2{double(x), y + t};
}

}  // namespace

WavyField::WavyField(RandomNumbers& random) : threshold_(random.between(-1, 0.5)) {
  for (Wave& wave : waves_)
    wave = {random.between(-1.2, 1.2), random.between(-1.2, 1.2), random.between(-0.8, 0.8),
            random.between(0, 2 * std::numbers::pi), random.between(0.3, 1)};
}

double WavyField::operator()(double x, double y, double z) const {
  double value = -threshold_;
  for (const Wave& wave : waves_) value += wave.height * std::cos(wave.x * x + wave.y * y + wave.z * z + wave.phase);
  return value;
}

std::vector<std::vector<Point2>> outlines(const WavyField& field, int size, double z, OutlineOptions options) {
  Samples samples{size, {}};
  for (int y = 0; y <= size; ++y)
    for (int x = 0; x <= size; ++x) samples.values.push_back(field(x, y, z));
  std::map<LatticeEdge, LatticeEdge> next;
  for (int y = -1; y <= size; ++y)
    for (int x = -1; x <= size; ++x) add_cell(samples, x, y, next);
  std::vector<std::vector<Point2>> rings;
  while (!next.empty()) {
    std::vector<Point2> ring;
    for (auto piece = next.begin(); piece != next.end();) {
      ring.push_back(place(samples, piece->first, options));
      const LatticeEdge to = piece->second;
      next.erase(piece);
      piece = next.find(to);
    }
    rings.push_back(ring);
  }
  return rings;
}

}  // namespace odontoscope::test
