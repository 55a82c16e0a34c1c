#pragma once
// A picture in memory, and what can be said of it without looking.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace odontoscope {

/// Pixels a side that a picture may have: what every driver of OpenGL 4.1 can draw.
inline constexpr int most_picture_side = 16'384;

/// 8 bits a channel: red, green, blue (sRGB encoded), alpha (not premultiplied); rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // 4 * width * height

  Image() = default;
  Image(int w, int h) : width(w), height(h), rgba(4 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  std::array<std::uint8_t, 4> pixel(int x, int y) const;
  void set_pixel(int x, int y, const std::array<std::uint8_t, 4>& value);
  friend bool operator==(const Image&, const Image&) = default;
};

/// Tells a picture from an empty one.
struct ImageContent {
  /// Share of pixels that differ from the top left one by more than 8 of 255 in some channel.
  double coverage = 0;
  /// Distinct colours, each channel reduced to 5 bits.
  std::size_t colours = 0;

  /// At least 1 % covered, in at least 16 colours: a lit surface, neither a blank nor a flat silhouette.
  bool shows_something() const { return coverage >= 0.01 && colours >= 16; }
};

ImageContent content_of(const Image& image);

}  // namespace odontoscope
