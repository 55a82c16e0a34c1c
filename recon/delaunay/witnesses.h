#pragma once
// Witnesses of links, gathered tetrahedron by tetrahedron: of each pair the strictest criterion counts.

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "recon/delaunay/correspond.h"

namespace odontoscope::delaunay {

class Witnesses {
 public:
  void add(std::uint32_t lower, std::uint32_t upper, LinkCriterion criterion) {
    const std::pair key{lower, upper};
    if (!last_ || last_->first != key) last_ = &*strictest_.emplace(key, criterion).first;
    last_->second = std::min(last_->second, criterion);
  }

  /// By criterion, then by pair.
  std::vector<RegionLink> links() const {
    std::vector<RegionLink> found;
    for (const auto& [pair, criterion] : strictest_) found.push_back({pair.first, pair.second, criterion});
    std::stable_sort(found.begin(), found.end(),
                     [](const RegionLink& a, const RegionLink& b) { return a.criterion < b.criterion; });
    return found;
  }

 private:
  using Map = std::map<std::pair<std::uint32_t, std::uint32_t>, LinkCriterion>;
  Map strictest_;
  Map::value_type* last_ = nullptr;  // witnesses of one pair come in long runs
};

}  // namespace odontoscope::delaunay
