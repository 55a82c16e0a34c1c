#include "engine/scene/wall_colours.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace odontoscope {

namespace {

// As in shaders/wall_depth.glsl; a test compares both.
constexpr glm::vec3 amber{0.791f, 0.352f, 0.060f}, teal{0.061f, 0.445f, 0.337f}, blue{0.110f, 0.150f, 0.620f};
constexpr double amber_at = 4, teal_at = 9, blue_at = 14;
constexpr float strength = 0.8f, line_light = 0.06f;
constexpr double lines_a_mark = 5;

glm::vec3 hue_at(const glm::vec3& own, double steps) {
  const auto between = [&](const glm::vec3& a, const glm::vec3& b, double from, double to) {
    return glm::mix(a, b, static_cast<float>(std::clamp((steps - from) / (to - from), 0.0, 1.0)));
  };
  const glm::vec3 hue = steps < amber_at  ? between(own, amber, 0, amber_at)
                        : steps < teal_at ? between(amber, teal, amber_at, teal_at)
                                          : between(teal, blue, teal_at, blue_at);
  return glm::mix(own, hue, strength);
}

ShownColour shown(const glm::vec3& light) {
  const Colour colour = encoded(light);
  const auto byte = [](float part) { return static_cast<std::uint8_t>(std::lround(255 * part)); };
  return {byte(colour.red), byte(colour.green), byte(colour.blue)};
}

}  // namespace

std::vector<ShownColour> thickness_bar(const Colour& own, int pixels) {
  std::vector<ShownColour> bar;
  for (int x = 0; x < pixels; ++x) {
    const double lines = thickest_steps * (x + 0.5) / pixels, nearest = std::round(lines),
                 off = std::abs(lines - nearest) * pixels / thickest_steps;
    const bool bold = std::fmod(nearest, lines_a_mark) == 0, line = off < (bold ? 1.3 : 0.51) && nearest > 0;
    const glm::vec3 hue = hue_at(linear(own), thickest_steps - lines);
    bar.push_back(shown(line ? hue * (bold ? line_light : 0.3f) : hue));
  }
  return bar;
}

std::array<double, 3> thickness_marks_mm(const Model& model) {
  const double mark = lines_a_mark * model.thickness_step_mm();
  return {mark, 2 * mark, thickest_steps * model.thickness_step_mm()};
}

std::optional<Colour> telling_thickness(const Scene& scene, const Model& model) {
  if (!scene.wall_thickness) return std::nullopt;
  std::optional<Colour> found;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    if (model.parts[i].thicknesses_mm.empty()) continue;
    const Look* look = scene.look_of(model.parts[i].structure);
    if (look && !look->visible) continue;
    const Colour own = look ? look->colour : usual_colour(model.parts[i].structure, i);
    if (!model.parts[i].cavity) return own;  // a body hides the wall that it lies against
    if (!found) found = own;
  }
  return found;
}

}  // namespace odontoscope
