#include "engine/headset/scale_mark.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace odontoscope {

namespace {

constexpr double width = 0.55, gap = 0.25;  // of a character that is one high

/// Which of the seven bars of a pocket calculator are lit: top, upper left, upper right, middle, lower left, lower
/// right, bottom.
constexpr std::array<const char*, 10> lit = {"1110111", "0010010", "1011101", "1011011", "0111010",
                                             "1101011", "1101111", "1010010", "1111111", "1111011"};

struct Bar {
  double from_x, from_y, to_x, to_y;
};
constexpr std::array<Bar, 7> bars = {{{0, 1, width, 1},
                                      {0, 0.5, 0, 1},
                                      {width, 0.5, width, 1},
                                      {0, 0.5, width, 0.5},
                                      {0, 0, 0, 0.5},
                                      {width, 0, width, 0.5},
                                      {0, 0, width, 0}}};

}  // namespace

std::vector<glm::dvec3> strokes(const std::string& text) {
  std::vector<glm::dvec3> lines;
  double left = 0;
  const auto add = [&](const Bar& bar) {
    lines.push_back({left + bar.from_x, bar.from_y, 0});
    lines.push_back({left + bar.to_x, bar.to_y, 0});
  };
  for (const char character : text) {
    if (character >= '0' && character <= '9') {
      const char* of = lit[static_cast<std::size_t>(character - '0')];
      for (std::size_t i = 0; i < bars.size(); ++i)
        if (of[i] == '1') add(bars[i]);
    } else if (character == 'x') {
      add({0, 0, width, 0.55});
      add({0, 0.55, width, 0});
    } else if (character == '.') {
      add({0, 0, 0, 0.06});
      left -= width;
    }
    left += width + gap;
  }
  return lines;
}

std::vector<glm::dvec3> scale_mark(const Stage& stage, const Model& model, const glm::dvec3& eye) {
  constexpr double height = 0.035;  // metres, read at arm's length without leaning forward
  const std::string text = stage.magnification < 9.95 ? fmt::format("{:.1f}x", stage.magnification)
                                                      : fmt::format("{:.0f}x", stage.magnification);
  const glm::dvec3 centre = to_room(stage, model.bounds_mm.centre());
  const glm::dvec3 up(0, 1, 0), to_eye = eye - centre, level(to_eye.x, 0, to_eye.z);
  if (!(glm::length(level) > 1e-6)) return {};
  const glm::dvec3 right = glm::normalize(glm::cross(up, level));
  std::vector<glm::dvec3> lines = strokes(text);
  const double radius = model.radius_mm / mm_per_metre(stage),
               half = 0.5 * (static_cast<double>(text.size()) * (width + gap) - gap);
  const glm::dvec3 corner = centre - (radius + 1.5 * height) * up - half * height * right;
  for (glm::dvec3& point : lines) point = corner + height * (point.x * right + point.y * up);
  return lines;
}

}  // namespace odontoscope
