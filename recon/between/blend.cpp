#include "recon/between/blend.h"

#include <algorithm>
#include <cmath>

#include "recon/between/blend_units.h"
#include "recon/between/composed.h"
#include "recon/between/drawn_back.h"
#include "recon/between/kept_links.h"
#include "recon/between/traced.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"

namespace odontoscope::between {

namespace {

void require_blendable(const Surroundings& s, std::span<const double> shares) {
  const bool given = s.lower && s.upper;
  const bool finite = std::isfinite(s.z_lower) && std::isfinite(s.z_upper);
  const bool ascending =
      s.z_lower < s.z_upper && (!s.before || s.z_before < s.z_lower) && (!s.after || s.z_upper < s.z_after);
  const bool beyond = (!s.before || std::isfinite(s.z_before)) && (!s.after || std::isfinite(s.z_after));
  if (!given || !finite || !ascending || !beyond)
    throw InternalError("a slab to be blended has no two slices in order");
  for (std::size_t n = 0; n < shares.size(); ++n) {
    const bool between = shares[n] > 0 && shares[n] < 1 && (n == 0 || shares[n] > shares[n - 1]);
    if (!between) throw InternalError("shares of a slab must lie between 0 and 1 and ascend");
  }
}

/// The slices as fields, with what the options want of them beside being blended.
std::vector<StagedWindow> staged(const Composition& composition, const Grid& grid, std::span<const double> shares,
                                 const SliceSet& slices, const Surroundings& surroundings,
                                 const BlendOptions& options) {
  std::vector<StagedWindow> stages;
  for (const double share : shares) stages.push_back({share, composition.at(share)});
  if (options.draw_back) {
    constexpr double hardly = 0x1p-20;  // the given slices, or nearly so
    stages.insert(stages.begin(), {0, composition.at(hardly)});
    stages.push_back({1, composition.at(1 - hardly)});
    stages = drawn_back(stages, grid);
    stages.erase(stages.begin());
    stages.pop_back();
  }
  if (!options.keep_links) return stages;
  std::vector<Window> windows;
  for (StagedWindow& stage : stages) windows.push_back(std::move(stage.window));
  keep_links(windows, grid, slices, surroundings);
  for (std::size_t n = 0; n < stages.size(); ++n) stages[n].window = std::move(windows[n]);
  return stages;
}

}  // namespace

std::vector<StagedOutline> blend_in_stages(const Surroundings& surroundings, std::span<const double> shares,
                                           const BlendOptions& options) {
  require_blendable(surroundings, shares);
  std::vector<StagedOutline> result;
  if (surroundings.lower->empty() && surroundings.upper->empty()) {
    for (const double share : shares) result.push_back({share, {}});
    return result;
  }
  const SliceSet slices(surroundings);
  const BlendPlan plan = blend_plan(slices, surroundings);
  const std::optional<Grid> grid = grid_for(slices, options.most_grid_points, options.finer);
  if (!grid) {
    for (const double share : shares)
      result.push_back({share, share < 0.5 ? *surroundings.lower : *surroundings.upper});
    return result;
  }
  const std::vector<StagedWindow> stages =
      staged(Composition(slices, plan, *grid, options.strips), *grid, shares, slices, surroundings, options);
  const double tolerance = options.thinning * slices.larger_side();
  const double largest = std::ldexp(tolerance, limits::blend_thinning_rounds);
  const std::size_t enough = std::max(points_in(*surroundings.lower), points_in(*surroundings.upper));
  for (const StagedWindow& stage : stages)
    result.push_back({stage.share, thinned(traced(stage.window, *grid), tolerance, largest, enough)});
  return result;
}

std::vector<Outline> blend(const Surroundings& surroundings, std::span<const double> shares,
                           const BlendOptions& options) {
  std::vector<Outline> result;
  for (StagedOutline& one : blend_in_stages(surroundings, shares, options)) result.push_back(std::move(one.outline));
  return result;
}

}  // namespace odontoscope::between
