#pragma once
// A figure as plain values: what is shown, how, and what is to be seen in it. Nothing here draws.

#include <string>
#include <vector>

#include "engine/scene/overlay.h"
#include "engine/scene/scene.h"

namespace odontoscope::figures {

/// Lines of one kind in the user's millimetres; two points a line.
struct Strokes {
  LineKind kind = LineKind::contour;
  std::vector<Point3> ends;
};

/// One picture.
struct Panel {
  std::string caption;
  std::vector<NamedSurface> surfaces;  // at least one triangle in all; may be hidden by the scene
  std::vector<Strokes> strokes;
  double crease_deg = default_crease_deg;
  Scene scene;
};

struct Figure {
  int number = 0;  // of the paper
  std::string title, caption;
  double aspect = 1;          // of each panel, width over height
  std::vector<Panel> panels;  // (a), (b), ...
};

}  // namespace odontoscope::figures
