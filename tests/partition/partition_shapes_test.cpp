// Named, awkward stacks of several structures, each of them a failure once.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "recon/partition/reconstruct_partition.h"
#include "tests/partition/partition_oracle.h"
#include "tests/partition/partition_run.h"

namespace odontoscope::test {
namespace {

using Ring = std::vector<Point2>;

Ring box(Point2 low, Point2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

Ring polygon(int corners, double radius, Point2 centre = {}) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners;
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return ring;
}

struct Named {
  std::string structure;
  Ring ring;
};

ContourStack stack_of(const std::vector<std::vector<Named>>& slices) {
  ContourStack stack;
  for (const auto& slice : slices) {
    stack.slices.push_back({0.5 * double(stack.slices.size()), {}});
    for (const Named& named : slice) stack.slices.back().contours.push_back({named.structure, named.ring});
  }
  return stack;
}

ContourStack identical_structures() {
  return stack_of({{{"a", polygon(9, 2)}, {"b", polygon(9, 2)}},
                   {{"b", polygon(9, 2)}},
                   {{"a", polygon(9, 1)}, {"b", polygon(9, 1)}}});
}

/// One bar a millionth wide over another.
ContourStack crossing_bars() {
  return stack_of({{}, {{"a", box({-3, 0}, {3, 1e-6})}, {"b", box({0, -3}, {1e-6, 3})}}, {{"a", polygon(5, 1)}}});
}

/// Two needles that cross, 2e-8 and 1e-9 wide.
ContourStack crossing_needles() {
  return stack_of({{},
                   {{"b",
                     {{-0.09552634054010412, 3.068756463457106},
                      {-1.188592243723491, -2.83083733029666},
                      {-0.09552633955684087, 3.068756463274937}}},
                    {"a", {{-3.0, 0.30655750488379385}, {3.0, 0.30655751488379385}, {-3.0, 0.30655752488379384}}}}});
}

struct NamedPartition {
  const char* name;
  std::function<ContourStack()> make;
};

const std::vector<NamedPartition>& shapes() {
  static const std::vector<NamedPartition> all{{"identical structures", identical_structures},
                                               {"crossing bars", crossing_bars},
                                               {"crossing needles", crossing_needles}};
  return all;
}

TEST(PartitionShapes, AreCertified) {
  for (const NamedPartition& shape : shapes()) {
    PartitionCase given{.stack = shape.make(), .priority = {"a", "b"}, .kind = shape.name};
    given.delaunay = true;
    const PartitionOutcome outcome = outcome_of(given);
    EXPECT_EQ(outcome.end, PartitionEnd::certified) << shape.name << ": " << outcome.message;
  }
}

/// Two triangles half a millimetre apart beside a bay that is a quarter deep: a gap of 0.2337 closes nothing.
TEST(PartitionShapes, KeepsVoidThatIsWiderThanTheGap) {
  PartitionCase given{.stack = stack_of({{{"s1",
                                           {{1.7291414980345765, 1.043549976533498},
                                            {2.6931942153396182, 1.063483070183639},
                                            {2.284740144095755, 2.1893277721726547}}},
                                          {"s4",
                                           {{1.206392513536783, 0.664306802960046},
                                            {1.3461336774062342, 2.20039403585575},
                                            {0.09744848554618224, 1.7786410287786}}}},
                                         {}}),
                      .priority = {"s4", "s1"},
                      .kind = "bay"};
  given.gap = 0.233674;
  given.delaunay = true;
  EXPECT_EQ(outcome_of(given).message, "");
}

/// Where nothing is named, what lies within wins.
TEST(PartitionShapes, LetTheInnermostWinByDefault) {
  const ContourStack stack =
      stack_of({{{"enamel", polygon(16, 3)}, {"dentine", polygon(12, 2)}, {"pulp", polygon(8, 1)}},
                {{"enamel", polygon(16, 3)}, {"dentine", polygon(12, 2)}, {"pulp", polygon(8, 1)}}});
  const Reconstruction result =
      reconstruct_partition(stack, {.priority = {}, .gap = 0, .between = Between::delaunay, .threads = 1});
  EXPECT_EQ(partition_faults(result, stack, {{"pulp", "dentine", "enamel"}, 0}), std::vector<std::string>{});
}

}  // namespace
}  // namespace odontoscope::test
