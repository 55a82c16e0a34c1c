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
#include "recon/volume/dicom_directory.h"
#include "recon/volume/dicom_segmentation.h"
#include "recon/volume/dicom_stack.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;

std::string key_of(const DicomFile& file) {
  std::string uid = file.data.text(dicom::series_uid);
  if (file.data.number(dicom::frames).value_or(1) <= 1 && !is_dicom_segmentation(file)) return uid;
  const std::string whole = file.data.text(dicom::concatenation_uid);
  return uid + "\n" + (whole.empty() ? file.data.text(dicom::instance_uid) + file.path : whole);
}

SeriesOffer offer_of(const DicomSeries& series) {
  const DicomFile& first = series.files.front();
  SeriesOffer offer;
  offer.modality = tamed(first.data.text(dicom::modality));
  offer.description = tamed(first.data.text(dicom::series_description));
  offer.first_file = first.path;
  offer.files = series.files.size();
  std::vector<DicomImage> images;
  try {
    for (const DicomFile& file : series.files) {
      if (auto image = dicom_image(file)) images.push_back(std::move(*image));
    }
  } catch (const InputError& error) {
    offer.trouble = error.cause();
    return offer;
  }
  if (images.empty()) return offer;
  if (is_dicom_segmentation(first)) {
    offer.segments = segment_names(images.front());
    return offer;
  }
  std::vector<const DicomImage*> all;
  for (const DicomImage& image : images) {
    all.push_back(&image);
    offer.slices += image.frames.size();
  }
  offer.columns = images[0].columns;
  offer.rows = images[0].rows;
  offer.pixel_mm = images[0].frames[0].spacing;
  offer.apart_mm = slice_spacing_of(all);
  return offer;
}

}  // namespace

std::string tamed(const std::string& text) {
  std::string result = text.substr(0, limits::quoted_length);
  for (char& c : result) c = static_cast<unsigned char>(c) < ' ' || c == 127 || c == '"' ? ' ' : c;
  return result;
}

// Folders that are links are not followed: they may lead round in a circle.
std::vector<std::string> dicom_candidates(const std::string& folder, Depth depth, const Progress& progress) {
  std::vector<std::string> files;
  std::error_code error;
  std::size_t seen = 0;
  fs::recursive_directory_iterator at(folder, error);
  for (const fs::recursive_directory_iterator end; !error && at != end; at.increment(error)) {
    if (++seen > limits::dicom_files) {
      throw InputError("too-many-files", in_file(folder),
                       fmt::format("there are more than {} files in it", limits::dicom_files),
                       "put the series alone into a folder");
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

DicomFolder dicom_series_of(const std::vector<std::string>& files, const Progress& progress) {
  DicomFolder result;
  std::map<std::string, std::size_t> numbers;
  for (std::size_t n = 0; n < files.size(); ++n) {
    progress.check();
    progress.tell("list", static_cast<double>(n) / static_cast<double>(files.size()));
    DicomFile file = read_dicom_file(files[n]);
    if (is_dicom_directory(file)) continue;  // harms nothing here, even if it is damaged
    const bool tells_series = !file.data.text(dicom::series_uid).empty();
    if (!tells_series && is_dicom_image(file) && file.pixels.tag == 0 && !file.trouble) {
      file.trouble = InputError("truncated-volume", in_file(file.path), "the image's pixels are missing",
                                "get a whole copy of the file");
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

DicomFolder dicom_folder(const std::string& folder, Depth depth, const Progress& progress) {
  return dicom_series_of(dicom_candidates(folder, depth, progress), progress);
}

std::vector<SeriesOffer> offers_of(const DicomFolder& folder) {
  std::vector<SeriesOffer> offers;
  for (const DicomSeries& series : folder.series) offers.push_back(offer_of(series));
  return offers;
}

std::string in_words(const SeriesOffer& offer, std::size_t number) {
  std::string words = fmt::format("{}: {}", number, offer.modality.empty() ? "images" : offer.modality);
  if (!offer.description.empty()) words += fmt::format(" \"{}\"", offer.description);
  if (!offer.segments.empty()) words += fmt::format(", segments {}", fmt::join(offer.segments, ", "));
  if (offer.slices > 0) words += fmt::format(", {} x {} pixels", offer.columns, offer.rows);
  if (offer.pixel_mm) words += fmt::format(" of {:.4g} x {:.4g} mm", (*offer.pixel_mm)[0], (*offer.pixel_mm)[1]);
  if (offer.slices > 0) words += fmt::format(", {} {}", offer.slices, offer.slices == 1 ? "slice" : "slices");
  if (offer.apart_mm) words += fmt::format(" {:.4g} mm apart", *offer.apart_mm);
  words += fmt::format(", in {}", offer.first_file);
  if (offer.files > 1) words += fmt::format(" and {} more", offer.files - 1);
  return offer.trouble.empty() ? words : fmt::format("{} [{}]", words, offer.trouble);
}

std::vector<std::size_t> series_named(const DicomFolder& folder, const std::string& wanted) {
  std::size_t number = 0;
  const char* whole = wanted.data() + wanted.size();
  const auto [end, error] = std::from_chars(wanted.data(), whole, number);
  if (error == std::errc{} && end == whole && number >= 1 && number <= folder.series.size()) return {number - 1};
  std::vector<std::size_t> found;
  for (std::size_t n = 0; n < folder.series.size(); ++n) {
    const DicomSeries& series = folder.series[n];
    const std::string description = series.files.front().data.text(dicom::series_description);
    if (series.uid == wanted || lower_case(description) == lower_case(wanted)) found.push_back(n);
  }
  return found;
}

std::size_t chosen_series(const DicomFolder& folder, const std::string& wanted, const std::string& path) {
  const std::vector<std::size_t> found = series_named(folder, wanted);
  if (found.size() == 1) return found.front();
  const char* how_many = found.empty() ? "there is no" : "several are the";
  throw InputError("no-such-series", in_file(path),
                   fmt::format("{} series of images \"{}\". There are:\n{}", how_many, wanted.substr(0, 80),
                               list_of(offers_of(folder))),
                   "Choose one by its number (--series N)");
}

std::string list_of(const std::vector<SeriesOffer>& offers) {
  constexpr std::size_t most_lines = 40;
  std::string list;
  for (std::size_t n = 0; n < std::min(offers.size(), most_lines); ++n)
    list += fmt::format("  {}\n", in_words(offers[n], n + 1));
  if (offers.size() > most_lines) list += fmt::format("  and {} more\n", offers.size() - most_lines);
  if (!list.empty()) list.pop_back();  // a message goes on behind it
  return list;
}

}  // namespace odontoscope
