#include "engine/scene/colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "recon/core/error.h"
#include "recon/core/lower_case.h"
#include "recon/core/portable_math.h"

namespace odontoscope {

namespace {

float linear(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : static_cast<float>(portable::pow((encoded + 0.055f) / 1.055f, 2.4));
}

struct ColouredTissue {
  std::string_view part_of_name;
  Colour colour;
  std::optional<int> depth;
};

// Told apart by lightness as well as hue: enamel lightest, pulp darkest. The first match counts.
constexpr std::array<ColouredTissue, 8> tissues = {{
    {"cavity", colour_of(0xc71a2b), 2},
    {"enamel", colour_of(0xdeebf5), 0},
    {"dentin", colour_of(0xf7c478), 1},
    {"pulp", colour_of(0xc71a2b), 2},
    {"cement", colour_of(0xc2a885), 0},
    {"bone", colour_of(0xdbd6c2), std::nullopt},
    {"tooth", colour_of(0xeddebd), 1},
    {"external", colour_of(0xeddebd), 1},
}};

const ColouredTissue* coloured_tissue(std::string_view structure) {
  const std::string name = lower_case(std::string(structure));
  for (const ColouredTissue& tissue : tissues)
    if (name.find(tissue.part_of_name) != std::string::npos) return &tissue;
  return nullptr;
}

constexpr std::array<Colour, 6> distinguishable = {{
    colour_of(0x57b5e8),
    colour_of(0xe69e00),
    colour_of(0x009e73),
    colour_of(0xcc78a6),
    colour_of(0xf0e342),
    colour_of(0x0073b2),
}};

int channel(float value) { return static_cast<int>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f))); }

}  // namespace

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
  return tissue ? tissue->colour : distinguishable[index % distinguishable.size()];
}

std::optional<int> depth_in_tooth(std::string_view structure) {
  const ColouredTissue* tissue = coloured_tissue(structure);
  return tissue ? tissue->depth : std::nullopt;
}

}  // namespace odontoscope
