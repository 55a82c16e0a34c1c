#include "recon/sample/profile.h"

#include <algorithm>
#include <utility>

namespace odontoscope::sample {

Profile::Profile(std::initializer_list<Knot> knots) : Profile(std::vector<Knot>(knots)) {}

Profile::Profile(std::vector<Knot> knots) : knots_(std::move(knots)), slopes_(knots_.size(), 0.0) {
  // Zero at a local extreme, else the weighted harmonic mean of the neighbouring secants; the secant itself at the
  // ends.
  for (std::size_t i = 1; i + 1 < knots_.size(); ++i) {
    const double before = knots_[i].at - knots_[i - 1].at, after = knots_[i + 1].at - knots_[i].at;
    const double left = (knots_[i].value - knots_[i - 1].value) / before;
    const double right = (knots_[i + 1].value - knots_[i].value) / after;
    if (left * right <= 0) continue;
    const double weight = (before + 2 * after) / (3 * (before + after));
    slopes_[i] = left * right / (weight * right + (1 - weight) * left);
  }
  if (knots_.size() < 2) return;
  const auto secant = [this](std::size_t i) {
    return (knots_[i + 1].value - knots_[i].value) / (knots_[i + 1].at - knots_[i].at);
  };
  slopes_.front() = secant(0);
  slopes_.back() = secant(knots_.size() - 2);
}

double Profile::cubic(double at) const {
  if (at <= knots_.front().at) return knots_.front().value;
  if (at >= knots_.back().at) return knots_.back().value;
  const auto next =
      std::upper_bound(knots_.begin(), knots_.end(), at, [](double a, const Knot& k) { return a < k.at; });
  const std::size_t i = static_cast<std::size_t>(next - knots_.begin()) - 1;
  const double width = knots_[i + 1].at - knots_[i].at;
  const double t = (at - knots_[i].at) / width, u = 1 - t;
  return u * u * (1 + 2 * t) * knots_[i].value + t * t * (3 - 2 * t) * knots_[i + 1].value +
         t * u * width * (u * slopes_[i] - t * slopes_[i + 1]);
}

double Profile::operator()(double at) const {
  if (knots_.size() < 2) return knots_.front().value;
  constexpr int samples = 6;  // to either side
  double sum = 0, weights = 0;
  for (int i = -samples; i <= samples; ++i) {
    const double share = static_cast<double>(i) / (samples + 1), weight = 1 - share * share;
    sum += weight * cubic(at + share * window);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace odontoscope::sample
