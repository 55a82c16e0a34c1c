#pragma once
// DT and DB in the headset: the second model is made when it is first asked for, off the frame's thread, or taken from
// the desktop.

#include <memory>
#include <string>

#include "engine/viewer/compare/comparison_run.h"
#include "engine/viewer/compare/comparison_state.h"

namespace odontoscope {

class HeadsetComparison {
 public:
  /// `desktop`: its state there, whose result and options are taken.
  HeadsetComparison(std::shared_ptr<const LoadedModel> loaded, const ComparisonState& desktop);

  /// DB needs contours.
  bool possible() const { return comparison_possible(*loaded_); }
  /// Once a frame. `wanted`: somebody wants to see DB; the first time that begins to make it.
  void update(bool wanted);
  /// Null until it is made.
  const std::shared_ptr<const ComparisonResult>& made() const { return made_; }
  /// How far it is, what is wrong with it, or why it cannot be made.
  std::string in_words() const;

 private:
  std::shared_ptr<const LoadedModel> loaded_;
  ComparisonOptions options_;
  std::shared_ptr<const ComparisonResult> made_;
  std::string trouble_;
  std::unique_ptr<DbWorker> worker_;
};

}  // namespace odontoscope
