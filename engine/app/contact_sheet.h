#pragma once
// Many pictures as one, each with a line of words below it.

#include <string>
#include <vector>

#include "engine/picture/image.h"

namespace odontoscope::app {

struct SheetSize {
  int columns = 4, rows = 3;
};
/// "4x3". UsageError; at most 20 a side.
SheetSize sheet_from(const std::string& text);

struct SheetPicture {
  Image image;
  std::string words;  // what is seen: "canal, 3.2 mm deep"
  std::string time;   // "12 s"; stands at the right, if there is room
};

/// UsageError if a sheet of pictures of that size would be larger than a picture may be.
void refuse_too_large(const SheetSize& sheet, int width, int height);

/// Row by row from the upper left, with room between them; words too long for their picture are cut short.
/// Preconditions: columns * rows pictures of one size, and not too large.
Image contact_sheet(const std::vector<SheetPicture>& pictures, const SheetSize& size);

}  // namespace odontoscope::app
