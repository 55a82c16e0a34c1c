#include "engine/headset/inside.h"

namespace odontoscope {

namespace {

/// Of the roomiest place's clearance: near walls are bright, and a canal's end is dark.
constexpr double lamp_reach = 1.5;
/// Dentine, with the warmth of what lines it.
constexpr Colour wall = colour_of(0xe8cba6);

}  // namespace

Scene seen_from_inside(const Scene& scene, const Model& model, const FlightSpace& space) {
  Scene inside = scene;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const std::string& structure = model.parts[i].structure;
    Look* look = inside.look_of(structure);
    if (!look) look = &inside.looks.emplace_back(Look{structure, usual_colour(structure, i)});
    look->visible = structure == space.structure;
    if (!look->visible) continue;
    look->as_body = space.body;
    look->opacity = 1;
    look->colour = wall;
  }
  inside.section.reset();
  inside.overlays = {};
  inside.headlight = Headlight{lamp_reach * space.room_mm};
  return inside;
}

}  // namespace odontoscope
