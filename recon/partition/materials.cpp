#include "recon/partition/materials.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/core/error.h"
#include "recon/input/validate.h"
#include "recon/partition/inner_first.h"
#include "recon/partition/limits.h"

namespace odontoscope::partition {

Materials materials_of(const ContourStack& stack, const std::vector<std::string>& priority, double gap) {
  Materials materials;
  materials.structures = structures_of(stack);
  materials.gap = gap;
  const std::size_t count = materials.structures.size();
  Place place;
  place.file = stack.source;
  if (count > limits::most_structures)
    throw InputError(
        "too-many-structures", place,
        fmt::format("a partition of {} structures; at most {} are supported", count, limits::most_structures),
        "Leave some out, or reconstruct them independently");
  for (const std::string& name : priority)
    if (std::find(materials.structures.begin(), materials.structures.end(), name) == materials.structures.end())
      throw InputError("unknown-structure", place, fmt::format("no structure is called \"{}\"", name),
                       fmt::format("The structures are: {}", fmt::join(materials.structures, ", ")));
  std::vector<std::uint32_t> order = inner_first(stack, materials.structures);
  const auto named = [&](std::uint32_t s) {
    return std::find(priority.begin(), priority.end(), materials.structures[s]) - priority.begin();
  };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return named(a) < named(b); });
  materials.rank.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) materials.rank[order[i]] = i;
  return materials;
}

}  // namespace odontoscope::partition
