#include "engine/scene/colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "assets/theme.h"
#include "recon/core/error.h"
#include "recon/core/lower_case.h"
#include "recon/core/portable_math.h"

namespace odontoscope {

namespace {

float linear(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : static_cast<float>(portable::pow((encoded + 0.055f) / 1.055f, 2.4));
}

float encoded(float light) {
  const float part = std::clamp(light, 0.0f, 1.0f);
  return part <= 0.0031308f ? 12.92f * part : static_cast<float>(1.055 * portable::pow(part, 1 / 2.4) - 0.055);
}

struct ColouredTissue {
  std::string_view part_of_name;
  Colour colour;
  std::optional<int> depth;
};

// Told apart by lightness as well as hue: enamel lightest, pulp darkest. The first match counts.
constexpr std::array<ColouredTissue, 8> coloured_tissues = {{
    {"cavity", colour_of(assets::theme::tissues::pulp), 2},
    {"enamel", colour_of(assets::theme::tissues::enamel), 0},
    {"dentin", colour_of(assets::theme::tissues::dentine), 1},
    {"pulp", colour_of(assets::theme::tissues::pulp), 2},
    {"cement", colour_of(assets::theme::tissues::cementum), 0},
    {"bone", colour_of(assets::theme::tissues::bone), std::nullopt},
    {"tooth", colour_of(assets::theme::tissues::tooth), 1},
    {"external", colour_of(assets::theme::tissues::tooth), 1},
}};

const ColouredTissue* coloured_tissue(std::string_view structure) {
  const std::string name = lower_case(std::string(structure));
  for (const ColouredTissue& tissue : coloured_tissues)
    if (name.find(tissue.part_of_name) != std::string::npos) return &tissue;
  return nullptr;
}

int channel(float value) { return static_cast<int>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f))); }

}  // namespace

Colour encoded(const glm::vec3& light) { return {encoded(light.r), encoded(light.g), encoded(light.b)}; }

glm::vec3 linear(const Colour& colour) { return {linear(colour.red), linear(colour.green), linear(colour.blue)}; }

Colour colour_from_hex(std::string_view text) {
  unsigned value = 0;
  const char* end = text.data() + text.size();
  const bool digits = text.size() == 7 && text[0] == '#' && std::from_chars(text.data() + 1, end, value, 16).ptr == end;
  if (!digits)
    throw UsageError(fmt::format("\"{}\" is no colour", text), "Write it as # and six hexadecimal digits: #f2e9d8.");
  return colour_of(value);
}

std::string hex(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", channel(colour.red), channel(colour.green), channel(colour.blue));
}

Colour usual_colour(std::string_view structure, std::size_t index) {
  const ColouredTissue* tissue = coloured_tissue(structure);
  return tissue ? tissue->colour : colour_of(assets::theme::others[index % assets::theme::others.size()]);
}

std::optional<int> depth_in_tooth(std::string_view structure) {
  const ColouredTissue* tissue = coloured_tissue(structure);
  return tissue ? tissue->depth : std::nullopt;
}

}  // namespace odontoscope
