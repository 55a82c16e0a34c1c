#include "recon/between/blend.h"

#include <algorithm>
#include <cmath>

#include "recon/between/blend_units.h"
#include "recon/between/composed.h"
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

}  // namespace

std::vector<Outline> blend(const Surroundings& surroundings, std::span<const double> shares,
                           const BlendOptions& options) {
  require_blendable(surroundings, shares);
  std::vector<Outline> result;
  if (surroundings.lower->empty() && surroundings.upper->empty()) {
    result.resize(shares.size());
    return result;
  }
  const SliceSet slices(surroundings);
  const BlendPlan plan = blend_plan(slices, surroundings);
  const std::optional<Grid> grid = grid_for(slices, options.most_grid_points, options.finer);
  if (!grid) {
    for (const double share : shares) result.push_back(share < 0.5 ? *surroundings.lower : *surroundings.upper);
    return result;
  }
  const Composition composition(slices, plan, *grid, options.strips);
  const double tolerance = options.thinning * slices.larger_side();
  const double largest = std::ldexp(tolerance, limits::blend_thinning_rounds);
  const std::size_t enough = std::max(points_in(*surroundings.lower), points_in(*surroundings.upper));
  std::vector<Window> windows;
  for (const double share : shares) windows.push_back(composition.at(share));
  if (options.keep_links) keep_links(windows, *grid, slices, surroundings);
  for (const Window& window : windows) result.push_back(thinned(traced(window, *grid), tolerance, largest, enough));
  return result;
}

}  // namespace odontoscope::between
