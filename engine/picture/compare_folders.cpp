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

/// Of a size, or 0 x 0.
using GetImage = std::function<Image(int width, int height)>;

GetImage from_file(const std::string& file) {
  return [file](int, int) { return read_png(file); };
}

void compare_pair(ComparedPicture& picture, PicturesCompared& both, const GetImage& expected, const GetImage& actual,
                  const Masks& masks, const ImageTolerance& tolerance) {
  both.expected = expected(0, 0);
  picture.expected_width = both.expected.width, picture.expected_height = both.expected.height;
  both.actual = actual(both.expected.width, both.expected.height);
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
void compare_or_tell(ComparedPicture& picture, PicturesCompared& both, const GetImage& expected, const GetImage& actual,
                     const Masks& masks, const ImageTolerance& tolerance) {
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

void read_alone(ComparedPicture& picture, Image& into, int& width, int& height, const GetImage& get) {
  try {
    into = get(0, 0);
    width = into.width, height = into.height;
  } catch (const InputError& error) {
    picture.message = error.what();
  } catch (const FileError& error) {
    picture.message = error.what();
  }
}

/// Of a folder, and those that are drawn as if they lay there.
std::map<std::string, GetImage> pictures_of(const std::string& folder, const PicturesToDraw& to_draw) {
  std::map<std::string, GetImage> pictures;
  for (const auto& [name, file] : pictures_in(folder)) pictures.emplace(name, from_file(file));
  for (const std::string& name : to_draw.names)
    pictures.emplace(name, [&to_draw, name](int width, int height) { return to_draw.draw(name, width, height); });
  return pictures;
}

}  // namespace

std::set<std::string> pictures_below(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& [name, file] : pictures_in(folder)) names.insert(name);
  return names;
}

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
  const std::map<std::string, GetImage> wanted = pictures_of(expected, {}),
                                        there = pictures_of(actual, options.to_draw);
  std::map<std::string, ComparedPicture> by_name;
  for (const auto* pictures : {&wanted, &there})
    for (const auto& [name, get] : *pictures) by_name[name].name = name;
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
  compare_pair(picture, both, from_file(expected), from_file(actual), Masks(options.mask), options.tolerance);
  if (picture.outcome != PictureOutcome::alike) look(picture, both);
  return picture;
}

}  // namespace odontoscope
