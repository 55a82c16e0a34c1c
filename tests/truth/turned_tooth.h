#pragma once
// A tooth of the family as it lies in the image: values of its structures at any place of a plane or of a grid in
// space.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "plane_raster.h"
#include "random_tooth.h"
#include "recon/distance/grid.h"
#include "voxel_topology.h"

namespace odontoscope::test {

inline constexpr std::array<const char*, 3> structure_names{"enamel", "dentine", "pulp"};
inline constexpr std::size_t structure_count = structure_names.size();

/// Of each structure: negative inside, near its surface about the distance, mm. The dentine is hollow; a gap of
/// limits::sample_gap parts neighbours; the pulp ends at the root's surface where an apex or an accessory canal is
/// open.
using Values = std::array<double, structure_count>;

struct Box {
  Point3 low, high;
};

class TurnedTooth {
 public:
  explicit TurnedTooth(RandomTooth tooth);

  const RandomTooth& tooth() const { return tooth_; }

  /// Points `step` apart that cover the tooth's section by any plane of constant z, with a margin.
  Raster raster(double step) const;
  double lowest() const { return image_box_.low.z; }
  double highest() const { return image_box_.high.z; }

  /// Values at all points of a plane. Far from every surface a point holds the values of one nearby, which are on the
  /// same side (see `far_from_surfaces`).
  std::vector<Values> plane(const Raster& raster, double z) const;
  /// Neighbours are parted by a gap (limits::sample_gap), share their walls, or are filled, so that each overlaps those
  /// within it.
  enum class Walls { apart, shared, filled };
  void choose(Walls walls) { walls_ = walls; }
  /// The same as bits: bit s where structure s is.
  Mask mask(const Raster& raster, double z) const;

  /// A grid around the tooth in axes of its own, stretched but not turned: the same shape and the same topology.
  Grid own_grid(double step) const;
  /// Bit s where structure s is.
  Voxels own_voxels(const Grid& grid) const;
  /// Values of every structure at all points of the grid.
  std::array<std::vector<double>, structure_count> own_values(const Grid& grid) const;
  /// From those axes to the image's.
  Point3 to_image(const Point3& own) const;

  /// From now on asks every point: to check what is otherwise skipped.
  void ask_everywhere() { skip_ = false; }

 private:
  class Line;
  template <class Take>
  void sweep(const Grid& grid, const Take& take) const;

  bool far_from_surfaces(const Values& values, double reach, double z, double z_reach) const;
  Point3 to_own(const Point3& image) const;
  void find_boxes();

  RandomTooth tooth_;
  double least_stretch_ = 1;
  double crown_z_ = 0;                            // below it the occlusal surface need not be asked for
  std::vector<std::pair<double, double>> steep_;  // heights of the unstretched tooth where values change fast along z
  Box own_box_, image_box_;
  bool skip_ = true;
  Walls walls_ = Walls::apart;
};

}  // namespace odontoscope::test
