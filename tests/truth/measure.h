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
  bool warned = false;                  // the verdict is amber for the sake of this structure
  std::string refused;                  // the message, if it came to nothing
  double wrong_area = 0, own_area = 0;  // summed over planes at a quarter, half and three quarters of every slab, mm^2
  double worst_area = 0;                // of one slab, mm^2 over the same three planes
  std::size_t worst_slab = 0;
  std::optional<double> mean, largest;  // mm, both ways, the larger of the two
  std::size_t triangles = 0;
};

struct MeasureOptions {
  ReconstructOptions engine;
  std::vector<Between> ways{ReconstructOptions{}.between};  // of DT; each is a method
  bool shape = false;                                       // areas and distances too, not topology alone
  bool references = false;                                  // DB and shape-based interpolation, too
};

/// "DT plain", "DT blended", "DT partition", "DB 64", "DB 128", "DB 256", "SBI linear", "SBI cubic": in the order of
/// tables.
const std::vector<std::string>& method_names();
const char* method_name(Between way);

struct Results {
  std::map<std::string, std::vector<MethodResult>> methods;  // for each structure in the truth's order
  std::vector<bool> visible;                                 // whether the slices can tell of it at all, see visible.h
};

/// Anybody's surface of `structure` (its number): topology if it is closed, distances in any case.
MethodResult measure_surface(const SurfaceMesh& surface, const SurfaceReport& report, const Truth& truth,
                             std::size_t structure);

/// `shared`: the same tooth's contours as a partition wants them, structures filled or sharing their walls; none: no
/// partition is made.
Results measure(const ContourStack& stack, const Truth& truth, const MeasureOptions& options,
                const ContourStack* shared = nullptr);

}  // namespace odontoscope::test
