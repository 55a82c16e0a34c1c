#pragma once
// Where the truth comes from: a tooth's formulas, or real meshes.

#include <optional>
#include <string>
#include <vector>

#include "measure.h"
#include "recon/mesh/named_mesh.h"
#include "turned_tooth.h"

namespace odontoscope::test {

/// Counts voxels on one grid after the other, each finer, until two agree for all structures; nothing if none do: then
/// the shape has a detail too fine to be sure of. Steps in mm, descending.
std::optional<std::vector<Topology>> counted_topology(const TurnedTooth& tooth, const std::vector<double>& steps);

/// The steps that the harness counts with.
const std::vector<double>& usual_steps();

/// `tooth` must outlive it; one thread at a time may ask it. `raster_step`: of masks, mm.
Truth tooth_truth(const TurnedTooth& tooth, std::vector<Topology> topology, double raster_step = 0.05);

/// A real tooth, each part a mesh, perhaps torn; gaps in a section up to `widest_gap` (mm) are closed by straight
/// lines.
class RealTooth {
 public:
  struct Part {
    NamedMesh mesh;
    bool repair = false;
    double widest_gap = 0.5;
  };
  explicit RealTooth(std::vector<Part> parts) : parts_(std::move(parts)) {}

  /// Planes half of the spacing above the lowest point, and so on.
  ContourStack contours(double spacing) const;
  /// Truth by the meshes' sections, topology counted on a grid. The tooth must outlive it.
  Truth truth() const;

 private:
  std::vector<double> heights(double spacing) const;
  ContourStack cut(const std::vector<double>& heights) const;
  Raster raster(double step) const;
  std::vector<Topology> count(double step) const;

  std::vector<Part> parts_;
};

/// The incisor's meshes in a folder; nothing if they are not there.
std::optional<RealTooth> incisor_meshes(const std::string& folder);

}  // namespace odontoscope::test
