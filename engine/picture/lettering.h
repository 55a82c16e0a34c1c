#pragma once
// Words on a picture.

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "engine/picture/image.h"

namespace odontoscope {

/// Draws in one typeface at one size, without a graphics card.
class Lettering {
 public:
  /// The bytes of a TrueType or OpenType file, which must outlive it; letters are so many pixels high from the lowest
  /// descender to the highest ascender. InternalError if it is no font.
  Lettering(std::span<const unsigned char> font, double height);
  ~Lettering();

  double height() const;
  /// Pixels that the words take from left to right. UTF-8; what the font lacks is left out.
  double width(std::string_view words) const;
  /// The words' upper left corner at (x, y). Colour over what is there; what lies outside the picture is cut off.
  void draw(Image& image, std::string_view words, double x, double y, std::array<std::uint8_t, 3> colour) const;

 private:
  struct Face;
  std::unique_ptr<Face> face_;
};

}  // namespace odontoscope
