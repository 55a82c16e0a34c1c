#include "recon/input/validate.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "recon/core/limits.h"
#include "recon/input/counts.h"
#include "recon/input/planar_sweep.h"
#include "recon/input/structure_names.h"

namespace odontoscope {
namespace {

Place place_of_slice(const ContourStack& stack, std::size_t slice) {
  Place place;
  place.file = stack.source;
  place.slice = slice;
  if (std::isfinite(stack.slices[slice].z)) place.z = stack.slices[slice].z;
  return place;
}

Place place_of_contour(const ContourStack& stack, std::size_t slice, std::size_t contour) {
  Place place = place_of_slice(stack, slice);
  place.contour = contour;
  return place;
}

// --- the stack as a whole ----------------------------------------------------------------------------------------

void check_counts(const ContourStack& stack) {
  Place whole;
  whole.file = stack.source;
  check_slice_count(stack.slices.size(), whole);
  std::size_t contours = 0, points = 0;
  for (std::size_t s = 0; s < stack.slices.size(); ++s) {
    const Slice& slice = stack.slices[s];
    check_contours_in_slice(slice.contours.size(), place_of_slice(stack, s));
    contours += slice.contours.size();
    for (const Contour& contour : slice.contours) points += contour.points.size();
  }
  check_contour_count(contours, whole);
  check_point_count(points, whole);
  if (contours == 0) {
    throw InputError("empty-stack", whole,
                     stack.slices.empty() ? "the stack has no slices" : "no slice of the stack has a contour",
                     "Give at least two slices, one of them with a contour");
  }
  if (stack.slices.size() < 2) {
    throw InputError("single-slice", whole, "the stack has a single slice, which spans no volume",
                     "Add the slices above or below it; a slice may be empty");
  }
}

void check_heights(const ContourStack& stack) {
  for (std::size_t s = 0; s < stack.slices.size(); ++s) {
    check_magnitude(stack.slices[s].z, "z", place_of_slice(stack, s));
  }
  std::vector<std::size_t> by_height(stack.slices.size());
  std::iota(by_height.begin(), by_height.end(), std::size_t{0});
  std::stable_sort(by_height.begin(), by_height.end(),
                   [&](std::size_t a, std::size_t b) { return stack.slices[a].z < stack.slices[b].z; });
  std::size_t repeated = stack.slices.size(), twin = 0;
  for (std::size_t i = 1; i < by_height.size(); ++i) {
    const std::size_t a = by_height[i - 1], b = by_height[i];
    if (stack.slices[a].z == stack.slices[b].z && b < repeated) {
      repeated = b;
      twin = a;
    }
  }
  if (repeated == stack.slices.size()) return;
  throw InputError("repeated-z", place_of_slice(stack, repeated), fmt::format("slice {} has the same z", twin),
                   "Merge the two slices, or correct one of the heights");
}

void check_names(const ContourStack& stack) {
  std::unordered_set<std::string_view> known;
  for (std::size_t s = 0; s < stack.slices.size(); ++s) {
    const std::vector<Contour>& contours = stack.slices[s].contours;
    for (std::size_t c = 0; c < contours.size(); ++c) {
      if (c > 0 && contours[c].structure == contours[c - 1].structure) continue;
      if (!known.insert(contours[c].structure).second) continue;
      check_structure_name(contours[c].structure, place_of_contour(stack, s, c));
      if (known.size() > limits::structures) {
        throw InputError("too-many-structures", place_of_contour(stack, s, c),
                         fmt::format("more than {} different structures", limits::structures),
                         "Reconstruct them in groups, or check that \"structure\" does not number the contours");
      }
    }
  }
}

// --- one slice ---------------------------------------------------------------------------------------------------

void check_points(const ContourStack& stack, std::size_t s, std::size_t c) {
  const std::vector<Point2>& points = stack.slices[s].contours[c].points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2& p = points[i];
    if (std::abs(p.x) <= limits::largest_coordinate && std::abs(p.y) <= limits::largest_coordinate) continue;
    Place place = place_of_contour(stack, s, c);
    place.point = i;
    check_magnitude(p.x, "x", place);
    check_magnitude(p.y, "y", place);
  }
  if (points.size() < 3) {
    throw InputError("too-few-points", place_of_contour(stack, s, c),
                     fmt::format("{} point{}, but a contour needs three", points.size(), points.size() == 1 ? "" : "s"),
                     "Remove the contour, or close it around an area");
  }
}

[[noreturn]] void throw_repeated(Place place, const Breach& breach, std::size_t count) {
  const bool closed_twice = breach.other_point == 0 && breach.point + 1 == count;
  throw InputError(
      "repeated-point", std::move(place),
      closed_twice ? "the last point repeats the first" : fmt::format("the same place as point {}", breach.other_point),
      closed_twice ? "Leave it out: a contour is closed by itself"
                   : "A contour visits each place once: leave the point out, or split the contour there");
}

[[noreturn]] void throw_breach(const ContourStack& stack, std::size_t s, const Breach& breach) {
  const std::vector<Contour>& contours = stack.slices[s].contours;
  Place place = place_of_contour(stack, s, breach.contour);
  place.point = breach.point;
  place.at = breach.at;
  const std::string structure = in_quotes(contours[breach.contour].structure);
  const bool itself = breach.contour == breach.other_contour;
  const bool at_point = contours[breach.other_contour].points[breach.other_point] == breach.at;
  switch (breach.kind) {
    case Breach::Kind::repeated_point:
      throw_repeated(std::move(place), breach, contours[breach.contour].points.size());
    case Breach::Kind::fold_back:
      throw InputError("self-crossing", place, "the contour folds back on itself at this point",
                       "Leave the point of the spike out");
    case Breach::Kind::touch:
      if (itself) {
        throw InputError("self-crossing", place,
                         fmt::format("the contour touches its own edge that starts at point {}", breach.other_point),
                         "Move the point off the edge, or split the contour there");
      }
      throw InputError("contours-touch", place,
                       fmt::format("touches contour {} {} point {}; both belong to {}", breach.other_contour,
                                   at_point ? "at its" : "on the edge after its", breach.other_point, structure),
                       "Contours of one structure keep apart: merge the two, or move one");
    case Breach::Kind::crossing:
      break;
  }
  if (itself) {
    throw InputError("self-crossing", place,
                     fmt::format("the edge after this point crosses the one after point {}", breach.other_point),
                     "Untangle the contour: it is one closed line that never meets itself");
  }
  throw InputError("contours-cross", place,
                   fmt::format("the edge after this point crosses contour {} after its point {}; both belong to {}",
                               breach.other_contour, breach.other_point, structure),
                   "Merge the two contours, or give them different structures");
}

/// Numbers of the contours of each structure, structures in order of first appearance.
std::vector<std::vector<std::size_t>> by_structure(const Slice& slice) {
  std::vector<std::vector<std::size_t>> groups;
  std::unordered_map<std::string_view, std::size_t> group_of;
  for (std::size_t c = 0; c < slice.contours.size(); ++c) {
    const auto [found, is_new] = group_of.try_emplace(slice.contours[c].structure, groups.size());
    if (is_new) groups.emplace_back();
    groups[found->second].push_back(c);
  }
  return groups;
}

void check_slice(const ContourStack& stack, std::size_t s) {
  const Slice& slice = stack.slices[s];
  for (std::size_t c = 0; c < slice.contours.size(); ++c) check_points(stack, s, c);
  std::optional<Breach> breach;
  for (const std::vector<std::size_t>& members : by_structure(slice)) {
    breach = sweep(slice.contours, members).breach;
    if (breach) break;
  }
  // A contour that is all on one line also repeats points or folds back; "zero area" says it better.
  const bool repeats = breach && breach->kind == Breach::Kind::repeated_point;
  for (std::size_t c = 0; breach && !repeats && c < slice.contours.size(); ++c) {
    if (!collinear(slice.contours[c].points)) continue;
    throw InputError("zero-area", place_of_contour(stack, s, c), "all points lie on one line",
                     "Remove the contour: it encloses nothing");
  }
  if (breach) throw_breach(stack, s, *breach);
}

/// Keeps the error of the lowest slice, whichever thread finds its own first.
class FirstError {
 public:
  bool comes_after(std::size_t slice) const { return slice > slice_.load(std::memory_order_relaxed); }
  void keep(std::size_t slice, std::exception_ptr error) {
    const std::scoped_lock lock(mutex_);
    if (slice >= slice_.load(std::memory_order_relaxed)) return;
    slice_.store(slice, std::memory_order_relaxed);
    error_ = std::move(error);
  }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::atomic<std::size_t> slice_ = SIZE_MAX;
  std::exception_ptr error_;
  std::mutex mutex_;
};

}  // namespace

ValidStack validate(ContourStack stack, const Progress& progress) {
  progress.tell("validate", 0);
  check_counts(stack);
  check_heights(stack);
  check_names(stack);
  FirstError first;
  tbb::parallel_for(std::size_t{0}, stack.slices.size(), [&](std::size_t s) {
    if (first.comes_after(s)) return;
    progress.check();
    try {
      check_slice(stack, s);
    } catch (const InputError&) {
      first.keep(s, std::current_exception());
    }
  });
  first.rethrow();
  progress.tell("validate", 1);
  return ValidStack(std::move(stack));
}

OrderedStack ordered(const ContourStack& stack) {
  OrderedStack result;
  result.original_slice.resize(stack.slices.size());
  std::iota(result.original_slice.begin(), result.original_slice.end(), std::size_t{0});
  std::stable_sort(result.original_slice.begin(), result.original_slice.end(),
                   [&](std::size_t a, std::size_t b) { return stack.slices[a].z < stack.slices[b].z; });
  result.stack.source = stack.source;
  result.stack.slices.resize(stack.slices.size());
  tbb::parallel_for(std::size_t{0}, stack.slices.size(), [&](std::size_t i) {
    Slice& slice = result.stack.slices[i];
    slice = stack.slices[result.original_slice[i]];
    for (const std::vector<std::size_t>& members : by_structure(slice)) {
      const SweepResult swept = sweep(slice.contours, members);
      if (swept.breach) throw InternalError("a stack to be ordered was not validated");
      for (std::size_t m = 0; m < members.size(); ++m) {
        const bool outer = swept.nesting[m].depth % 2 == 0;
        std::vector<Point2>& points = slice.contours[members[m]].points;
        if (swept.nesting[m].counter_clockwise != outer) std::reverse(points.begin() + 1, points.end());
      }
    }
  });
  return result;
}

ContourStack together(const ContourStack& stack, const std::vector<std::string>& structures) {
  const std::vector<std::string> known = structures_of(stack);
  const auto contains = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  Place place;
  place.file = stack.source;
  std::string joint;
  for (std::size_t i = 0; i < structures.size(); ++i) {
    if (!contains(known, structures[i])) {
      std::vector<std::string> names;
      for (const std::string& name : known) names.push_back(in_quotes(name));
      throw InputError("unknown-structure", place, fmt::format("there is no structure {}", in_quotes(structures[i])),
                       fmt::format("The stack has {}", fmt::join(names, ", ")));
    }
    const bool named_before = std::find(structures.begin(), structures.begin() + static_cast<std::ptrdiff_t>(i),
                                        structures[i]) != structures.begin() + static_cast<std::ptrdiff_t>(i);
    if (!named_before) joint += (joint.empty() ? "" : "+") + structures[i];
  }
  if (contains(known, joint) && !contains(structures, joint)) {
    throw InputError("bad-name", place, fmt::format("the joint name {} is already taken", in_quotes(joint)),
                     "Rename that structure");
  }
  ContourStack result = stack;
  for (Slice& slice : result.slices) {
    for (Contour& contour : slice.contours) {
      if (contains(structures, contour.structure)) contour.structure = joint;
    }
  }
  return result;
}

std::vector<std::string> structures_of(const ContourStack& stack) {
  std::vector<std::string> names;
  std::unordered_set<std::string_view> known;
  for (const Slice& slice : stack.slices) {
    for (const Contour& contour : slice.contours) {
      if (known.insert(contour.structure).second) names.push_back(contour.structure);
    }
  }
  return names;
}

}  // namespace odontoscope
