#include "engine/app/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "engine/picture/lettering.h"
#include "engine/ui/fonts.h"
#include "recon/core/error.h"

namespace odontoscope::app {
namespace {

using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb paper{24, 26, 30}, bright{236, 236, 232}, dim{160, 164, 170};

/// Pixels, of a sheet whose pictures are so large.
struct Layout {
  int gap = 0, letters = 0, line = 0, width = 0, height = 0;
  Layout(const SheetSize& size, int w, int h)
      : gap(std::max(4, w / 40)),
        letters(std::clamp(w / 18, 10, 28)),
        line(letters + gap),
        width(size.columns * (w + gap) + gap),
        height(size.rows * (h + line) + gap) {}
};

void copy(const Image& from, Image& to, int left, int top) {
  for (int y = 0; y < from.height; ++y) {
    const auto* row = from.rgba.data() + 4 * static_cast<std::size_t>(y) * static_cast<std::size_t>(from.width);
    std::copy(row, row + 4 * static_cast<std::size_t>(from.width),
              to.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(top + y) * to.width + left));
  }
}

/// The words, or as many of their letters as have room.
std::string shortened(const std::string& words, const Lettering& lettering, double room) {
  if (lettering.width(words) <= room) return words;
  const auto within_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; };  // UTF-8
  for (std::size_t length = words.size(); length-- > 1;) {
    if (within_letter(words[length]) || words[length - 1] == ' ' || words[length - 1] == ',') continue;
    std::string some = words.substr(0, length) + "\u2026";
    if (lettering.width(some) <= room) return some;
  }
  return {};
}

/// What is seen at the left, when at the right; where there is no room for both, the time is left out.
void letter(Image& sheet, const Lettering& lettering, const SheetPicture& picture, double left, double below) {
  const double room = picture.image.width, time = std::ceil(lettering.width(picture.time)),
               space = 0.5 * lettering.height();
  const bool both = lettering.width(picture.words) + space + time <= room;
  lettering.draw(sheet, shortened(picture.words, lettering, room), left, below, bright);
  if (both) lettering.draw(sheet, picture.time, left + room - time, below, dim);
}

}  // namespace

SheetSize sheet_from(const std::string& text) {
  SheetSize size;
  const char* const end = text.data() + text.size();
  const auto columns = std::from_chars(text.data(), end, size.columns);
  const bool both = columns.ec == std::errc() && columns.ptr != end && *columns.ptr == 'x' &&
                    std::from_chars(columns.ptr + 1, end, size.rows).ptr == end;
  constexpr int most = 20;
  if (!both || std::min(size.columns, size.rows) < 1 || std::max(size.columns, size.rows) > most)
    throw UsageError(fmt::format("--contact-sheet {}: these are no columns and rows", text),
                     fmt::format("Give both, 1 to {}: 4x3.", most));
  return size;
}

void refuse_too_large(const SheetSize& sheet, int width, int height) {
  const Layout layout(sheet, width, height);
  if (std::max(layout.width, layout.height) > most_picture_side)
    throw UsageError(fmt::format("--contact-sheet: {} x {} pixels are too many", layout.width, layout.height),
                     fmt::format("Give a smaller --size; a side has at most {}.", most_picture_side));
}

Image contact_sheet(const std::vector<SheetPicture>& pictures, const SheetSize& size) {
  const int width = pictures.front().image.width, height = pictures.front().image.height;
  const Layout layout(size, width, height);
  Image sheet(layout.width, layout.height);
  for (std::size_t i = 0; i < sheet.rgba.size(); ++i) sheet.rgba[i] = i % 4 == 3 ? 255 : paper[i % 4];
  const Lettering lettering(regular_font(), layout.letters);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int column = static_cast<int>(i) % size.columns, row = static_cast<int>(i) / size.columns;
    const int left = layout.gap + column * (width + layout.gap), top = layout.gap + row * (height + layout.line);
    copy(pictures[i].image, sheet, left, top);
    letter(sheet, lettering, pictures[i], left, top + height + 0.2 * layout.gap);
  }
  return sheet;
}

}  // namespace odontoscope::app
