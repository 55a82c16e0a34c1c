#include "recon/volume/read_part.h"

#include <algorithm>

namespace odontoscope {
namespace {

using Counts = std::array<std::size_t, 3>;

/// Along the file's own axes.
struct Blocks {
  Counts first{}, count{}, merged{1, 1, 1};
  bool sampled = false;

  /// Divided, rounded up.
  std::size_t kept(std::size_t axis) const { return (count[axis] + merged[axis] - 1) / merged[axis]; }
  std::size_t kept_in_all() const { return kept(0) * kept(1) * kept(2); }
  /// Voxels of the nth block along an axis that count.
  std::size_t voxels(std::size_t axis, std::size_t n) const {
    return sampled ? 1 : std::min(merged[axis], count[axis] - n * merged[axis]);
  }
};

Blocks blocks_of(const FileImage& image, const VolumePart& part) {
  Blocks blocks;
  blocks.sampled = part.sampled;
  const auto ranges = part.within
                          ? index_ranges(image, *part.within)
                          : std::array<IndexRange, 3>{{{0, image.size[0]}, {0, image.size[1]}, {0, image.size[2]}}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    blocks.first[axis] = ranges[axis].first;
    blocks.count[axis] = ranges[axis].count;
  }
  while (blocks.kept_in_all() > std::max<std::size_t>(part.most_voxels, 8)) {
    std::size_t finest = 3;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool finer = finest == 3 || image.spacing[axis] * static_cast<double>(blocks.merged[axis]) <
                                            image.spacing[finest] * static_cast<double>(blocks.merged[finest]);
      if (blocks.kept(axis) > 2 && finer) finest = axis;
    }
    if (finest == 3) break;
    ++blocks.merged[finest];
  }
  return blocks;
}

/// Takes voxels in the file's order and makes blocks of them.
class Gathering {
 public:
  Gathering(const Counts& size, const Blocks& blocks)
      : size_(size), blocks_(blocks), sums_(blocks.kept(0) * blocks.kept(1), 0) {
    values_.reserve(blocks.kept_in_all());
  }

  void take(const float* values, std::size_t count) {
    while (count > 0) {
      const std::size_t some = std::min(count, size_[0] - at_[0]);
      take_of_row(values, some);
      values += some;
      count -= some;
      at_[0] += some;
      for (std::size_t axis = 0; axis < 2 && at_[axis] == size_[axis]; ++axis) {
        at_[axis] = 0;
        ++at_[axis + 1];
        if (axis == 1) end_of_slice(at_[2] - 1);
      }
    }
  }
  std::vector<float> values() && { return std::move(values_); }

 private:
  bool wanted(std::size_t axis) const {
    const std::size_t off = at_[axis] - blocks_.first[axis];  // below 0 it is beyond the count
    return off < blocks_.count[axis] && (!blocks_.sampled || off % blocks_.merged[axis] == 0);
  }
  void take_of_row(const float* values, std::size_t count) {
    if (!wanted(1) || !wanted(2)) return;
    double* row = sums_.data() + (at_[1] - blocks_.first[1]) / blocks_.merged[1] * blocks_.kept(0);
    const std::size_t first = blocks_.first[0], end = first + blocks_.count[0], step = blocks_.merged[0];
    for (std::size_t i = std::max(at_[0], first); i < std::min(at_[0] + count, end); ++i)
      if (!blocks_.sampled || (i - first) % step == 0)
        row[(i - first) / step] += static_cast<double>(values[i - at_[0]]);
  }
  void end_of_slice(std::size_t slice) {
    const std::size_t off = slice - blocks_.first[2];
    if (off >= blocks_.count[2]) return;
    const std::size_t layer = off / blocks_.merged[2];
    if (off + 1 < std::min((layer + 1) * blocks_.merged[2], blocks_.count[2]))
      return;  // its last slice is still to come
    for (std::size_t j = 0; j < blocks_.kept(1); ++j)
      for (std::size_t i = 0; i < blocks_.kept(0); ++i) {
        double& sum = sums_[j * blocks_.kept(0) + i];
        values_.push_back(static_cast<float>(
            sum / static_cast<double>(blocks_.voxels(0, i) * blocks_.voxels(1, j) * blocks_.voxels(2, layer))));
        sum = 0;
      }
  }

  Counts size_, at_{};
  Blocks blocks_;
  std::vector<double> sums_;
  std::vector<float> values_;
};

}  // namespace

FileImage read_part(FileImage image, const PixelFiles& files, const VolumePart& part, const Progress& progress) {
  const Blocks blocks = blocks_of(image, part);
  Gathering gathering(image.size, blocks);
  for_each_run(files, image.size[0] * image.size[1] * image.size[2], progress,
               [&](const float* values, std::size_t count) { gathering.take(values, count); });
  image.values = std::move(gathering).values();
  for (std::size_t n = 0; n < 3; ++n) {
    const double middle = blocks.sampled ? 0 : 0.5 * static_cast<double>(blocks.merged[n] - 1),
                 off = (static_cast<double>(blocks.first[n]) + middle) * image.spacing[n];
    for (std::size_t x = 0; x < 3; ++x) image.origin[x] += off * image.direction[n][x];
  }
  for (std::size_t n = 0; n < 3; ++n) {
    image.size_before[n] = blocks.count[n];
    image.size[n] = blocks.kept(n);
    image.spacing[n] *= static_cast<double>(blocks.merged[n]);
    image.merged[n] = blocks.merged[n];
  }
  return image;
}

}  // namespace odontoscope
