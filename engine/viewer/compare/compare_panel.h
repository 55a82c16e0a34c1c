#pragma once
// The comparison's controls in the panel, and what it draws over the picture: which method is where, the line of a
// split view, the artefact and the lesson.

#include <vector>

#include "engine/ui/interface.h"
#include "engine/viewer/compare/comparison_state.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

/// A button while the mode is off; the comparison's numbers and controls while it is on; nothing where no contours are
/// known.
void comparison_section(ComparisonState& compared, ViewerState& state, const Interface& interface);

/// Over the picture. Precondition: the mode is on.
void draw_comparison(const ComparisonState& compared, ViewerState& state, const std::vector<ViewPane>& panes,
                     const Interface& interface, const Area& viewport, float scale);

/// Edges of the shown model by what is wrong with them, as drawn.
struct FaultyEdges {
  std::size_t cracks = 0, misoriented = 0, nonmanifold = 0;
};
FaultyEdges faulty_edges_of(const LoadedModel& shown);

}  // namespace odontoscope
