#pragma once
// A short, smooth way from one camera to another.

#include <optional>

#include "engine/scene/camera.h"

namespace odontoscope {

/// `share` 0 gives `from`, 1 gives `to`, exactly. In between the eye goes round the target rather than through it, and nears it by
/// equal factors in equal times. The projection is that of `to`.
Camera between(const Camera& from, const Camera& to, double share);

/// Long enough to see where one is led, short enough not to wait.
inline constexpr double transition_seconds = 0.35;

class Transition {
 public:
  Transition(const Camera& from, const Camera& to) : from_(from), to_(to) {}
  /// The camera `seconds` later; starts and ends gently.
  Camera advance(double seconds);
  bool over() const { return elapsed_ >= transition_seconds; }
  const Camera& goal() const { return to_; }

 private:
  Camera from_, to_;
  double elapsed_ = 0;
};

}  // namespace odontoscope
