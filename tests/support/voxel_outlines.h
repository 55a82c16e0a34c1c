#pragma once
// Iso-contours of a random field by marching squares: closed, simple and disjoint by construction, and as full of
// holes, islands, forks and pits that open elsewhere as real volumes are.

#include <array>
#include <vector>

#include "recon/core/geometry.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {

/// A sum of a few cosines with random directions; positive inside.
class WavyField {
 public:
  explicit WavyField(RandomNumbers& random);
  double operator()(double x, double y, double z) const;

 private:
  struct Wave {
    double x, y, z, phase, height;
  };
  std::array<Wave, 6> waves_;
  double threshold_;
};

struct OutlineOptions {
  /// true: points where the field is zero along the lattice edge; false: in its middle.
  bool interpolated = true;
};

/// Contours at height z over the lattice 0..size, with everything outside it void. Inside to the left.
std::vector<std::vector<Point2>> outlines(const WavyField& field, int size, double z, OutlineOptions options);

}  // namespace odontoscope::test
