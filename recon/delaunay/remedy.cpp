#include "recon/delaunay/remedy.h"

#include <algorithm>
#include <cmath>

#include "recon/core/limits.h"
#include "recon/core/portable_math.h"
#include "recon/delaunay/tracked_shape.h"

namespace odontoscope::delaunay {
namespace {

/// Between the two discs that have the shapes' areas; negative if they overlap.
double gap(const TrackedShape& a, const TrackedShape& b) {
  return portable::hypot(a.centroid.x - b.centroid.x, a.centroid.y - b.centroid.y) - a.radius - b.radius;
}

std::vector<std::uint32_t> nearest_first(const TrackedShape& shape, const ShapeSlice& others) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < others.shapes.size(); ++i) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return gap(shape, others.shapes[a]) < gap(shape, others.shapes[b]);
  });
  return order;
}

bool builds(const SlabTask& task, const std::vector<RegionLink>& witnessed, const RegionLink& link,
            const Progress& progress) {
  try {
    SlabTask trial = task;
    trial.choices.joined.emplace_back(link.lower, link.upper);
    trial.correspondences = correspond(witnessed, trial.choices, static_cast<std::uint32_t>(task.lower.regions()),
                                       static_cast<std::uint32_t>(task.upper.regions()), task.place);
    solve_slab(trial, progress);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

std::optional<RegionLink> remedy(const SlabTask& task, const std::vector<RegionLink>& witnessed, RegionOfSlab region,
                                 const Progress& progress) {
  const ShapeSlice own = region_shapes(region.in_lower ? task.lower : task.upper);
  std::vector<std::uint32_t> others =
      nearest_first(own.shapes[region.number], region_shapes(region.in_lower ? task.upper : task.lower));
  others.resize(std::min(others.size(), limits::remedies_tried));
  for (const std::uint32_t other : others) {
    const RegionLink link = region.in_lower ? RegionLink{region.number, other, LinkCriterion::user}
                                            : RegionLink{other, region.number, LinkCriterion::user};
    if (builds(task, witnessed, link, progress)) return link;
  }
  return std::nullopt;
}

}  // namespace odontoscope::delaunay
