#include "tooth_cuts.h"

#include <cmath>
#include <utility>

#include "recon/contours/simplify_contours.h"
#include "recon/core/limits.h"
#include "recon/input/validate.h"
#include "recon/sample/field_loops.h"
#include "recon/volume/volume_contours.h"

namespace odontoscope::test {
namespace {

/// Height of slice number `i`; the family's teeth begin anywhere within a slab.
double height_of(const TurnedTooth& tooth, double spacing, std::size_t i) {
  return tooth.lowest() + (static_cast<double>(i) + tooth.tooth().first_slice) * spacing;
}

}  // namespace

ContourStack contours_of(const TurnedTooth& tooth, double spacing, const Fineness& fineness) {
  const Raster raster = tooth.raster(fineness.step);
  sample::Grid grid{
      {raster.x0, raster.y0}, raster.step, raster.columns, raster.rows, std::vector<double>(raster.size())};
  ContourStack stack;
  stack.source = "tooth " + std::to_string(tooth.tooth().seed);
  for (std::size_t i = 0; height_of(tooth, spacing, i) < tooth.highest(); ++i) {
    Slice slice{height_of(tooth, spacing, i), {}};
    const std::vector<Values> values = tooth.plane(raster, slice.z);
    for (std::size_t s = 0; s < structure_count; ++s) {
      for (std::size_t p = 0; p < values.size(); ++p) grid.values[p] = values[p][s];
      for (Polygon& loop : sample::trace(grid, fineness.step * fineness.step))
        slice.contours.push_back({structure_names[s], std::move(loop)});
    }
    if (!slice.contours.empty()) stack.slices.push_back(std::move(slice));
  }
  return simplify_contours(stack, {fineness.deviation}).stack;
}

VoxelSize voxel_size(const RandomTooth& tooth, double spacing) {
  constexpr double dyadic_grain = 0.0625;
  if (tooth.seed % 2 == 0)
    return {tooth.seed % 4 == 0 ? dyadic_grain : 2 * dyadic_grain, std::round(spacing / dyadic_grain) * dyadic_grain};
  return {tooth.seed % 4 == 1 ? 0.1 : 0.15, spacing};
}

Volume label_map(const TurnedTooth& tooth, const VoxelSize& voxel) {
  Raster raster = tooth.raster(voxel.in_plane);
  // Origins of real volumes are as round as their voxels.
  raster.x0 = std::floor(raster.x0 / voxel.in_plane) * voxel.in_plane;
  raster.y0 = std::floor(raster.y0 / voxel.in_plane) * voxel.in_plane;
  Volume volume;
  volume.spacing = {voxel.in_plane, voxel.in_plane, voxel.along_z};
  volume.origin = {raster.x0, raster.y0, std::floor(tooth.lowest() / voxel.along_z) * voxel.along_z};
  volume.size = {raster.columns, raster.rows,
                 static_cast<std::size_t>(std::ceil((tooth.highest() - volume.origin.z) / voxel.along_z)) + 1};
  volume.values.reserve(volume.size[0] * volume.size[1] * volume.size[2]);
  for (std::size_t k = 0; k < volume.size[2]; ++k) {
    for (const Values& at : tooth.plane(raster, volume.origin.z + static_cast<double>(k) * voxel.along_z)) {
      // The gap that parts structures is shared out, so that labels border on each other as in any segmentation.
      const double half_gap = limits::sample_gap / 2;
      volume.values.push_back(at[2] < half_gap ? 3.0F : at[1] < half_gap ? 2.0F : at[0] < 0 ? 1.0F : 0.0F);
    }
  }
  return volume;
}

ContourStack label_map_contours(const TurnedTooth& tooth, double spacing, std::optional<double> smooth,
                                std::optional<double> simplify) {
  const Volume volume = label_map(tooth, voxel_size(tooth.tooth(), spacing));
  VolumeContourOptions options;
  options.labels = {{1, "enamel"}, {2, "dentine"}, {3, "pulp"}};
  if (smooth) options.smooth = SmoothLabelsOptions{*smooth};
  if (simplify) options.simplify = SimplifyContoursOptions{*simplify};
  return contours_of_volume(volume, options).stack;
}

}  // namespace odontoscope::test
