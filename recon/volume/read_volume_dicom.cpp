#include "recon/volume/read_volume_dicom.h"

#include <fmt/format.h>
#include <itkGDCMImageIO.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <vector>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/volume/dicom_header.h"
#include "recon/volume/read_volume_itk.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;

Place in_file(const std::string& file) {
  Place place;
  place.file = file;
  return place;
}

/// Plain files of a folder that are DICOM images, by series; names sorted.
std::map<std::string, std::vector<std::string>> images_by_series(const std::string& folder, const Progress& progress) {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (!at->is_regular_file(ignored) || !is_dicom_file(at->path().string())) continue;
    files.push_back(at->path().string());
    if (files.size() > limits::slices) {
      throw InputError("too-many-voxels", in_file(folder), fmt::format("more than {} DICOM files", limits::slices),
                       "put the series alone into a folder");
    }
  }
  if (error) throw FileError(folder, "cannot be listed: " + error.message(), "check its permissions");
  std::sort(files.begin(), files.end());
  std::map<std::string, std::vector<std::string>> series;
  for (const std::string& file : files) {
    progress.check();
    const DicomHeader header = read_dicom_header(file);
    if (header.is_image) series[header.series].push_back(file);
  }
  return series;
}

std::vector<std::string> files_of_series(const std::string& path, const Progress& progress) {
  const bool folder_given = fs::is_directory(path);
  const fs::path parent = fs::path(path).parent_path();
  const std::string folder = folder_given ? path : parent.empty() ? "." : parent.string();
  const auto all = images_by_series(folder, progress);
  if (folder_given) {
    if (all.empty()) {
      throw InputError("no-dicom-images", in_file(path), "the folder holds no DICOM image",
                       "give the folder of a series");
    }
    if (all.size() > 1) {
      throw InputError("several-series", in_file(path),
                       fmt::format("the folder holds {} series; one begins with {}, another with {}", all.size(),
                                   all.begin()->second.front(), std::next(all.begin())->second.front()),
                       "give a file of the wanted series instead of the folder");
    }
    return all.begin()->second;
  }
  const DicomHeader own = read_dicom_header(path);
  const auto found = own.is_image ? all.find(own.series) : all.end();
  if (found == all.end()) {
    throw InputError("no-dicom-images", in_file(path), "the file is DICOM, but no image",
                     "give a file of an image series");
  }
  return found->second;
}

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 normal_of(const FileImage& image) {
  const Vector3 &a = image.direction[0], &b = image.direction[1];
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool alike(const FileImage& a, const FileImage& b) {
  bool same = a.size == b.size;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t n = 0; n < 2; ++n) {
      same = same && std::abs(a.direction[n][axis] - b.direction[n][axis]) <= limits::axes_out_of_square;
      same = same && std::abs(a.spacing[n] - b.spacing[n]) <= limits::slice_unevenness * a.spacing[n];
    }
  }
  return same;
}

void check_alike(const std::vector<OpenedImage>& slices) {
  const FileImage& first = slices.front().image;
  for (const OpenedImage& slice : slices) {
    if (slice.image.size[2] == 1 && alike(first, slice.image)) continue;
    throw InputError("mixed-series", in_file(slice.image.source),
                     fmt::format("its size, pixel spacing or orientation differs from that of {}", first.source),
                     "put the slices of one volume alone into a folder");
  }
}

/// Spacing of slices that are sorted along `normal`; checks that each lies straight above the last, at one distance.
double slice_spacing(const std::vector<OpenedImage>& slices, const Vector3& normal) {
  const Vector3 first = slices.front().image.origin, last = slices.back().image.origin;
  const Vector3 way{last[0] - first[0], last[1] - first[1], last[2] - first[2]};
  const double spacing = dot(way, normal) / static_cast<double>(slices.size() - 1);
  if (!(spacing > 0)) {
    throw InputError("uneven-slices", in_file(slices.back().image.source), "all slices lie in one place",
                     "complete the series, or resample it evenly");
  }
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const FileImage& image = slices[k].image;
    double sideways = 0, uneven = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double off = image.origin[axis] - first[axis] - static_cast<double>(k) * spacing * normal[axis];
      uneven += off * normal[axis];
      sideways += off * off;
    }
    sideways = std::sqrt(std::max(0.0, sideways - uneven * uneven));
    if (!(std::abs(uneven) <= limits::slice_unevenness * spacing)) {
      throw InputError(
          "uneven-slices", in_file(image.source),
          fmt::format("it lies {} mm off the even spacing of {} mm of {} slices: one is missing or doubled", uneven,
                      spacing, slices.size()),
          "complete the series, or resample it evenly");
    }
    if (!(sideways <= limits::slice_unevenness * spacing)) {
      throw InputError("sheared-volume", in_file(image.source),
                       fmt::format("it lies {} mm beside the slice below (a tilted gantry)", sideways),
                       "resample the series onto a rectangular grid");
    }
  }
  return spacing;
}

std::vector<OpenedImage> opened_slices(const std::vector<std::string>& files, const Progress& progress) {
  std::vector<OpenedImage> slices;
  for (const std::string& file : files) {
    progress.check();
    slices.push_back(open_image(itk::GDCMImageIO::New().GetPointer(), file));
  }
  check_alike(slices);
  const Vector3 normal = normal_of(slices.front().image);
  std::stable_sort(slices.begin(), slices.end(), [&normal](const OpenedImage& a, const OpenedImage& b) {
    return dot(a.image.origin, normal) < dot(b.image.origin, normal);
  });
  return slices;
}

Volume stacked(const std::vector<OpenedImage>& slices, const std::string& source, const ReadVolumeOptions& options,
               const Progress& progress) {
  FileImage image = slices.front().image;
  image.source = source;
  image.size[2] = slices.size();
  image.direction[2] = normal_of(image);
  if (slices.size() > 1) image.spacing[2] = slice_spacing(slices, image.direction[2]);
  if (options.spacing) image.spacing = *options.spacing;
  oriented_grid(image);  // throws what is wrong with it before memory is asked for
  const std::size_t pixels = image.size[0] * image.size[1];
  image.values.resize(pixels * slices.size());
  for (std::size_t k = 0; k < slices.size(); ++k) {
    progress.check();
    progress.tell("read", static_cast<double>(k) / static_cast<double>(slices.size()));
    read_pixels(slices[k], image.values.data() + k * pixels);
  }
  return oriented(std::move(image));
}

}  // namespace

Volume read_dicom_volume(const std::string& path, const ReadVolumeOptions& options, const Progress& progress) {
  const std::vector<std::string> files = files_of_series(path, progress);
  if (!fs::is_directory(path) || files.size() == 1) {
    const std::string& file = fs::is_directory(path) ? files.front() : path;
    OpenedImage opened = open_image(itk::GDCMImageIO::New().GetPointer(), file);
    if (opened.image.size[2] > 1) {
      if (options.spacing) opened.image.spacing = *options.spacing;
      oriented_grid(opened.image);
      opened.image.values.resize(opened.image.size[0] * opened.image.size[1] * opened.image.size[2]);
      read_pixels(opened, opened.image.values.data());
      return oriented(std::move(opened.image));
    }
  }
  return stacked(opened_slices(files, progress), path, options, progress);
}

}  // namespace odontoscope
