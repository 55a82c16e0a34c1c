// Label maps of noise and of noisy teeth, made into contours as the program does.

#include <algorithm>
#include <cmath>
#include <set>

#include "recon/volume/label_contours.h"
#include "tests/support/strange_parts.h"

namespace odontoscope::test {
namespace {

constexpr double spacings[] = {0.1, 0.2, 0.15, 0.075, 0.3, 0.05, 0.5, 0.25, 1.0, 0.125};
constexpr double origins[] = {0.0, -13.3, 0.7, 101.45, -0.1, 12.8};

Volume grid(RandomNumbers& random, int width, int height, int depth) {
  Volume volume;
  volume.size = {std::size_t(width), std::size_t(height), std::size_t(depth)};
  const double spacing = one_of(random, spacings);
  volume.spacing = {spacing, random.chance(0.8) ? spacing : one_of(random, spacings),
                    random.chance(0.7) ? spacing : one_of(random, spacings)};
  volume.origin = {one_of(random, origins), one_of(random, origins), one_of(random, origins)};
  volume.values.assign(volume.size[0] * volume.size[1] * volume.size[2], 0);
  return volume;
}

ContourStack contours_of(const Volume& volume) {
  const std::set<float> there(volume.values.begin(), volume.values.end());
  std::vector<LabelLevel> levels;
  for (float label : there)
    if (label != 0) levels.push_back({std::int64_t(label), "label-" + std::to_string(int(label))});
  if (levels.empty()) return {};
  try {
    return label_contours(volume, levels).stack;
  } catch (const InputError&) {  // all contours in one slice
    return {};
  }
}

/// Two to four labels and void, drawn for each pixel, or smoothed by the vote of its neighbours.
ContourStack label_noise(RandomNumbers& random, int points) {
  const int side = std::clamp(int(std::sqrt(points / 6.0)), 3, 18), depth = random.whole(2, 4),
            labels = random.whole(2, 4);
  Volume volume = grid(random, side, side, depth);
  const bool with_void = random.chance(0.7);
  for (float& value : volume.values) value = float(random.below(labels + with_void) + !with_void);
  if (random.chance(0.5)) {
    const std::vector<float> before = volume.values;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const std::size_t next = i + 1 < before.size() ? i + 1 : i, across = i >= volume.size[0] ? i - volume.size[0] : i;
      if (before[next] == before[across]) volume.values[i] = before[next];
    }
  }
  return contours_of(volume);
}

/// One label of noise, from nearly empty to nearly full.
ContourStack speckles(RandomNumbers& random, int points) {
  const int side = std::clamp(int(std::sqrt(points / 3.0)), 4, 30);
  Volume volume = grid(random, side, side, random.whole(2, 4));
  const double share = random.between(0.1, 0.9);
  for (float& value : volume.values) value = random.chance(share) ? 1 : 0;
  return contours_of(volume);
}

/// Enamel, dentine and pulp of a tooth that leans, with noise at the borders between them.
ContourStack noisy_tooth(RandomNumbers& random, int points) {
  const int side = std::clamp(int(points / 12.0), 8, 40), depth = random.whole(3, 6);
  Volume volume = grid(random, side, side, depth);
  const double lean_x = random.between(-0.6, 0.6), lean_y = random.between(-0.6, 0.6), noise = random.between(0, 0.35),
               narrow = random.between(0.02, 0.15);
  for (int k = 0; k < depth; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const double x = (i - side / 2.0 - lean_x * k) / side, y = (j - side / 2.0 - lean_y * k) / side;
        const double r = std::sqrt(x * x + 1.4 * y * y) + noise * random.between(-0.15, 0.15);
        const bool pulp = r < 0.16 - narrow * k / depth, dentine = r < 0.3, enamel = r < 0.42 - 0.05 * k;
        volume.values[std::size_t((k * side + j) * side + i)] = pulp ? 3 : dentine ? 2 : enamel ? 1 : 0;
      }
  return contours_of(volume);
}

/// A board in all three directions, of one label and void, or of two to four labels, fields one or two voxels wide:
/// every corner is a crossing.
ContourStack label_boards(RandomNumbers& random, int points) {
  const int wide = random.whole(1, 2), side = std::clamp(int(std::sqrt(points / 6.0)) * wide, 3, 30),
            depth = random.whole(2, 4), labels = random.whole(1, 4);
  Volume volume = grid(random, side, side, depth);
  const bool whole_columns = random.chance(0.3), with_void = labels == 1 || random.chance(0.5);
  for (int k = 0; k < depth; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const int field = i / wide + j / wide + (whole_columns ? 0 : k);
        volume.values[std::size_t((k * side + j) * side + i)] = float(field % (labels + with_void) + !with_void);
      }
  if (random.chance(0.3)) volume.values[std::size_t(random.below(int(volume.values.size())))] = 1;
  return contours_of(volume);
}

}  // namespace

const std::vector<NamedMaker>& label_makers() {
  static const std::vector<NamedMaker> makers{{"label-noise", label_noise},
                                              {"speckles", speckles},
                                              {"noisy-tooth", noisy_tooth},
                                              {"label-boards", label_boards}};
  return makers;
}

}  // namespace odontoscope::test
