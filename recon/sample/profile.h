#pragma once
// A smooth function of one variable through given knots, as the tables of the sample teeth use it.

#include <initializer_list>
#include <vector>

namespace odontoscope::sample {

/// Piecewise cubic that keeps the monotony of its knots (F. N. Fritsch and J. Butland, SIAM J. Sci. Stat. Comput. 5,
/// 1984), constant outside, then averaged over a window of `window` to either side so that no edge shows in the
/// shading. It never leaves the range of its knots, so a crown never gets wider than its table says.
class Profile {
 public:
  struct Knot {
    double at = 0, value = 0;
  };
  /// Knots by strictly ascending `at`; at least one.
  Profile(std::initializer_list<Knot> knots);
  explicit Profile(std::vector<Knot> knots);
  /// A constant.
  Profile(double value = 0) : Profile({{0.0, value}}) {}

  double operator()(double at) const;

  const std::vector<Knot>& knots() const { return knots_; }

  static constexpr double window = 0.9;  // mm

 private:
  double cubic(double at) const;

  std::vector<Knot> knots_;
  std::vector<double> slopes_;
};

}  // namespace odontoscope::sample
