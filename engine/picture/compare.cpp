#include "engine/picture/compare.h"

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
  const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  const auto [red, green, blue, alpha] = seen(image, at);
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue + 255 - alpha;
}

double block_similarity(const Image& a, const Image& b, int left, int top) {
  const int right = std::min(left + block, a.width), bottom = std::min(top + block, a.height);
  double sum_a = 0, sum_b = 0, sum_aa = 0, sum_bb = 0, sum_ab = 0;
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      const double la = luminance(a, x, y), lb = luminance(b, x, y);
      sum_a += la, sum_b += lb, sum_aa += la * la, sum_bb += lb * lb, sum_ab += la * lb;
    }
  const double count = static_cast<double>((right - left) * (bottom - top));
  const double mean_a = sum_a / count, mean_b = sum_b / count;
  const double variance_a = sum_aa / count - mean_a * mean_a, variance_b = sum_bb / count - mean_b * mean_b;
  const double covariance = sum_ab / count - mean_a * mean_b;
  return (2 * mean_a * mean_b + stabilise_mean) * (2 * covariance + stabilise_variance) /
         ((mean_a * mean_a + mean_b * mean_b + stabilise_mean) * (variance_a + variance_b + stabilise_variance));
}

double mean_similarity(const Image& a, const Image& b) {
  double sum = 0;
  std::size_t blocks = 0;
  for (int top = 0; top < a.height; top += block)
    for (int left = 0; left < a.width; left += block, ++blocks) sum += block_similarity(a, b, left, top);
  return blocks == 0 ? 1 : sum / static_cast<double>(blocks);
}

}  // namespace

ImageDifference compare(const Image& a, const Image& b, const ImageTolerance& tolerance) {
  ImageDifference difference;
  difference.same_size = a.width == b.width && a.height == b.height;
  if (!difference.same_size) return difference;
  for (std::size_t at = 0; at < a.rgba.size(); at += 4) {
    const int largest = largest_difference(seen(a, at), seen(b, at));
    difference.largest = std::max(difference.largest, largest);
    difference.pixels += largest > tolerance.channel;
  }
  const double all = std::max(1.0, static_cast<double>(a.rgba.size()) / 4);
  difference.share = static_cast<double>(difference.pixels) / all;
  difference.similarity = mean_similarity(a, b);
  difference.within_tolerance = difference.share <= tolerance.share;
  return difference;
}

Image difference_picture(const Image& a, const Image& b) {
  Image picture(a.width, a.height);
  for (std::size_t at = 0; at < a.rgba.size(); at += 4) {
    const auto seen_a = seen(a, at), seen_b = seen(b, at);
    const int alpha = std::abs(seen_a[3] - seen_b[3]);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const int difference = std::max(std::abs(seen_a[channel] - seen_b[channel]), alpha);
      picture.rgba[at + channel] = static_cast<std::uint8_t>(difference == 0 ? 0 : std::min(255, least_visible + stretch * difference));
    }
    picture.rgba[at + 3] = 255;
  }
  return picture;
}

}  // namespace odontoscope
