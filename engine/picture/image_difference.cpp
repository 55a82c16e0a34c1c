#include "engine/picture/image_difference.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace odontoscope {

namespace {

constexpr int block = 8;
// Constants of the structural similarity: (0.01 * 255)^2 and (0.03 * 255)^2.
constexpr double stabilise_mean = 6.5025;
constexpr double stabilise_variance = 58.5225;
// A difference of 1 of 255 becomes visible, one of 30 white.
constexpr int least_visible = 40;
constexpr int stretch = 8;

/// Premultiplied, so that invisible colour does not count.
std::array<int, 4> seen(const Image& image, std::size_t at) {
  const int alpha = image.rgba[at + 3];
  return {image.rgba[at] * alpha / 255, image.rgba[at + 1] * alpha / 255, image.rgba[at + 2] * alpha / 255, alpha};
}

int largest_difference(const std::array<int, 4>& a, const std::array<int, 4>& b) {
  int largest = 0;
  for (std::size_t channel = 0; channel < 4; ++channel) largest = std::max(largest, std::abs(a[channel] - b[channel]));
  return largest;
}

double luminance(const Image& image, int x, int y) {
  const std::size_t at =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  const auto [red, green, blue, alpha] = seen(image, at);
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue + 255 - alpha;
}

/// Null: all of it.
bool is_compared(const Image* mask, int x, int y) {
  if (mask == nullptr) return true;
  constexpr double half = 127.5;
  const std::size_t at =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(mask->width) + static_cast<std::size_t>(x));
  const auto [red, green, blue, alpha] = seen(*mask, at);
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue > half;
}

/// Nothing where no pixel of the block is compared.
std::optional<double> block_similarity(const Image& a, const Image& b, const Image* mask, int left, int top) {
  const int right = std::min(left + block, a.width), bottom = std::min(top + block, a.height);
  double count = 0, sum_a = 0, sum_b = 0, sum_aa = 0, sum_bb = 0, sum_ab = 0;
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      if (!is_compared(mask, x, y)) continue;
      const double la = luminance(a, x, y), lb = luminance(b, x, y);
      ++count;
      sum_a += la, sum_b += lb, sum_aa += la * la, sum_bb += lb * lb, sum_ab += la * lb;
    }
  if (count == 0) return std::nullopt;
  const double mean_a = sum_a / count, mean_b = sum_b / count;
  const double variance_a = sum_aa / count - mean_a * mean_a, variance_b = sum_bb / count - mean_b * mean_b;
  const double covariance = sum_ab / count - mean_a * mean_b;
  return (2 * mean_a * mean_b + stabilise_mean) * (2 * covariance + stabilise_variance) /
         ((mean_a * mean_a + mean_b * mean_b + stabilise_mean) * (variance_a + variance_b + stabilise_variance));
}

double mean_similarity(const Image& a, const Image& b, const Image* mask) {
  double sum = 0;
  std::size_t blocks = 0;
  for (int top = 0; top < a.height; top += block)
    for (int left = 0; left < a.width; left += block)
      if (const auto similarity = block_similarity(a, b, mask, left, top)) sum += *similarity, ++blocks;
  return blocks == 0 ? 1 : sum / static_cast<double>(blocks);
}

}  // namespace

ImageDifference compare(const Image& a, const Image& b, const ImageTolerance& tolerance, const Image* mask) {
  ImageDifference difference;
  difference.same_size = a.width == b.width && a.height == b.height;
  if (!difference.same_size) return difference;
  std::size_t at = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x, at += 4) {
      if (!is_compared(mask, x, y)) continue;
      ++difference.compared;
      const int largest = largest_difference(seen(a, at), seen(b, at));
      difference.largest = std::max(difference.largest, largest);
      if (largest <= tolerance.channel) continue;
      ++difference.pixels;
      if (!difference.box) difference.box = PixelBox{x, y, x, y};
      PixelBox& box = *difference.box;
      box = {std::min(box.left, x), box.top, std::max(box.right, x), y};
    }
  difference.share = static_cast<double>(difference.pixels) / std::max(1.0, static_cast<double>(difference.compared));
  difference.similarity = mean_similarity(a, b, mask);
  const bool any = difference.compared > 0 || mask == nullptr;
  difference.within_tolerance =
      any && difference.share <= tolerance.share && difference.similarity >= tolerance.similarity;
  return difference;
}

Image cropped(const Image& image, const PixelBox& box) {
  Image part(box.right - box.left + 1, box.bottom - box.top + 1);
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x) part.set_pixel(x, y, image.pixel(box.left + x, box.top + y));
  return part;
}

Image difference_picture(const Image& a, const Image& b, const Image* mask) {
  constexpr std::array<std::uint8_t, 4> left_out{0, 0, 64, 255};
  Image picture(a.width, a.height);
  for (std::size_t at = 0; at < a.rgba.size(); at += 4) {
    const auto pixel = static_cast<int>(at / 4);
    if (!is_compared(mask, pixel % a.width, pixel / a.width)) {
      std::copy(left_out.begin(), left_out.end(), picture.rgba.begin() + static_cast<std::ptrdiff_t>(at));
      continue;
    }
    const auto seen_a = seen(a, at), seen_b = seen(b, at);
    const int alpha = std::abs(seen_a[3] - seen_b[3]);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const int difference = std::max(std::abs(seen_a[channel] - seen_b[channel]), alpha);
      picture.rgba[at + channel] =
          static_cast<std::uint8_t>(difference == 0 ? 0 : std::min(255, least_visible + stretch * difference));
    }
    picture.rgba[at + 3] = 255;
  }
  return picture;
}

}  // namespace odontoscope
