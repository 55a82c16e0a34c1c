#pragma once
// Voids inside a solid: the pulp chamber with its canals is one, a bubble another.
//
// A void is known by its wall, a closed shell of negative volume: its triangles are counter-clockwise seen from within
// the void, so that an eye inside sees their fronts. Units: millimetres.
//
// What is open to the outside (a canal whose root is cut off, a chamber with an access cavity) is no void but a pocket.
// Where it is deep and narrow, and opens along z, it is closed by flat caps (see pockets.h): they are no material, but
// walls for everything here.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/mesh/meshes.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {

struct Cavity {
  std::string structure;  // the solid that it lies in; of a body turned inside out, the body
  SurfaceMesh wall;       // closed and connected, on points of its own
  double volume = 0;      // of the void, mm^3: positive
  bool body = false;      // the structure does not lie around the void, but fills it

  /// Of a pocket; empty for a void.
  struct Mouth {
    Point3 at;        // middle of the cap
    double area = 0;  // mm^2
  };
  std::vector<Mouth> mouths;
  std::size_t cap_triangles = 0;        // the wall's last ones
  std::vector<std::uint32_t> cut_from;  // the structure's triangles that line the pocket, in part at least, ascending
};

/// The shells of negative volume, largest first; ties by the wall's lowest point (x, then y, then z). Those smaller
/// than limits::cavity_speck of the largest are left out. A surface of cavities alone (a GLB's "S cavity") is as good
/// as the whole solid's. Open shells are no walls. `report` is that of `surface`.
std::vector<Cavity> cavities_of(const std::string& structure, const SurfaceMesh& surface, const SurfaceReport& report);
std::vector<Cavity> cavities_of(const std::string& structure, const SurfaceMesh& surface);

/// The same of a body that fills the void, turned inside out: its shells of positive volume are the walls.
std::vector<Cavity> voids_filled_by(const std::string& structure, const SurfaceMesh& body);

/// A structure's surface, looked at.
struct StructureSurface {
  std::string structure;
  const SurfaceMesh* surface = nullptr;
};

/// What can be flown through in a whole model: the cavities of all its structures, and pockets that are larger than the
/// largest of them. If it has none, or only specks beside it, the void that a body with "pulp" in its name fills (in
/// any case): so a mesh of the pulp alone will do. Largest first, specks left out as above.
std::vector<Cavity> cavities_in(const std::vector<StructureSurface>& model);

}  // namespace odontoscope
