#pragma once
// Are two pictures the same, to a tolerance of two numbers? And how alike do they look?

#include <cstddef>

#include "engine/picture/image.h"

namespace odontoscope {

/// Two pictures agree if no more than `share` of the pixels differ by more than `channel` in any channel. The defaults
/// are what the same program shows on processors with other instruction sets, doubled.
struct ImageTolerance {
  int channel = 2;       // of 255
  double share = 0.01;   // of all pixels
};

struct ImageDifference {
  bool same_size = false;
  int largest = 0;                // of 255, over all channels
  std::size_t pixels = 0;         // that differ by more than the tolerated channel difference
  double share = 1;               // the same as part of all pixels
  /// Mean structural similarity of the luminance (Wang, Bovik, Sheikh, Simoncelli, IEEE TIP 13(4), 2004) over 8 x 8 blocks:
  /// 1 for equal pictures, below 0.95 visibly different. 0 if the sizes differ.
  double similarity = 0;
  bool within_tolerance = false;
};

/// Pictures of different size never agree. Transparent pixels are compared with their colour multiplied by alpha.
ImageDifference compare(const Image& a, const Image& b, const ImageTolerance& tolerance = {});

/// Black where equal; otherwise the channel differences, stretched so that 1 of 255 can be seen. Precondition: same size.
Image difference_picture(const Image& a, const Image& b);

}  // namespace odontoscope
