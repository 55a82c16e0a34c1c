#include "engine/app/shown_values.h"

#include <fmt/format.h>

#include <glm/common.hpp>
#include <limits>

#include "engine/app/tell_volume.h"
#include "recon/core/error.h"
#include "recon/volume/thresholds.h"

namespace odontoscope::app {

Box bounds_of(const ContourStack& stack) {
  Box bounds{glm::dvec3(std::numeric_limits<double>::max()), glm::dvec3(std::numeric_limits<double>::lowest())};
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours)
      for (const Point2& point : contour.points) {
        bounds.low = glm::min(bounds.low, glm::dvec3(point.x, point.y, slice.z));
        bounds.high = glm::max(bounds.high, glm::dvec3(point.x, point.y, slice.z));
      }
  return bounds;
}

Box bounds_of_dense(const Volume& volume, const GreyAnchors& greys) {
  const auto half_way = static_cast<float>(0.5 * (greys.air + greys.dentine));
  Box bounds{glm::dvec3(std::numeric_limits<double>::max()), glm::dvec3(std::numeric_limits<double>::lowest())};
  const glm::dvec3 origin(volume.origin.x, volume.origin.y, volume.origin.z), spacing(volume.spacing[0], volume.spacing[1], volume.spacing[2]);
  for (std::size_t k = 0; k < volume.size[2]; ++k)
    for (std::size_t j = 0; j < volume.size[1]; ++j)
      for (std::size_t i = 0; i < volume.size[0]; ++i) {
        if (volume.slice(k)[j * volume.size[0] + i] < half_way) continue;
        const glm::dvec3 place = origin + glm::dvec3(i, j, k) * spacing;
        bounds.low = glm::min(bounds.low, place - 0.5 * spacing);
        bounds.high = glm::max(bounds.high, place + 0.5 * spacing);
      }
  return bounds;
}

Box with_margin(const Box& bounds, const Volume& volume) {
  constexpr double voxels = 3, share = 0.04;
  const glm::dvec3 spacing(volume.spacing[0], volume.spacing[1], volume.spacing[2]);
  const glm::dvec3 margin = voxels * spacing + share * (bounds.high - bounds.low);
  return {bounds.low - margin, bounds.high + margin};
}

SurfaceMesh box_surface(const Box& box) {
  SurfaceMesh mesh;
  for (unsigned i = 0; i < 8; ++i) mesh.points.push_back({i & 1u ? box.high.x : box.low.x, i & 2u ? box.high.y : box.low.y, i & 4u ? box.high.z : box.low.z});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

VoxelsAlone voxels_alone(const Volume& volume, const ValueGridLimits& limits) {
  const GreyAnchors greys = grey_anchors(volume);
  const Box dense = bounds_of_dense(volume, greys);
  return {greys, dense, std::make_shared<const ValueGrid>(value_grid(volume, with_margin(dense, volume), limits))};
}

VoxelsAlone voxels_alone(const std::string& file, const VolumeWords& words, const ValueGridLimits& limits, Session& session) {
  const VolumeRequest request = understood(words);
  if (request.reshape.upright || request.reshape.resample) throw UsageError("--upright and --resample need a surface", "Say with --iso where it lies.");
  Volume volume = read_volume(file, request.read, session.progress());
  tell_volume(file, volume, session.console);
  crop_told(volume, request.reshape, session.console);
  if (looks_like_labels(volume)) throw UsageError(fmt::format("{} looks like a label map, whose values are no grey", file), "Say with --label N what is solid");
  return voxels_alone(volume, limits);
}

}  // namespace odontoscope::app
