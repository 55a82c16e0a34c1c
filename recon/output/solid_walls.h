#pragma once
// The walls of a tetrahedral solid as solvers name them, and which end of a tooth is which.
//
// They are made of the tetrahedra, not of Solid::surface, which may have been simplified since.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "recon/delaunay/reconstruct.h"

namespace odontoscope {

/// A triangle of a wall, and the tetrahedron's face that it is: face i lies opposite vertex i.
struct WallFace {
  std::uint32_t tetrahedron = 0;
  int face = 0;
  Triangle triangle{};  // counter-clockwise from outside the material
};

/// The external surfaces of a solid, or its cavities.
struct Wall {
  std::string name;  // "tooth external", "tooth cavity"
  std::vector<WallFace> faces;
};

/// In the order external, cavity; those that are there.
std::vector<Wall> walls_of(const Solid& solid);

/// Crown and root, told by the enamel: the crown is what lies beyond the height where the enamel begins. Nothing if no
/// structure is called "enamel" (or "enamel+..."), or if it is all there is.
struct CrownLimit {
  double z = 0;
  bool crown_above = true;
  bool in_crown(double height) const { return crown_above ? height >= z : height <= z; }
};
std::optional<CrownLimit> crown_limit(const Reconstruction& reconstruction);

}  // namespace odontoscope
