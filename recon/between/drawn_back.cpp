#include "recon/between/drawn_back.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numbers>
#include <queue>
#include <utility>

#include "recon/between/limits.h"

namespace odontoscope::between {
namespace {

/// The first of two, as large as both together; what is new is far outside.
Window on_both(const Window& one, const Window& other) {
  Window all = around(std::array{&one, &other});
  combine(all, one, [](double, double own) { return own; });
  return all;
}

/// How far the way within `whole` leads from what both have inside, in steps of the grid; 0 elsewhere, and where no way
/// leads.
std::vector<double> way_from_common(const Window& whole, const Window& other) {
  constexpr double never = far_outside;
  std::vector<double> way(whole.values.size(), never);
  using Reached = std::pair<double, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
  for (std::size_t n = 0; n < way.size(); ++n) {
    if (!(whole.values[n] < 0 && other.values[n] < 0)) continue;
    way[n] = 0;
    front.emplace(0.0, n);
  }
  while (!front.empty()) {
    const auto [so_far, n] = front.top();
    front.pop();
    if (so_far > way[n]) continue;
    const auto column = static_cast<std::ptrdiff_t>(n) % whole.columns,
               row = static_cast<std::ptrdiff_t>(n) / whole.columns;
    for (std::ptrdiff_t dj = -1; dj <= 1; ++dj) {
      for (std::ptrdiff_t di = -1; di <= 1; ++di) {
        const std::ptrdiff_t i = column + di, j = row + dj;
        if (i < 0 || j < 0 || i >= whole.columns || j >= whole.rows) continue;
        const auto m = static_cast<std::size_t>(j * whole.columns + i);
        const double longer = so_far + (di != 0 && dj != 0 ? std::numbers::sqrt2 : 1.0);
        if (!(whole.values[m] < 0) || longer >= way[m]) continue;
        way[m] = longer;
        front.emplace(longer, m);
      }
    }
  }
  for (double& length : way)
    if (length == never) length = 0;
  return way;
}

/// Values of a slice of which no more is left than the way says; the border of what is left runs across it.
double shortened(double value, double way, double left, double step) { return std::max(value, (way - left) * step); }

}  // namespace

std::vector<StagedWindow> drawn_back(const std::vector<StagedWindow>& stages, const Grid& grid) {
  std::vector<StagedWindow> all;
  for (std::size_t n = 0; n < stages.size(); ++n) {
    all.push_back(stages[n]);
    if (n + 1 == stages.size() || stages[n].window.values.empty() || stages[n + 1].window.values.empty()) continue;
    const Window lower = on_both(stages[n].window, stages[n + 1].window),
                 upper = on_both(stages[n + 1].window, stages[n].window);
    const std::vector<double> down = way_from_common(lower, upper), up = way_from_common(upper, lower);
    const double most_down = *std::max_element(down.begin(), down.end()),
                 most_up = *std::max_element(up.begin(), up.end());
    const double most = std::max(most_down, most_up);
    if (!(most > limits::sudden_steps)) continue;
    const int count = std::min(limits::most_drawn_back, static_cast<int>(most / limits::sudden_steps) + 1);
    for (int made = 1; made <= count; ++made) {
      const double share = static_cast<double>(made) / (count + 1);
      StagedWindow between{stages[n].share + share * (stages[n + 1].share - stages[n].share), lower};
      for (std::size_t p = 0; p < down.size(); ++p) {
        between.window.values[p] = std::min(shortened(lower.values[p], down[p], (1 - share) * most_down, grid.step),
                                            shortened(upper.values[p], up[p], share * most_up, grid.step));
      }
      all.push_back(std::move(between));
    }
  }
  return all;
}

}  // namespace odontoscope::between
