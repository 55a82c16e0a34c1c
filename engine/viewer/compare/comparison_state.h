#pragma once
// The comparison as plain values: what is shown of the two methods, what is wanted of DB, and what was made.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/comparison/artefact_lesson.h"
#include "engine/comparison/db_pipeline.h"
#include "engine/scene/scene.h"

namespace odontoscope {

/// Of the run that works.
struct ComparisonRun {
  bool working = false;
  std::string stage;
  double fraction = 0;
};

struct ComparisonState {
  bool on = false;
  ComparisonLayout layout = ComparisonLayout::side_by_side;
  bool db_in_place = true;                       // which of the two ComparisonLayout::in_place shows
  double split = 0.5;                            // where the line is, over the view's width
  ComparisonOptions wanted;                      // changed freely; runs follow
  std::shared_ptr<const ComparisonResult> made;  // shown until the next is ready; null before the first
  std::string trouble;                           // why `wanted` could not be made; empty if it could
  ComparisonRun run;

  std::optional<std::size_t> artefact;   // of `made` that the camera was led to
  std::optional<ArtefactLesson> lesson;  // being given
  std::size_t step = 0;
  /// What leaving the mode brings back.
  std::vector<Look> looks_before;
  BackFaces back_faces_before = BackFaces::cull;
  OverlayChoice overlays_before;
};

}  // namespace odontoscope
