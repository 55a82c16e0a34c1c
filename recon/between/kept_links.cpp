#include "recon/between/kept_links.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "recon/between/level_regions.h"
#include "recon/between/limits.h"
#include "recon/core/union_find.h"

namespace odontoscope::between {
namespace {

class LinkKeeper {
 public:
  LinkKeeper(LevelStack& stack, const RegionClasses& classes) : stack_(stack), classes_(classes) {}

  void run() {
    for (int round = 0; round < limits::parting_rounds; ++round)
      if (!part()) break;
    for (const bool solid : {false, true}) {
      stack_.find_regions();
      close_loops(solid);
    }
  }

 private:
  // ---- what no given region has, and what would join two classes ---------------------------------------------------

  bool part() {
    const std::vector<std::vector<std::uint32_t>> of = stack_.spread_classes();
    std::vector<std::pair<std::size_t, std::size_t>> wrong;  // slice and point
    for (std::size_t level = 1; level + 1 < stack_.levels(); ++level) {
      const Level& slice = stack_.level(level);
      for (std::size_t point = 0; point < stack_.points(); ++point) {
        if (of[level][point] == no_class) {
          wrong.emplace_back(level, point);
          continue;
        }
        stack_.for_joined(level, point, [&](std::size_t other) {
          if (of[level][other] == no_class || of[level][other] == of[level][point] || !gives_way(slice, point, other))
            return;
          wrong.emplace_back(level, point);
        });
        for (const std::size_t beside : {level - 1, level + 1}) {
          if (stack_.level(beside).solid[point] != slice.solid[point] || of[beside][point] == of[level][point])
            continue;
          if (beside < level || !stack_.interpolated(beside)) wrong.emplace_back(level, point);
        }
      }
    }
    std::sort(wrong.begin(), wrong.end());
    wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
    std::erase_if(wrong, [this](const auto& place) { return stack_.on_border(place.second); });
    for (const auto& [level, point] : wrong) stack_.flip(level, point);
    return !wrong.empty();
  }

  /// Of two neighbours the one that is nearer to what is of the other kind.
  static bool gives_way(const Level& slice, std::size_t point, std::size_t other) {
    const double own = std::abs(slice.values[point]), its = std::abs(slice.values[other]);
    return own != its ? own < its : point < other;
  }

  // ---- regions that are joined both below and above ----------------------------------------------------------------

  /// Of each region of each slice the group of those it is joined with in this slice and those before it, in the order
  /// given.
  std::vector<std::vector<std::uint32_t>> joined_before(bool solid, bool upwards) const {
    std::vector<std::uint32_t> first{0};
    for (std::size_t level = 0; level < stack_.levels(); ++level)
      first.push_back(first.back() + stack_.level(level).regions);
    UnionFind joined(first.back());
    std::vector<std::vector<std::uint32_t>> groups(stack_.levels());
    for (std::size_t n = 0; n < stack_.levels(); ++n) {
      const std::size_t level = upwards ? n : stack_.levels() - 1 - n;
      if (n > 0) {
        const std::size_t before = upwards ? level - 1 : level + 1;
        const Level &here = stack_.level(level), &there = stack_.level(before);
        for (std::size_t point = 0; point < stack_.points(); ++point)
          if (here.solid[point] == solid && there.solid[point] == solid)
            joined.join(first[level] + here.region[point], first[before] + there.region[point]);
      }
      for (std::uint32_t r = 0; r < stack_.level(level).regions; ++r)
        groups[level].push_back(joined.find(first[level] + r));
    }
    return groups;
  }

  void close_loops(bool solid) {
    const auto below = joined_before(solid, true), above = joined_before(solid, false);
    const std::vector<std::vector<std::uint32_t>> of = stack_.spread_classes();
    for (std::size_t level = 1; level + 1 < stack_.levels(); ++level) {
      const Level& slice = stack_.level(level);
      std::vector<std::uint32_t> class_of(slice.regions, no_class);
      for (std::size_t point = 0; point < stack_.points(); ++point)
        if (slice.solid[point] == solid) class_of[slice.region[point]] = of[level][point];
      std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> loops;
      for (std::uint32_t r = 0; r < slice.regions; ++r)
        if (class_of[r] != no_class && !classes_.loop[class_of[r]])
          loops[{below[level][r], above[level][r]}].push_back(r);
      for (const auto& [both, regions] : loops)
        for (std::size_t n = 1; n < regions.size(); ++n) join(level, regions[n], regions, solid);
    }
  }

  /// Opens the shortest passage from a region to another of these of its slice.
  void join(std::size_t level, std::uint32_t region, const std::vector<std::uint32_t>& regions, bool solid) {
    const Level& slice = stack_.level(level);
    std::vector<std::size_t> from(stack_.points(), stack_.points()), front;
    for (std::size_t point = 0; point < stack_.points(); ++point) {
      if (slice.solid[point] != solid || slice.region[point] != region) continue;
      from[point] = point;
      front.push_back(point);
    }
    for (int steps = 0; steps <= limits::passage_steps && !front.empty(); ++steps) {
      std::vector<std::size_t> next;
      for (const std::size_t point : front) {
        for (const std::size_t other : beside(point)) {
          if (from[other] != stack_.points()) continue;
          from[other] = point;
          if (slice.solid[other] == solid) {
            if (std::find(regions.begin(), regions.end(), slice.region[other]) == regions.end()) continue;
            for (std::size_t at = point; from[at] != at; at = from[at]) stack_.flip(level, at);
            return;
          }
          if (!stack_.on_border(other)) next.push_back(other);
        }
      }
      front = std::move(next);
    }
  }

  std::vector<std::size_t> beside(std::size_t point) const {
    if (stack_.on_border(point)) return {};
    const auto row = static_cast<std::size_t>(stack_.columns());
    return {point - 1, point + 1, point - row, point + row};
  }

  LevelStack& stack_;
  const RegionClasses& classes_;
};

}  // namespace

void keep_links(std::vector<Window>& slices, const Grid& grid, const SliceSet& given, const Surroundings& links) {
  const RegionClasses classes = classes_of(given, links);
  LevelStack stack(slices, grid, given, classes);
  LinkKeeper(stack, classes).run();
  slices = stack.windows();
}

}  // namespace odontoscope::between
