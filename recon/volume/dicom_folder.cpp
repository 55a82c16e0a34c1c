#include "recon/volume/dicom_folder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/lower_case.h"
#include "recon/volume/byte_source.h"
#include "recon/volume/dicom_segmentation.h"
#include "recon/volume/dicom_stack.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;

/// Plain files that may be DICOM, by name. Folders that are links are not followed: they may lead round in a circle.
std::vector<std::string> candidates(const std::string& folder, Depth depth, const Progress& progress) {
  std::vector<std::string> files;
  std::error_code error;
  std::size_t seen = 0;
  fs::recursive_directory_iterator at(folder, error);
  for (const fs::recursive_directory_iterator end; !error && at != end; at.increment(error)) {
    if (++seen > limits::dicom_files) {
      throw InputError("too-many-files", in_file(folder), fmt::format("there are more than {} files in it", limits::dicom_files), "put the series alone into a folder");
    }
    progress.check();
    std::error_code ignored;
    if (at->is_directory(ignored)) {
      if (depth == Depth::folder_only || at.depth() >= limits::dicom_folders) at.disable_recursion_pending();
      continue;
    }
    if (at->is_regular_file(ignored) && looks_like_dicom(at->path().string())) files.push_back(at->path().string());
  }
  if (error) throw FileError(folder, "cannot be listed: " + error.message(), "check its permissions");
  std::sort(files.begin(), files.end());
  return files;
}

std::string key_of(const DicomFile& file) {
  const std::string uid = file.data.text(dicom::series_uid);
  if (file.data.number(dicom::frames).value_or(1) <= 1 && !is_dicom_segmentation(file)) return uid;
  const std::string whole = file.data.text(dicom::concatenation_uid);
  return uid + "\n" + (whole.empty() ? file.data.text(dicom::instance_uid) + file.path : whole);
}

/// Printable, short.
std::string tamed(const std::string& text) {
  std::string result = text.substr(0, limits::quoted_length);
  for (char& c : result) c = static_cast<unsigned char>(c) < ' ' || c == 127 || c == '"' ? ' ' : c;
  return result;
}

}  // namespace

DicomFolder dicom_folder(const std::string& folder, Depth depth, const Progress& progress) {
  DicomFolder result;
  std::map<std::string, std::size_t> numbers;
  const std::vector<std::string> files = candidates(folder, depth, progress);
  for (std::size_t n = 0; n < files.size(); ++n) {
    progress.check();
    progress.tell("list", static_cast<double>(n) / static_cast<double>(files.size()));
    DicomFile file = read_dicom_file(files[n]);
    const bool tells_series = !file.data.text(dicom::series_uid).empty();
    if (!tells_series && is_dicom_image(file) && file.pixels.tag == 0 && !file.trouble) {
      file.trouble = InputError("truncated-volume", in_file(file.path), "the image's pixels are missing", "get a whole copy of the file");
    }
    if (file.trouble && !tells_series) {
      // Without the mark of DICOM it is rather no DICOM at all.
      if (file.has_preamble) result.unknown.push_back(std::move(file));
      continue;
    }
    if (!is_dicom_image(file)) continue;
    const auto [at, is_new] = numbers.emplace(key_of(file), result.series.size());
    if (is_new) result.series.push_back({file.data.text(dicom::series_uid), {}});
    result.series[at->second].files.push_back(std::move(file));
  }
  return result;
}

std::string in_words(const DicomSeries& series, std::size_t number) {
  const DicomFile& first = series.files.front();
  const std::string description = first.data.text(dicom::series_description), modality = first.data.text(dicom::modality);
  std::string words = fmt::format("{}: {}{}", number, modality.empty() ? "images" : tamed(modality), description.empty() ? "" : fmt::format(" \"{}\"", tamed(description)));
  const std::string place = fmt::format("in {}{}", first.path, series.files.size() == 1 ? "" : fmt::format(" and {} more", series.files.size() - 1));
  std::vector<DicomImage> images;
  try {
    for (const DicomFile& file : series.files) {
      if (auto image = dicom_image(file)) images.push_back(std::move(*image));
    }
  } catch (const InputError& error) {
    return fmt::format("{}, {} [{}]", words, place, error.cause());
  }
  if (images.empty()) return fmt::format("{}, {}", words, place);
  if (is_dicom_segmentation(first)) return fmt::format("{}, segments {}, {}", words, fmt::join(segment_names(images.front()), ", "), place);
  std::vector<const DicomImage*> all;
  std::size_t slices = 0;
  for (const DicomImage& image : images) {
    all.push_back(&image);
    slices += image.frames.size();
  }
  words += fmt::format(", {} x {} pixels", images[0].columns, images[0].rows);
  if (const auto& spacing = images[0].frames[0].spacing) words += fmt::format(" of {:.4g} x {:.4g} mm", (*spacing)[0], (*spacing)[1]);
  words += fmt::format(", {} {}", slices, slices == 1 ? "slice" : "slices");
  if (const std::optional<double> apart = slice_spacing_of(all)) words += fmt::format(" {:.4g} mm apart", *apart);
  return fmt::format("{}, {}", words, place);
}

std::size_t chosen_series(const DicomFolder& folder, const std::string& wanted, const std::string& path) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  if (error == std::errc{} && end == wanted.data() + wanted.size() && number >= 1 && number <= folder.series.size()) return number - 1;
  std::vector<std::size_t> found;
  for (std::size_t n = 0; n < folder.series.size(); ++n) {
    const DicomSeries& series = folder.series[n];
    const std::string description = series.files.front().data.text(dicom::series_description);
    if (series.uid == wanted || lower_case(description) == lower_case(wanted)) found.push_back(n);
  }
  if (found.size() == 1) return found.front();
  throw InputError("no-such-series", in_file(path),
                   fmt::format("{} series of images \"{}\". There are:\n{}", found.empty() ? "there is no" : "several are the", wanted.substr(0, 80), list_of(folder)),
                   "Choose one by its number (--series N)");
}

std::string list_of(const DicomFolder& folder) {
  constexpr std::size_t most_lines = 40;
  std::string list;
  for (std::size_t n = 0; n < std::min(folder.series.size(), most_lines); ++n) list += fmt::format("  {}\n", in_words(folder.series[n], n + 1));
  if (folder.series.size() > most_lines) list += fmt::format("  and {} more\n", folder.series.size() - most_lines);
  if (!list.empty()) list.pop_back();   // a message goes on behind it
  return list;
}

}  // namespace odontoscope
