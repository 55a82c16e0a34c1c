#pragma once
// How many times enlarged the tooth is, written in the room beside it: strokes, since surfaces and lines are all that
// the renderer draws.

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "engine/headset/stage.h"

namespace odontoscope {

/// The digits of `text` and 'x' and '.' as strokes in a box that is one high: two points a line, x to the right, y up,
/// z 0. Other characters are gaps.
std::vector<glm::dvec3> strokes(const std::string& text);

/// "25x" below the tooth, upright and towards the eye, as strokes in the room.
std::vector<glm::dvec3> scale_mark(const Stage& stage, const Model& model, const glm::dvec3& eye);

}  // namespace odontoscope
