// Header of NIfTI-1: 348 bytes at fixed places, see nifti1.h of the NIfTI Data Format Working Group (2003).

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/volume/volume_header.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t header_size = 348;
/// Largest number in an orientation: a metre in nanometres.
constexpr double largest_form = 1e9;

[[noreturn]] void refuse(std::string_view cause, const std::string& path, const std::string& wrong) {
  Place place;
  place.file = path;
  throw InputError(cause, place, wrong, "correct the header, or convert the volume with the program that wrote it");
}

/// Fields by their offset, in the file's byte order.
class NiftiHeader {
 public:
  explicit NiftiHeader(const std::string& path) : path_(path) {
    // gzread reads plain files as well.
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
    if (!file) throw FileError(path, "cannot be opened", "check its permissions");
    if (gzread(file.get(), bytes_.data(), header_size) != static_cast<int>(header_size)) {
      refuse("unreadable-volume", path, "it is shorter than a NIfTI header");
    }
    swapped_ = field<std::int32_t>(0) != static_cast<std::int32_t>(header_size);
    if (field<std::int32_t>(0) != static_cast<std::int32_t>(header_size))
      refuse("unreadable-volume", path, "it is no NIfTI-1 file");
  }

  template <class T>
  T field(std::size_t offset) const {
    std::array<unsigned char, sizeof(T)> raw{};
    std::memcpy(raw.data(), bytes_.data() + offset, sizeof(T));
    if (swapped_) std::reverse(raw.begin(), raw.end());
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
  }

  /// ITK never comes back from a form whose squares overflow.
  void check_sensible(std::size_t offset, std::size_t count, const char* name) const {
    for (std::size_t n = 0; n < count; ++n) {
      const float value = field<float>(offset + n * sizeof(float));
      if (std::isfinite(value) && std::abs(value) <= largest_form) continue;
      refuse("unreadable-volume", path_, fmt::format("its header's {} holds {}, which is {}", name, value, std::isfinite(value) ? "too large" : "not finite"));
    }
  }

  std::string_view magic() const { return {bytes_.data() + 344, 3}; }
  bool swapped() const { return swapped_; }

 private:
  std::string path_;
  std::array<char, header_size> bytes_{};
  bool swapped_ = false;
};

std::size_t bytes_each(const std::string& path, std::int16_t datatype) {
  switch (datatype) {
    case 2:
    case 256:
      return 1;  // unsigned and signed 8 bit
    case 4:
    case 512:
      return 2;  // 16 bit
    case 8:
    case 768:
    case 16:
      return 4;  // 32 bit, float
    case 1024:
    case 1280:
    case 64:
      return 8;  // 64 bit, double
    case 128:
    case 2304:
    case 32:
    case 1792:
      refuse("not-scalar", path, "the voxels are colours or complex numbers");
    default:
      refuse("pixel-type", path, fmt::format("its NIfTI data type {} is not read here", datatype));
  }
}

std::size_t voxels_of(const std::string& path, const NiftiHeader& header) {
  const std::int16_t dimensions = header.field<std::int16_t>(40);
  if (dimensions < 1 || dimensions > 7)
    refuse("unreadable-volume", path, fmt::format("its header's dim[0] is {}", dimensions));
  double voxels = 1;
  for (std::size_t n = 1; n <= static_cast<std::size_t>(dimensions); ++n) {
    const std::int16_t length = header.field<std::int16_t>(40 + 2 * n);
    if (length < 1) refuse("empty-volume", path, fmt::format("its header's dim[{}] is {}", n, length));
    if (n > 3 && length > 1) refuse("not-3d", path, fmt::format("it has {} volumes", length));
    voxels *= length;
  }
  if (voxels > static_cast<double>(limits::voxels)) {
    refuse("too-many-voxels", path, fmt::format("it has {:.3g} voxels; the limit is {}", voxels, limits::voxels));
  }
  return static_cast<std::size_t>(voxels);
}

void check_geometry(const std::string& path, const NiftiHeader& header) {
  header.check_sensible(76, 1, "qfac");
  for (std::size_t n = 1; n <= 3; ++n) {
    const float spacing = header.field<float>(76 + 4 * n);
    if (!(spacing > 0) || !std::isfinite(spacing)) {
      refuse("bad-spacing", path, fmt::format("its header's pixdim[{}] is {}", n, spacing));
    }
  }
  if (header.field<std::int16_t>(252) > 0) header.check_sensible(256, 6, "qform");
  if (header.field<std::int16_t>(254) > 0) header.check_sensible(280, 12, "sform");
}

/// "x.hdr" to "x.img", "x.img.gz" to itself and so on.
std::string image_of_pair(const std::string& path) {
  fs::path image(path);
  const bool packed = image.extension() == ".gz";
  if (packed) image.replace_extension();
  image.replace_extension(".img");
  fs::path packed_image = image;
  packed_image += ".gz";
  return packed || !fs::exists(image) ? packed_image.string() : image.string();
}

std::string header_of_pair(const std::string& path) {
  fs::path header(path);
  if (header.extension() == ".gz") header.replace_extension();
  if (header.extension() != ".img") return path;
  header.replace_extension(".hdr");
  if (!fs::exists(header)) header += ".gz";
  return header.string();
}

}  // namespace

PixelClaim read_nifti_header(const std::string& path) {
  const std::string header_path = header_of_pair(path);
  const NiftiHeader header(header_path);
  const bool one_file = header.magic() == "n+1";
  if (!one_file && header.magic() != "ni1")
    refuse("unreadable-volume", path, "it lacks the mark of NIfTI-1 (Analyze 7.5 is not read)");
  check_geometry(path, header);

  PixelClaim claim;
  const std::int16_t datatype = header.field<std::int16_t>(70);
  const std::size_t each = bytes_each(path, datatype);
  claim.bytes = voxels_of(path, header) * each;
  const bool floating = datatype == 16 || datatype == 64;
  claim.floats = {floating ? each : 0, header.swapped()};

  const float offset = header.field<float>(108);
  const float least = one_file ? 352.0f : 0.0f;  // header and the four bytes that announce extensions
  if (!(offset >= least) || offset > 1e9f || offset != std::floor(offset)) {
    refuse("unreadable-volume", path, fmt::format("its header's vox_offset is {}", offset));
  }
  claim.file.path = one_file ? path : image_of_pair(header_path);
  claim.file.offset = static_cast<std::size_t>(offset);
  if (fs::path(claim.file.path).extension() == ".gz") {
    claim.file.packing = PixelFile::Packing::deflate;
    claim.file.unpack_from_start = true;
  }
  return claim;
}

}  // namespace odontoscope
