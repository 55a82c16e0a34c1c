#include "engine/scene/colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "recon/core/error.h"

namespace odontoscope {

namespace {

float linear(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

struct Tissue {
  std::string_view part_of_name;
  Colour colour;
  std::optional<int> depth;
};

// Told apart by lightness as well as hue: enamel lightest, pulp darkest. The first match counts.
constexpr std::array<Tissue, 8> tissues = {{
    {"cavity", {0.78f, 0.10f, 0.17f}, 2},
    {"enamel", {0.87f, 0.92f, 0.96f}, 0},
    {"dentin", {0.97f, 0.77f, 0.47f}, 1},
    {"pulp", {0.78f, 0.10f, 0.17f}, 2},
    {"cement", {0.76f, 0.66f, 0.52f}, 0},
    {"bone", {0.86f, 0.84f, 0.76f}, std::nullopt},
    {"tooth", {0.93f, 0.87f, 0.74f}, 1},
    {"external", {0.93f, 0.87f, 0.74f}, 1},
}};

const Tissue* tissue_called(std::string_view structure) {
  std::string name(structure);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Tissue& tissue : tissues)
    if (name.find(tissue.part_of_name) != std::string::npos) return &tissue;
  return nullptr;
}

constexpr std::array<Colour, 6> distinguishable = {{
    {0.34f, 0.71f, 0.91f},
    {0.90f, 0.62f, 0.00f},
    {0.00f, 0.62f, 0.45f},
    {0.80f, 0.47f, 0.65f},
    {0.94f, 0.89f, 0.26f},
    {0.00f, 0.45f, 0.70f},
}};

int channel(float value) { return static_cast<int>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f))); }

}  // namespace

glm::vec3 linear(const Colour& colour) { return {linear(colour.red), linear(colour.green), linear(colour.blue)}; }

Colour colour_from_hex(std::string_view text) {
  unsigned value = 0;
  const char* end = text.data() + text.size();
  const bool digits = text.size() == 7 && text[0] == '#' && std::from_chars(text.data() + 1, end, value, 16).ptr == end;
  if (!digits) throw UsageError(fmt::format("\"{}\" is no colour", text), "Write it as # and six hexadecimal digits: #f2e9d8.");
  const auto part = [value](unsigned shift) { return static_cast<float>(value >> shift & 0xffu) / 255.0f; };
  return {part(16), part(8), part(0)};
}

std::string hex(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", channel(colour.red), channel(colour.green), channel(colour.blue));
}

Colour usual_colour(std::string_view structure, std::size_t index) {
  const Tissue* tissue = tissue_called(structure);
  return tissue ? tissue->colour : distinguishable[index % distinguishable.size()];
}

std::optional<int> depth_in_tooth(std::string_view structure) {
  const Tissue* tissue = tissue_called(structure);
  return tissue ? tissue->depth : std::nullopt;
}

}  // namespace odontoscope
