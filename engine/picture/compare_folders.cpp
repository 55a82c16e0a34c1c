#include "engine/picture/compare_folders.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "engine/picture/png.h"
#include "recon/core/error.h"
#include "recon/core/lower_case.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;
using Look = std::function<void(const ComparedPicture&, const PicturesCompared&)>;

/// More than any set of screenshots that a person could look through.
constexpr std::size_t most_pictures = 100'000;

/// Where each picture lies, by its name below the folder.
std::map<std::string, std::string> pictures_in(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw FileError(folder, "is no folder", "Give two folders of PNGs, or two PNGs");
  std::map<std::string, std::string> pictures;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code gone;
    if (!entry->is_regular_file(gone) || lower_case(entry->path().extension().string()) != ".png") continue;
    pictures.emplace(entry->path().lexically_relative(folder).generic_string(), entry->path().string());
    if (pictures.size() > most_pictures)
      throw FileError(folder, fmt::format("holds more than {} pictures", most_pictures), "Give a folder of fewer");
  }
  if (error) throw FileError(folder, "cannot be listed: " + error.message(), "Check its permissions");
  return pictures;
}

/// The mask for a picture: of the folder of masks, or the one for all.
class Masks {
 public:
  explicit Masks(std::string from) : from_(std::move(from)) {
    std::error_code error;
    if (from_.empty() || fs::is_directory(from_, error)) return;
    for_all_ = read_png(from_);
    from_.clear();
  }
  std::optional<Image> of(const std::string& name) const {
    if (for_all_) return for_all_;
    std::error_code error;
    const fs::path file = fs::path(from_) / name;
    if (from_.empty() || !fs::exists(file, error)) return std::nullopt;
    return read_png(file.string());
  }

 private:
  std::string from_;
  std::optional<Image> for_all_;
};

void compare_pair(ComparedPicture& picture, PicturesCompared& both, const std::string& expected,
                  const std::string& actual, const Masks& masks, const ImageTolerance& tolerance) {
  both.expected = read_png(expected);
  picture.expected_width = both.expected.width, picture.expected_height = both.expected.height;
  both.actual = read_png(actual);
  picture.actual_width = both.actual.width, picture.actual_height = both.actual.height;
  const std::optional<Image> mask = masks.of(picture.name);
  picture.masked = mask.has_value();
  if (mask) both.mask = *mask;
  if (mask && (mask->width != both.expected.width || mask->height != both.expected.height)) {
    throw InputError("mask-size", {},
                     fmt::format("the mask has {} x {} pixels, the picture expected {} x {}", mask->width, mask->height,
                                 both.expected.width, both.expected.height),
                     "Make a mask of the picture's size");
  }
  picture.difference = compare(both.expected, both.actual, tolerance, mask ? &*mask : nullptr);
  picture.outcome = picture.difference.within_tolerance ? PictureOutcome::alike : PictureOutcome::different;
}

/// What cannot be read is told, and stops nothing.
void compare_or_tell(ComparedPicture& picture, PicturesCompared& both, const std::string& expected,
                     const std::string& actual, const Masks& masks, const ImageTolerance& tolerance) {
  try {
    compare_pair(picture, both, expected, actual, masks, tolerance);
  } catch (const InputError& error) {
    picture.outcome = PictureOutcome::unreadable;
    picture.cause = error.cause();
    picture.message = error.what();
  } catch (const FileError& error) {
    picture.outcome = PictureOutcome::unreadable;
    picture.message = error.what();
  }
}

void read_alone(ComparedPicture& picture, Image& into, int& width, int& height, const std::string& file) {
  try {
    into = read_png(file);
    width = into.width, height = into.height;
  } catch (const Error& error) {
    picture.message = error.what();
  }
}

}  // namespace

const char* name(PictureOutcome outcome) {
  switch (outcome) {
    case PictureOutcome::alike:
      return "alike";
    case PictureOutcome::different:
      return "different";
    case PictureOutcome::missing:
      return "missing";
    case PictureOutcome::unexpected:
      return "unexpected";
    case PictureOutcome::unreadable:
      break;
  }
  return "unreadable";
}

std::vector<ComparedPicture> compare_folders(const std::string& expected, const std::string& actual,
                                             const CompareFoldersOptions& options, const Look& look,
                                             const Progress& progress) {
  const Masks masks(options.mask);
  const auto wanted = pictures_in(expected), there = pictures_in(actual);
  std::map<std::string, ComparedPicture> by_name;
  for (const auto* pictures : {&wanted, &there})
    for (const auto& [name, file] : *pictures) by_name[name].name = name;
  std::vector<ComparedPicture> compared;
  for (auto& [name, picture] : by_name) {
    progress.check();
    PicturesCompared both;
    const auto first = wanted.find(name), second = there.find(name);
    if (second == there.end()) {
      picture.outcome = PictureOutcome::missing;
      read_alone(picture, both.expected, picture.expected_width, picture.expected_height, first->second);
    } else if (first == wanted.end()) {
      picture.outcome = PictureOutcome::unexpected;
      read_alone(picture, both.actual, picture.actual_width, picture.actual_height, second->second);
    } else {
      compare_or_tell(picture, both, first->second, second->second, masks, options.tolerance);
    }
    if (picture.outcome != PictureOutcome::alike) look(picture, both);
    compared.push_back(std::move(picture));
    progress.tell("compare", static_cast<double>(compared.size()) / static_cast<double>(by_name.size()));
  }
  return compared;
}

ComparedPicture compare_files(const std::string& expected, const std::string& actual,
                              const CompareFoldersOptions& options, const Look& look) {
  ComparedPicture picture;
  picture.name = fs::path(actual).filename().string();
  PicturesCompared both;
  compare_pair(picture, both, expected, actual, Masks(options.mask), options.tolerance);
  if (picture.outcome != PictureOutcome::alike) look(picture, both);
  return picture;
}

}  // namespace odontoscope
