#pragma once
// Lists of things by what they belong to, in two arrays.

#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "recon/core/index.h"

namespace odontoscope {

/// The `Thing`s of each group `I`, in the order in which they were told.
template <class I, class Thing>
class IndexGroups {
 public:
  IndexGroups() = default;
  /// `tell(add)` calls add(group, thing) for each; it is called twice, and must do the same both times.
  template <class Tell>
  IndexGroups(std::size_t groups, const Tell& tell) : first_(groups + 1, 0) {
    tell([this](I group, const Thing&) { ++first_[I(group + 1)]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    things_.resize(first_.back());
    Table<I, std::uint32_t> fill(first_.begin(), first_.end() - 1);
    tell([&](I group, const Thing& thing) { things_[fill[group]++] = thing; });
  }

  std::span<const Thing> operator[](I group) const {
    return {things_.begin() + first_[group], things_.begin() + first_[I(group + 1)]};
  }

 private:
  Table<I, std::uint32_t> first_;  // of group g: things_[first_[g]] to things_[first_[g + 1]]
  std::vector<Thing> things_;
};

}  // namespace odontoscope
