#pragma once
// What is seen by an eye inside a void: by a window's, a film's or a headset's.

#include "engine/scene/scene.h"

namespace odontoscope {

/// Whose triangles wall the void in: a part of the model.
struct VoidWall {
  std::string structure;
  bool body = false;  // it fills the void: its wall is seen when it is turned inside out
};

/// As `scene`: the wall and nothing else, whole and opaque, by a lamp beside the eye that reaches `lamp_mm`, before
/// black.
Scene seen_within(const Scene& scene, const Model& model, const VoidWall& wall, double lamp_mm);

}  // namespace odontoscope
