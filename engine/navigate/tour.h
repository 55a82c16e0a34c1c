#pragma once
// A tour along a centre line as a function of time: where the eye is, which way it looks, and how near it may see.
//
// The eye moves with constant apparent speed: so many radii of the void a second, so that walls pass equally fast in
// chamber and canal. It looks a little ahead, turns no faster than `largest_turn_deg_s`, and never rolls: its frame is
// carried on by the smallest rotation from instant to instant (a rotation-minimising frame; W. Wang et al.,
// "Computation of rotation minimizing frames", 2008). It starts and stops gently. Where a bend would break a bound the
// tour is slower. Pure numbers: nothing is drawn, and the same line gives the same tour.

#include <glm/vec3.hpp>
#include <vector>

#include "engine/scene/camera.h"
#include "recon/cavity/centre_lines.h"

namespace odontoscope {

struct TourOptions {
  double radii_per_second = 2;  // apparent speed where nothing slows it; 0.05 to 20
  double field_of_view_deg = 80;
  double widest_aspect = 2.4;     // width over height of the widest picture for which the near plane is safe
  bool back = false;              // from the line's end to its start, looking where it goes
  glm::dvec3 upright{0, 0, 1};    // up in the picture at the start, as far as the line of view_direction allows
  glm::dvec3 otherwise{0, 1, 0};  // the same where the line of view_direction is nearly along `upright`
};

struct TourInstant {
  Camera camera;
  double along = 0;      // mm from the line's start, on the line
  double clearance = 0;  // to the wall, mm: at least so much
  double width = 0;      // the void's radius about there, mm, without its small bumps: what a lamp's reach may follow
};

class Tour {
 public:
  /// What holds at every instant: the view's turn in degrees a second, and the third derivative of the eye's place in
  /// radii (TourInstant::width) over s^3.
  static constexpr double largest_turn_deg_s = 60, largest_jerk = 40;

  /// Precondition: at least two points, radii positive. Throws UsageError for a speed out of range.
  explicit Tour(const CentreLine& line, const TourOptions& options = {});

  double seconds() const { return step_ * static_cast<double>(frames_.size() - 1); }
  /// `seconds` are held to the tour.
  TourInstant at(double seconds) const;

 private:
  struct Frame {
    glm::dvec3 at{0}, view_direction{0}, up{0};
    double along = 0, clearance = 0, width = 0;
  };
  std::vector<Frame> frames_;  // `step_` seconds apart, at least two
  double step_ = 0;
  TourOptions options_;
};

}  // namespace odontoscope
