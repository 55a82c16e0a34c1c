#include "engine/navigate/seen_within.h"

namespace odontoscope {

namespace {

/// Dentine, with the warmth of what lines it.
constexpr Colour wall_colour = colour_of(0xe8cba6);

}  // namespace

Scene seen_within(const Scene& scene, const Model& model, const VoidWall& wall, double lamp_mm) {
  Scene inside = scene;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const std::string& structure = model.parts[i].structure;
    Look* look = inside.look_of(structure);
    if (!look) look = &inside.looks.emplace_back(Look{structure, usual_colour(structure, i)});
    look->visible = structure == wall.structure;
    if (!look->visible) continue;
    look->as_body = wall.body;
    look->opacity = 1;
    look->colour = wall_colour;
  }
  inside.section.reset();
  inside.overlays = {};
  inside.background = {Background::Kind::plain, {0, 0, 0}, {0, 0, 0}};
  inside.headlight = Headlight{lamp_mm};
  return inside;
}

}  // namespace odontoscope
