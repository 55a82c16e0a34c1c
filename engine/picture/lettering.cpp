#include "engine/picture/lettering.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "recon/core/error.h"

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

namespace odontoscope {
namespace {

/// The next letter's number; bytes that are no UTF-8 count as themselves.
int next_letter(std::string_view& words) {
  const auto byte = [&](std::size_t i) { return i < words.size() ? static_cast<unsigned char>(words[i]) : 0u; };
  const unsigned first = byte(0);
  const std::size_t more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
  unsigned letter = more == 0 ? first : first & (0x3fu >> more);
  for (std::size_t i = 1; i <= more; ++i) letter = letter << 6 | (byte(i) & 0x3f);
  words.remove_prefix(std::min(words.size(), more + 1));
  return static_cast<int>(letter);
}

}  // namespace

struct Lettering::Face {
  stbtt_fontinfo font{};
  double height = 0;
  float scale = 0;  // pixels a unit of the font
  int ascent = 0;

  double advance(int glyph) const {
    int advance = 0;
    stbtt_GetGlyphHMetrics(&font, glyph, &advance, nullptr);
    return scale * static_cast<float>(advance);
  }
};

Lettering::Lettering(std::span<const unsigned char> font, double height) : face_(std::make_unique<Face>()) {
  if (stbtt_InitFont(&face_->font, font.data(), 0) == 0) throw InternalError("the embedded typeface is none");
  face_->height = height;
  face_->scale = stbtt_ScaleForPixelHeight(&face_->font, static_cast<float>(height));
  stbtt_GetFontVMetrics(&face_->font, &face_->ascent, nullptr, nullptr);
}

Lettering::~Lettering() = default;

double Lettering::height() const { return face_->height; }

double Lettering::width(std::string_view words) const {
  double width = 0;
  while (!words.empty()) {
    const int glyph = stbtt_FindGlyphIndex(&face_->font, next_letter(words));
    if (glyph != 0) width += face_->advance(glyph);
  }
  return width;
}

void Lettering::draw(Image& image, std::string_view words, double x, double y,
                     std::array<std::uint8_t, 3> colour) const {
  const double line = std::round(y + face_->scale * static_cast<float>(face_->ascent));
  while (!words.empty()) {
    const int glyph = stbtt_FindGlyphIndex(&face_->font, next_letter(words));
    if (glyph == 0) continue;
    const double pixel = std::floor(x);
    int left = 0, top = 0, right = 0, bottom = 0;
    const auto shift = static_cast<float>(x - pixel);
    stbtt_GetGlyphBitmapBoxSubpixel(&face_->font, glyph, face_->scale, face_->scale, shift, 0, &left, &top, &right,
                                    &bottom);
    const int width = right - left, height = bottom - top;
    std::vector<unsigned char> cover(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    if (!cover.empty())
      stbtt_MakeGlyphBitmapSubpixel(&face_->font, cover.data(), width, height, width, face_->scale, face_->scale, shift,
                                    0, glyph);
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const int px = static_cast<int>(pixel) + left + column, py = static_cast<int>(line) + top + row;
        if (px < 0 || py < 0 || px >= image.width || py >= image.height) continue;
        const unsigned share =
            cover[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
        std::array<std::uint8_t, 4> there = image.pixel(px, py);
        for (std::size_t k = 0; k < 3; ++k)
          there[k] = static_cast<std::uint8_t>((share * colour[k] + (255 - share) * there[k] + 127) / 255);
        there[3] = static_cast<std::uint8_t>(share + (255 - share) * there[3] / 255);
        image.set_pixel(px, py, there);
      }
    }
    x += face_->advance(glyph);
  }
}

}  // namespace odontoscope
