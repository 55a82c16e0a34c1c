#pragma once
// Are two pictures the same, to a tolerance of two numbers? And how alike do they look?

#include <cstddef>
#include <optional>

#include "engine/picture/image.h"

namespace odontoscope {

/// Two pictures agree if no more than `share` of the pixels differ by more than `channel` in any channel. The defaults
/// are what the same program shows on processors with other instruction sets, doubled.
struct ImageTolerance {
  int channel = 2;         // of 255
  double share = 0.01;     // of all pixels that are compared
  double similarity = -1;  // least that the pictures must have, see ImageDifference; -1: whatever it is
};

/// The smallest rectangle around some pixels: from the first column and row to the last, both within.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

struct ImageDifference {
  bool same_size = false;
  int largest = 0;              // of 255, over all channels
  std::size_t compared = 0;     // pixels: all, or what a mask leaves
  std::size_t pixels = 0;       // that differ by more than the tolerated channel difference
  double share = 1;             // the same as part of those compared
  std::optional<PixelBox> box;  // around them
  /// Mean structural similarity of the luminance (Wang, Bovik, Sheikh, Simoncelli, IEEE TIP 13(4), 2004) over 8 x 8
  /// blocks, as far as they are compared: 1 for equal pictures, below 0.95 visibly different. 0 if the sizes differ.
  double similarity = 0;
  bool within_tolerance = false;
};

/// Pictures of different size never agree. Transparent pixels are compared with their colour multiplied by alpha. With
/// a mask only those pixels are compared that are more light than dark in it (transparent counts as dark);
/// precondition: it is of `a`'s size. Where it leaves none, nothing agrees.
ImageDifference compare(const Image& a, const Image& b, const ImageTolerance& tolerance = {},
                        const Image* mask = nullptr);

/// Black where equal; otherwise the channel differences, stretched so that 1 of 255 can be seen. What a mask leaves out
/// is dark blue. Precondition: same size.
Image difference_picture(const Image& a, const Image& b, const Image* mask = nullptr);

/// Part of a picture. Precondition: the box lies within it.
Image cropped(const Image& image, const PixelBox& box);

}  // namespace odontoscope
