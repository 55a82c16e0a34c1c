#pragma once
// The family: teeth whose truth is known, since they are formulas. Each is a molar, premolar or incisor with its
// anatomy varied at random: number of roots and canals, their course and width, fused roots, furcation height, pulp
// chamber and horns, cervical margin, cusps and fissures, apices open or closed, accessory canals from canals and into
// the furcation; then stretched along its axes and turned. The tables that it begins with are the family's own
// (tests/truth/teeth, the format of assets/teeth): horns and fissures sharper than the sample teeth have them.
//
// What is drawn keeps some thickness, so that sections can tell of it: canals at least 0.13 mm in radius, 0.25 mm of
// dentine around them but at an open apex or where an accessory canal leaves, 0.3 mm above horns.

#include <array>
#include <cstdint>
#include <string>

#include "recon/sample/tooth_shape.h"

namespace odontoscope::test {

/// How the tooth lies in the image: stretched along its own axes, turned by `spin` about them (z), then by `tilt` about
/// the image's x axis. Both together are a tilt about any horizontal axis of the tooth, seen from above by somebody who
/// stands on that axis.
struct Pose {
  std::array<double, 3> stretch{1, 1, 1};
  double spin = 0, tilt = 0;  // radians
};

struct RandomTooth {
  std::uint64_t seed = 0;
  sample::ToothShape shape;
  Pose pose;
  double first_slice = 0.5;  // share of the spacing that the first slice lies above the lowest point
  std::string in_words;      // "molar, 3 roots, 4 canals (1 open), 1 accessory, tilt 21"
};

/// The same tooth for the same seed, on every machine.
RandomTooth random_tooth(std::uint64_t seed);

}  // namespace odontoscope::test
