#pragma once
// A reconstruction held against the truth.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plane_raster.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/input/contour_stack.h"
#include "recon/mesh/surface_report.h"
#include "voxel_topology.h"

namespace odontoscope::test {

/// Pieces, handles and bubbles of the solid within a closed surface: a shell of genus g bounds g handles, whichever way
/// it is turned (half of a boundary's loops bound in the solid).
Topology topology_of(const SurfaceReport& report);

/// What is known of the thing that was cut. Structures by number, as `names` has them.
struct Truth {
  std::vector<std::string> names;
  std::vector<Topology> topology;
  Raster raster;
  /// For each height (ascending) a mask: bit s where structure s is.
  std::function<std::vector<Mask>(const std::vector<double>& heights)> masks;
  /// Surfaces of all structures, in the image.
  std::function<std::vector<SurfaceMesh>()> surfaces;
};

struct MethodResult {
  std::optional<Topology> topology;
  bool warned = false;
  std::string refused;  // the message, if it came to nothing
  double wrong_area = 0, own_area = 0;  // summed over planes at a quarter, half and three quarters of every slab, mm^2
  std::optional<double> mean, largest;  // mm, both ways, the larger of the two
  std::size_t triangles = 0;
};

struct MeasureOptions {
  ReconstructOptions engine;
  bool shape = false;       // areas and distances too, not topology alone
  bool references = false;  // shape-based interpolation and DB, too
};

/// Methods by name ("DT", "DB 64", "SBI linear", ...), for each structure in the truth's order.
using Results = std::map<std::string, std::vector<MethodResult>>;

Results measure(const ContourStack& stack, const Truth& truth, const MeasureOptions& options);

}  // namespace odontoscope::test
