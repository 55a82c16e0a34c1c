#pragma once
// Sample teeth that several tests look at, each made once.

#include <map>
#include <optional>
#include <utility>

#include "recon/sample/sample_tooth.h"

namespace odontoscope::test {

inline const ContourStack& made_once(ToothKind kind, std::optional<double> slice_spacing = {}) {
  static std::map<std::pair<ToothKind, double>, ContourStack> known;
  const auto [made, fresh] = known.try_emplace({kind, slice_spacing.value_or(0)});
  if (fresh) made->second = sample_tooth(kind, {.slice_spacing = slice_spacing});
  return made->second;
}

}  // namespace odontoscope::test
