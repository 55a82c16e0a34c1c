#include "recon/volume/read_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>

#include "recon/core/error.h"
#include "recon/volume/byte_source.h"
#include "recon/volume/dicom_file.h"
#include "recon/volume/oriented_image.h"
#include "recon/volume/read_part.h"
#include "recon/volume/read_volume_dicom.h"
#include "recon/volume/volume_header.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;

void check_openable(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw FileError(path, "does not exist", "check the name");
  if (fs::is_directory(status)) return;
  if (!fs::is_regular_file(status)) throw FileError(path, "is neither a file nor a folder", "give a volume file");
  if (!std::ifstream(path, std::ios::binary)) throw FileError(path, "cannot be opened", "check its permissions");
}

VolumeHeader header_of(VolumeFormat format, const std::string& path, const ReadVolumeOptions& options) {
  switch (format) {
    case VolumeFormat::nrrd:
      return read_nrrd_header(path, options);
    case VolumeFormat::meta_image:
      return read_meta_image_header(path, options);
    case VolumeFormat::nifti:
      return read_nifti_header(path, options);
  }
  throw InternalError("a volume format that is none");
}

/// One voxel thick is no volume, along whichever axis: an image stored on edge is one image, too.
void check_thickness(const FileImage& image) {
  if (std::none_of(image.size.begin(), image.size.end(), [](std::size_t n) { return n == 1; })) return;
  throw InputError("single-slice", in_file(image.source),
                   fmt::format("its {} x {} x {} voxels are one image, one voxel thick", image.size[0], image.size[1],
                               image.size[2]),
                   "give at least two slices; a solid lies between them");
}

Volume read_file_volume(VolumeFormat format, const std::string& path, const ReadVolumeOptions& options,
                        const Progress& progress) {
  VolumeHeader header = header_of(format, path, options);
  FileImage& image = header.image;
  const std::size_t voxels = image.size[0] * image.size[1] * image.size[2];
  check_pixel_files(header.pixels, voxels);
  oriented_grid(image);  // throws what is wrong with it before memory is asked for
  check_thickness(image);
  if (options.part && voxels > options.part->whole_up_to) {
    check_memory(path, std::min(voxels, options.part->most_voxels));
    image = read_part(std::move(image), header.pixels, *options.part, progress);
  } else {
    check_memory(path, voxels);
    image.values = read_pixels(header.pixels, voxels, progress);
  }
  Volume volume = oriented(std::move(image));
  volume.labels = std::move(header.labels);
  volume.remarks = std::move(header.remarks);
  return volume;
}

}  // namespace

Volume read_volume(const std::string& path, const ReadVolumeOptions& options, const Progress& progress) {
  check_openable(path);
  progress.check();
  progress.tell("read", 0);
  Volume volume;
  const bool is_folder = fs::is_directory(path);
  const std::optional<VolumeFormat> format = is_folder ? std::nullopt : volume_format(path);
  if (format) {
    volume = read_file_volume(*format, path, options, progress);
  } else if (is_folder || looks_like_dicom(path)) {
    volume = read_dicom_volume(path, options, progress);
  } else {
    std::error_code error;
    if (fs::file_size(path, error) == 0 && !error)
      throw InputError("unknown-volume-format", in_file(path), "the file is empty", "write or copy it again");
    throw InputError("unknown-volume-format", in_file(path),
                     "it is no volume that can be read here, or its header is damaged",
                     "give NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd), NIfTI (.nii, .nii.gz) or DICOM");
  }
  validate_volume(volume);
  progress.tell("read", 1);
  return volume;
}

}  // namespace odontoscope
