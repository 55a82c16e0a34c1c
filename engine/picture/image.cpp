#include "engine/picture/image.h"

#include <cstdlib>
#include <set>

namespace odontoscope {

namespace {

constexpr int background_tolerance = 8;
constexpr int bits_dropped = 3;

std::size_t offset(const Image& image, int x, int y) {
  return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
}

}  // namespace

std::array<std::uint8_t, 4> Image::pixel(int x, int y) const {
  const std::size_t at = offset(*this, x, y);
  return {rgba[at], rgba[at + 1], rgba[at + 2], rgba[at + 3]};
}

void Image::set_pixel(int x, int y, const std::array<std::uint8_t, 4>& value) {
  const std::size_t at = offset(*this, x, y);
  for (std::size_t channel = 0; channel < 4; ++channel) rgba[at + channel] = value[channel];
}

ImageContent content_of(const Image& image) {
  ImageContent content;
  if (image.rgba.empty()) return content;
  std::set<std::uint32_t> colours;
  std::size_t different = 0;
  for (std::size_t at = 0; at < image.rgba.size(); at += 4) {
    std::uint32_t colour = 0;
    bool differs = false;
    for (std::size_t channel = 0; channel < 4; ++channel) {
      const int value = image.rgba[at + channel];
      colour = colour << 8 | static_cast<std::uint32_t>(value >> bits_dropped);
      differs = differs || std::abs(value - image.rgba[channel]) > background_tolerance;
    }
    different += differs;
    colours.insert(colour);
  }
  content.coverage = static_cast<double>(different) / (static_cast<double>(image.rgba.size()) / 4);
  content.colours = colours.size();
  return content;
}

}  // namespace odontoscope
