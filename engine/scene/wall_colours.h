#pragma once
// The colours of walls that tell how thick they are, for legends: as shaders/wall_depth.glsl gives them in full light.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/scene/scene.h"

namespace odontoscope {

/// sRGB, 0 to 255.
using ShownColour = std::array<std::uint8_t, 3>;

/// Of a wall of this colour, from 0 mm at the left to the thickest that has a colour at the right, with a line every
/// fifth of the way from one bold line to the next.
std::vector<ShownColour> thickness_bar(const Colour& own, int pixels);
/// What the bold lines, and the bar's end, mean: mm.
std::array<double, 3> thickness_marks_mm(const Model& model);

/// The own colour of what is seen to tell how thick it is: of a body that fills a cavity before the cavity's wall.
/// None: the scene shows no such.
std::optional<Colour> telling_thickness(const Scene& scene, const Model& model);

}  // namespace odontoscope
