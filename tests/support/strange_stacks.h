#pragma once
// Stacks that a malicious tester would send: valid, and as awkward as a name in `strange_kinds` says. A seed means the
// same stack on every machine; the kind is the seed's remainder by the number of kinds.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/input/links.h"

namespace odontoscope::test {

enum class StrangeSize {
  cheap,  // some tens of points: thousands can be judged in a minute
  any,    // mostly below 200 points, now and then up to 2,000
  large,  // as near to 2,000 points as the kind allows, and never more
};
inline constexpr std::size_t largest_strange_stack = 2000;

struct StrangeStack {
  ContourStack stack;       // slices by ascending z
  std::vector<Link> links;  // for one in four: forced and forbidden pairs at random, no pair twice
  std::string kind;
  int thrown_away = 0;  // drafts that broke a rule of contour_stack.h
};

std::size_t points_of(const ContourStack& stack);

StrangeStack strange_stack(std::uint64_t seed, StrangeSize size);

/// In the order of the seeds.
const std::vector<std::string>& strange_kinds();

}  // namespace odontoscope::test
