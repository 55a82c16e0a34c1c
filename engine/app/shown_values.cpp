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
  const glm::dvec3 origin(volume.origin.x, volume.origin.y, volume.origin.z),
      spacing(volume.spacing[0], volume.spacing[1], volume.spacing[2]);
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
  for (unsigned i = 0; i < 8; ++i)
    mesh.points.push_back(
        {i & 1u ? box.high.x : box.low.x, i & 2u ? box.high.y : box.low.y, i & 4u ? box.high.z : box.low.z});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

VoxelsAlone voxels_alone(const Volume& volume, const ValueGridLimits& limits) {
  const GreyAnchors greys = grey_anchors(volume);
  const Box dense = bounds_of_dense(volume, greys);
  return {greys, dense, std::make_shared<const ValueGrid>(value_grid(volume, with_margin(dense, volume), limits))};
}

namespace {

/// Of a file of which `samples` were looked at: what is dense in them, read again and finer.
VoxelsAlone voxels_around(const std::string& file, const Volume& samples, ReadVolumeOptions read,
                          const ValueGridLimits& limits, Session& session) {
  const GreyAnchors greys = grey_anchors(samples);
  const Box dense = bounds_of_dense(samples, greys), wanted = with_margin(dense, samples);
  VolumeBounds within;
  const std::array<double, 3> origin{samples.origin.x, samples.origin.y, samples.origin.z};
  for (int axis = 0; axis < 3; ++axis) {  // not beyond what was cropped
    const auto n = static_cast<std::size_t>(axis);
    within.low[n] = std::max(wanted.low[axis], origin[n]);
    within.high[n] =
        std::min(wanted.high[axis], origin[n] + static_cast<double>(samples.size[n] - 1) * samples.spacing[n]);
  }
  read.part = VolumePart{.most_voxels = limits.most_values, .within = within};
  return {greys, dense,
          std::make_shared<const ValueGrid>(value_grid(read_volume(file, read, session.progress()), wanted, limits))};
}

}  // namespace

VoxelsAlone voxels_alone(const std::string& file, const VolumeWords& words, const ValueGridLimits& limits,
                         Session& session) {
  const VolumeRequest request = understood(words);
  if (request.reshape.upright || request.reshape.resample)
    throw UsageError("--upright and --resample need a surface", "Say with --iso where it lies.");
  ReadVolumeOptions read = request.read;
  constexpr std::size_t enough_to_look_at = 16u << 20;
  read.part =
      VolumePart{.whole_up_to = ValueGridLimits{}.most_values, .most_voxels = enough_to_look_at, .sampled = true};
  Volume volume = read_volume(file, read, session.progress());
  tell_volume(file, volume, session.console);
  crop_told(volume, request.reshape, session.console);
  if (looks_like_labels(volume))
    throw UsageError(fmt::format("{} looks like a label map, whose values are no grey", file),
                     "Say with --label N what is solid");
  if (volume.merged == std::array<std::size_t, 3>{1, 1, 1}) return voxels_alone(volume, limits);
  session.console.say("  It is too large to be held whole; what lies around the tooth is read now.");
  return voxels_around(file, volume, std::move(read), limits, session);
}

}  // namespace odontoscope::app
