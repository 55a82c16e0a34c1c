#pragma once
// A short, smooth way from one camera to another, and from one look to another.

#include <optional>
#include <utility>

#include "engine/scene/scene.h"

namespace odontoscope {

/// `share` 0 gives `from`, 1 gives `to`, exactly. In between the eye goes round the target rather than through it, and
/// nears it by equal factors in equal times. The projection is that of `to`.
Camera between(const Camera& from, const Camera& to, double share);

/// Long enough to see where one is led, short enough not to wait.
inline constexpr double transition_seconds = 0.35;
/// In a lesson, where one is to see what changes.
inline constexpr double lesson_seconds = 0.9;

class Transition {
 public:
  Transition(const Camera& from, const Camera& to, double seconds = transition_seconds)
      : from_(from), to_(to), seconds_(seconds) {}
  /// The camera `seconds` later; starts and ends gently.
  Camera advance(double seconds);
  bool over() const { return elapsed_ >= seconds_; }
  const Camera& goal() const { return to_; }

 private:
  Camera from_, to_;
  double seconds_, elapsed_ = 0;
};

/// `share` 1 gives `to`, exactly, and what is neither colour, opacity nor section is as in `to` from the beginning. In
/// between structures fade in and out, and a section goes on its way; one that is new comes in from where it cuts next
/// to nothing.
Scene looks_between(const Scene& from, const Scene& to, double share, const Model& model);

class LookTransition {
 public:
  LookTransition(Scene from, Scene to, double seconds = lesson_seconds)
      : from_(std::move(from)), to_(std::move(to)), seconds_(seconds) {}
  /// The looks `seconds` later, under `camera`.
  Scene advance(double seconds, const Camera& camera, const Model& model);
  bool over() const { return elapsed_ >= seconds_; }
  const Scene& goal() const { return to_; }

 private:
  Scene from_, to_;
  double seconds_, elapsed_ = 0;
};

}  // namespace odontoscope
