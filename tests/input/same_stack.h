#pragma once
// Two contour stacks, bit by bit.

#include <gtest/gtest.h>

#include "recon/input/contour_stack.h"

namespace odontoscope::test {

inline void expect_same_slices(const ContourStack& again, const ContourStack& stack) {
  ASSERT_EQ(again.slices.size(), stack.slices.size());
  for (std::size_t s = 0; s < stack.slices.size(); ++s) {
    EXPECT_EQ(again.slices[s].z, stack.slices[s].z);
    ASSERT_EQ(again.slices[s].contours.size(), stack.slices[s].contours.size());
    for (std::size_t c = 0; c < stack.slices[s].contours.size(); ++c) {
      EXPECT_EQ(again.slices[s].contours[c].structure, stack.slices[s].contours[c].structure);
      EXPECT_EQ(again.slices[s].contours[c].points, stack.slices[s].contours[c].points);
    }
  }
}

}  // namespace odontoscope::test
