#pragma once
// Colours as people write them (sRGB) and as light adds up (linear).

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace odontoscope {

/// sRGB encoded, each channel 0 to 1.
struct Colour {
  float red = 0, green = 0, blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// Linear light, ITU-R BT.709 primaries.
glm::vec3 linear(const Colour& colour);
/// Back again, 0 to 1.
Colour encoded(const glm::vec3& light);

/// 0xf2e9d8.
constexpr Colour colour_of(unsigned rgb) {
  return {static_cast<float>(rgb >> 16 & 0xffu) / 255, static_cast<float>(rgb >> 8 & 0xffu) / 255,
          static_cast<float>(rgb & 0xffu) / 255};
}

/// "#f2e9d8"; throws UsageError for anything but a hash and six hexadecimal digits.
Colour colour_from_hex(std::string_view hex);
std::string hex(const Colour& colour);

/// A colour for a structure by its name: enamel, dentine, pulp, cementum, bone, and their usual other spellings have
/// their own; others take turns in a set that the colour-blind can tell apart (Okabe and Ito, 2008), `index` choosing.
Colour usual_colour(std::string_view structure, std::size_t index);

/// How deep a tissue lies in a tooth, by its name: enamel and cementum 0, dentine (or a whole tooth) 1, pulp 2.
std::optional<int> depth_in_tooth(std::string_view structure);

}  // namespace odontoscope
