#pragma once
// What a person looks at to say where in a volume the surface lies: its slices, its grey values, the labels in it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <set>
#include <string>
#include <vector>

#include "engine/scene/value_grid.h"
#include "recon/volume/read_volume.h"

namespace odontoscope {

struct VolumePreview {
  struct Label {
    std::int64_t value = 0;
    std::string name;        // of the file; may be empty
    std::size_t voxels = 0;  // of those that were looked at
  };

  ValueGrid values;                   // all of the volume, coarser where it is large
  std::array<std::size_t, 3> size{};  // of the volume itself
  std::array<double, 3> spacing_mm{};
  /// Bars over equal ranges of grey from `low` to `high`: their heights, 0 to 1, by the logarithm of their voxels
  /// (enamel is seldom next to air).
  std::vector<float> bars;
  double low = 0, high = 1;
  std::vector<double>
      thresholds;             // Otsu's between two classes, then those between three; empty where all values are equal
  std::vector<Label> labels;  // ascending, without 0; empty: grey values
  /// Of several DICOM series one is to be chosen first, and nothing else is known yet; empty: there is one.
  std::vector<SeriesOffer> series;
};

/// So much of a file is enough for it: of a large one every so many-th voxel, which keeps labels labels and takes
/// little memory.
inline constexpr VolumePart previewed_part{
    .whole_up_to = 32u << 20, .most_voxels = 16u << 20, .sampled = true, .within = {}};

/// Precondition: `volume` passes validate_volume; it may be a part as above.
VolumePreview volume_preview(const Volume& volume);

/// One of the grid's slices, seen from +z: rows from the top, y upwards.
struct SlicePicture {
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> grey;
};
SlicePicture slice_picture(const ValueGrid& values, std::size_t k, const ValueWindow& window);

/// Where the slice passes a grey value, in pixels of that picture: pieces of the outline, in no order. Values lie in
/// the pixels' centres.
std::vector<std::array<glm::dvec2, 2>> slice_outline(const ValueGrid& values, std::size_t k, double iso);

/// The same around each of these labels. Nothing where blocks of a large volume became their mean, which is no label.
std::vector<std::array<glm::dvec2, 2>> label_outline(const ValueGrid& values, std::size_t k,
                                                     const std::set<std::int64_t>& labels);

/// The slice in which most lies at `iso` or above it, of equal ones that nearest the middle: a good one to begin with.
std::size_t fullest_slice(const ValueGrid& values, double iso);

}  // namespace odontoscope
