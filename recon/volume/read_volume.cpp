#include "recon/volume/read_volume.h"

#include <fmt/format.h>
#include <gdcmTrace.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkObject.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <streambuf>

#include "recon/core/error.h"
#include "recon/volume/dicom_header.h"
#include "recon/volume/oriented_image.h"
#include "recon/volume/read_volume_dicom.h"
#include "recon/volume/read_volume_itk.h"
#include "recon/volume/volume_header.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;

/// The libraries' messages off, and back to what they were at the end. What they say that matters comes as an
/// exception.
class Quiet {
 public:
  Quiet() : itk_(itk::Object::GetGlobalWarningDisplay()), cerr_(std::cerr.rdbuf(&nowhere_)) {
    itk::Object::GlobalWarningDisplayOff();
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
  }
  ~Quiet() {
    std::cerr.rdbuf(cerr_);
    std::cerr.clear();
    itk::Object::SetGlobalWarningDisplay(itk_);
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  /// Takes everything and keeps nothing.
  class Nowhere : public std::streambuf {
    int_type overflow(int_type c) override { return traits_type::not_eof(c); }
    std::streamsize xsputn(const char*, std::streamsize count) override { return count; }
  };
  Nowhere nowhere_;
  bool itk_;
  std::streambuf* cerr_;
};

struct Reader {
  itk::ImageIOBase::Pointer io;
  PixelClaim (*read_header)(const std::string& path);
};

std::optional<Reader> reader_for(const std::string& path) {
  const std::array<Reader, 3> readers{{{itk::NrrdImageIO::New().GetPointer(), read_nrrd_header},
                                       {itk::MetaImageIO::New().GetPointer(), read_meta_image_header},
                                       {itk::NiftiImageIO::New().GetPointer(), read_nifti_header}}};
  for (const Reader& reader : readers) {
    if (reader.io->CanReadFile(path.c_str())) return reader;
  }
  return std::nullopt;
}

void check_openable(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw FileError(path, "does not exist", "check the name");
  if (fs::is_directory(status)) return;
  if (!fs::is_regular_file(status)) throw FileError(path, "is neither a file nor a folder", "give a volume file");
  if (!std::ifstream(path, std::ios::binary)) throw FileError(path, "cannot be opened", "check its permissions");
}

Volume read_file_volume(const Reader& reader, const std::string& path, const ReadVolumeOptions& options) {
  const PixelClaim claim = reader.read_header(path);
  check_pixel_file(claim.file, claim.bytes.value_or(0), claim.floats);
  OpenedImage opened = open_image(reader.io, path);
  FileImage& image = opened.image;
  if (options.spacing) image.spacing = *options.spacing;
  oriented_grid(image);  // throws what is wrong with it before memory is asked for
  if (!claim.bytes) check_pixel_file(claim.file, bytes_of_pixels(opened));
  image.values.resize(image.size[0] * image.size[1] * image.size[2]);
  read_pixels(opened, image.values.data());
  return oriented(std::move(image));
}

}  // namespace

Volume read_volume(const std::string& path, const ReadVolumeOptions& options, const Progress& progress) {
  check_openable(path);
  const Quiet quiet;
  progress.check();
  progress.tell("read", 0);
  Volume volume;
  if (fs::is_directory(path) || is_dicom_file(path)) {
    volume = read_dicom_volume(path, options, progress);
  } else if (const std::optional<Reader> reader = reader_for(path)) {
    volume = read_file_volume(*reader, path, options);
  } else {
    Place place;
    place.file = path;
    throw InputError("unknown-volume-format", place, "it is no volume that can be read here, or its header is damaged",
                     "give NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd), NIfTI (.nii, .nii.gz) or DICOM");
  }
  validate_volume(volume);
  progress.tell("read", 1);
  return volume;
}

}  // namespace odontoscope
