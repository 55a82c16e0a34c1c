// Strange stacks of one structure, their contours given to several; and two of them laid over each other.

#include <algorithm>

#include "tests/partition/partition_stacks.h"
#include "tests/support/strange_parts.h"
#include "tests/support/strange_stacks.h"

namespace odontoscope::test {
namespace {

ContourStack strange(RandomNumbers& random, int points) {
  const std::vector<NamedMaker>* rooms[] = {&outline_makers(), &number_makers(), &crowd_makers(),  &attack_makers(),
                                            &ploy_makers(),    &trifle_makers(), &assault_makers()};
  const auto& makers = *one_of(random, rooms);
  return makers[std::size_t(random.below(int(makers.size())))].make(random, std::max(12, points));
}

/// Contours of one strange stack dealt out.
ContourStack dealt(RandomNumbers& random, int points) {
  ContourStack stack = strange(random, points);
  const int labels = random.whole(2, 5);
  for (Slice& slice : stack.slices)
    for (Contour& contour : slice.contours) contour.structure = structure_name(random.whole(1, labels));
  return stack;
}

/// A structure each, slice over slice.
ContourStack laid_over(RandomNumbers& random, int points) {
  const int labels = random.whole(2, 3);
  ContourStack all;
  for (int label = 1; label <= labels; ++label) {
    ContourStack stack = strange(random, points / labels);
    for (std::size_t k = 0; k < stack.slices.size(); ++k) {
      if (k == all.slices.size()) {
        all.slices.push_back({stack.slices[k].z, {}});
        if (k > 0 && all.slices[k].z <= all.slices[k - 1].z) all.slices[k].z = all.slices[k - 1].z + 0.5;
      }
      for (Contour& contour : stack.slices[k].contours) {
        contour.structure = structure_name(label);
        all.slices[k].contours.push_back(contour);
      }
    }
  }
  return all;
}

template <std::size_t index>
ContourStack labels(RandomNumbers& random, int points) {
  ContourStack stack = label_makers()[index].make(random, points);
  for (Slice& slice : stack.slices)
    for (Contour& contour : slice.contours)
      if (contour.structure.starts_with("label-")) contour.structure = "s" + contour.structure.substr(6);
  return stack;
}

}  // namespace

const std::vector<NamedPartitionMaker>& mixed_makers() {
  static const std::vector<NamedPartitionMaker> makers{{"dealt", dealt},
                                                       {"laid-over", laid_over},
                                                       {"label-noise", labels<0>},
                                                       {"noisy-tooth", labels<2>},
                                                       {"label-boards", labels<3>}};
  return makers;
}

}  // namespace odontoscope::test
