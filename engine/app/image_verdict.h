#pragma once
// What compare-images found, for scripts and for people.

#include <cstddef>
#include <string>
#include <vector>

#include "engine/picture/compare_folders.h"

namespace odontoscope::app {

/// JSON: the tolerance, counts by outcome, and every picture. docs/screenshot-tests.md describes the keys.
std::string image_verdict_text(const std::string& expected, const std::string& actual, const ImageTolerance& tolerance,
                               const std::vector<ComparedPicture>& pictures);

/// "different: 1 of 200 pixels (0.500 %) differ by more than 2 of 255, the most by 9; similarity 0.9987".
std::string in_words(const ComparedPicture& picture, const ImageTolerance& tolerance);

/// One HTML file that asks the network for nothing: of each failure what was expected, what came, where they differ,
/// and that place near to. A slider lays one over the other. Pictures are encoded anew, so that nothing of a file but
/// its pixels gets in. Beyond `most_bytes` of pictures, failures are told in words alone.
class FailuresPage {
 public:
  explicit FailuresPage(ImageTolerance tolerance) : tolerance_(tolerance) {}
  void add(const ComparedPicture& picture, const PicturesCompared& both);
  std::string html(const std::string& expected, const std::string& actual,
                   const std::vector<ComparedPicture>& pictures) const;

  static constexpr std::size_t most_bytes = 200u << 20;

 private:
  enum class Shown { whole, near_to };
  std::string figure(const Image& image, const std::string& caption, Shown shown = Shown::whole);

  ImageTolerance tolerance_;
  std::string sections_;
  std::size_t bytes_ = 0, without_pictures_ = 0;
};

}  // namespace odontoscope::app
