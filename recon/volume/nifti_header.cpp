// Headers of NIfTI-1 (348 bytes) and NIfTI-2 (540 bytes): fields at fixed places, in either byte order.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/portable_math.h"
#include "recon/volume/byte_source.h"
#include "recon/volume/text_header.h"
#include "recon/volume/volume_header.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;

/// Largest number in an orientation: a metre in nanometres.
constexpr double largest_form = 1e9;

[[noreturn]] void refuse_nifti(std::string_view cause, const std::string& path, const std::string& wrong) {
  throw InputError(cause, in_file(path), wrong,
                   "correct the header, or convert the volume with the program that wrote it");
}

/// Fields by their offset, in the file's byte order.
class Fields {
 public:
  explicit Fields(const std::string& path) : path_(path) {
    ByteSource source(path, 0, is_gzip(path) ? ByteSource::Packing::zlib_or_gzip : ByteSource::Packing::none);
    bytes_.resize(second_size);
    bytes_.resize(source.read(bytes_.data(), bytes_.size()));
    for (const bool swapped : {false, true}) {
      swapped_ = swapped;
      for (const std::size_t size : {first_size, second_size}) {
        if (bytes_.size() < size || field<std::int32_t>(0) != static_cast<std::int32_t>(size)) continue;
        is_second_ = size == second_size;
        return;
      }
    }
    refuse_nifti("unreadable-volume", path,
                 bytes_.size() < first_size ? "it is shorter than a NIfTI header" : "it is no NIfTI file");
  }

  template <class T>
  T field(std::size_t offset) const {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), bytes_.data() + offset, sizeof(T));
    if (swapped_) std::reverse(raw.begin(), raw.end());
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
  }

  bool is_second() const { return is_second_; }
  bool swapped() const { return swapped_; }
  std::string_view magic() const { return std::string_view(bytes_).substr(is_second_ ? 4 : 344, 3); }
  std::int16_t datatype() const { return field<std::int16_t>(is_second_ ? 12 : 70); }
  double dim(std::size_t n) const {
    return is_second_ ? static_cast<double>(field<std::int64_t>(16 + 8 * n)) : field<std::int16_t>(40 + 2 * n);
  }
  double pixdim(std::size_t n) const { return real(76, 104, n); }
  double vox_offset() const { return is_second_ ? static_cast<double>(field<std::int64_t>(168)) : field<float>(108); }
  double slope() const { return real(112, 176, 0); }
  double intercept() const { return real(116, 184, 0); }
  int units() const { return is_second_ ? field<std::int32_t>(500) : static_cast<unsigned char>(bytes_[123]); }
  int qform_code() const { return is_second_ ? field<std::int32_t>(344) : field<std::int16_t>(252); }
  int sform_code() const { return is_second_ ? field<std::int32_t>(348) : field<std::int16_t>(254); }
  /// b, c and d of the quaternion, then the offset.
  double qform(std::size_t n) const { return sensible(real(256, 352, n), "qform"); }
  /// Rows of x, y and z, four numbers each.
  double sform(std::size_t n) const { return sensible(real(280, 400, n), "sform"); }

 private:
  static constexpr std::size_t first_size = 348, second_size = 540;

  double real(std::size_t first, std::size_t second, std::size_t n) const {
    return is_second_ ? field<double>(second + 8 * n) : static_cast<double>(field<float>(first + 4 * n));
  }

  double sensible(double value, const char* name) const {
    if (std::isfinite(value) && std::abs(value) <= largest_form) return value;
    refuse_nifti("unreadable-volume", path_,
                 fmt::format("its header's {} holds {}, which is {}", name, value,
                             std::isfinite(value) ? "too large" : "not finite"));
  }

  std::string path_, bytes_;
  bool swapped_ = false, is_second_ = false;
};

PixelType type_of(const std::string& path, std::int16_t datatype) {
  switch (datatype) {
    case 2:
      return PixelType::uint8;
    case 256:
      return PixelType::int8;
    case 4:
      return PixelType::int16;
    case 512:
      return PixelType::uint16;
    case 8:
      return PixelType::int32;
    case 768:
      return PixelType::uint32;
    case 16:
      return PixelType::float32;
    case 64:
      return PixelType::float64;
    case 1024:
      return PixelType::int64;
    case 1280:
      return PixelType::uint64;
    case 128:
    case 2304:
    case 32:
    case 1792:
      refuse_nifti("not-scalar", path, "the voxels are colours or complex numbers");
    default:
      refuse_nifti("pixel-type", path, fmt::format("its NIfTI data type {} is not read here", datatype));
  }
}

std::vector<double> sizes_of(const std::string& path, const Fields& header) {
  const double dimensions = header.dim(0);
  if (!(dimensions >= 1 && dimensions <= 7))
    refuse_nifti("unreadable-volume", path, fmt::format("its header's dim[0] is {}", dimensions));
  std::vector<double> sizes;
  for (std::size_t n = 1; n <= static_cast<std::size_t>(dimensions); ++n) {
    sizes.push_back(header.dim(n));
    if (sizes.back() < 1)
      refuse_nifti("empty-volume", path, fmt::format("its header's dim[{}] is {}", n, sizes.back()));
    if (n > 3 && sizes.back() > 1) refuse_nifti("not-3d", path, fmt::format("it has {} volumes", sizes.back()));
  }
  voxels_of(path, sizes);
  sizes.resize(3, 1);
  return sizes;
}

/// Axes as columns, in RAS and the file's unit, with their lengths in them.
struct Form {
  std::array<Vector3, 3> axes;
  Vector3 origin;
};

Form sform_of(const Fields& header) {
  Form form{};
  for (std::size_t x = 0; x < 3; ++x) {
    for (std::size_t n = 0; n < 3; ++n) form.axes[n][x] = header.sform(4 * x + n);
    form.origin[x] = header.sform(4 * x + 3);
  }
  return form;
}

/// nifti1.h, method 2: a rotation by a quaternion, the third axis turned over where pixdim[0] is -1.
Form qform_of(const std::string& path, const Fields& header, const Vector3& spacing) {
  const double b = header.qform(0), c = header.qform(1), d = header.qform(2);
  const double rest = 1 - (b * b + c * c + d * d);
  if (rest < -limits::axes_out_of_square) refuse_nifti("unreadable-volume", path, "its header's qform is no rotation");
  const double a = std::sqrt(std::max(rest, 0.0));
  const double hand = header.pixdim(0) < 0 ? -1 : 1;
  Form form{{{{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
              {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)},
              {hand * 2 * (b * d + a * c), hand * 2 * (c * d - a * b), hand * (a * a + d * d - b * b - c * c)}}},
            {header.qform(3), header.qform(4), header.qform(5)}};
  for (std::size_t n = 0; n < 3; ++n)
    for (double& x : form.axes[n]) x *= spacing[n];
  return form;
}

double length_of(const Vector3& axis) { return portable::hypot(axis[0], axis[1], axis[2]); }

bool is_square(const Form& form) {
  for (std::size_t n = 0; n < 3; ++n) {
    const Vector3 &a = form.axes[n], &b = form.axes[(n + 1) % 3];
    const double both = length_of(a) * length_of(b);
    if (!(both > 0) || std::abs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) > limits::axes_out_of_square * both)
      return false;
  }
  return true;
}

/// Lengths of voxels; some programs write negative ones for axes that run the other way, which the forms say. 0 where
/// none is given.
Vector3 spacing_of(const std::string& path, const Fields& header) {
  Vector3 spacing{};
  if (!std::isfinite(header.pixdim(0))) refuse_nifti("unreadable-volume", path, "its header's qfac is not finite");
  for (std::size_t n = 0; n < 3; ++n) {
    spacing[n] = std::abs(header.pixdim(n + 1));
    if (!std::isfinite(spacing[n]))
      refuse_nifti("bad-spacing", path, fmt::format("its header's pixdim[{}] is {}", n + 1, spacing[n]));
  }
  return spacing;
}

double millimetres_of_unit(const std::string& path, const Fields& header, const ReadVolumeOptions& options,
                           std::vector<std::string>& remarks) {
  constexpr int space_bits = 7;
  switch (header.units() & space_bits) {
    case 0:
      remarks.push_back("the file names no unit of length: millimetres are assumed");
      return 1;
    case 1:
      return 1000;
    case 2:
      return 1;
    case 3:
      return 1e-3;
    default:
      break;
  }
  if (options.spacing) return 1;
  throw InputError("unknown-unit", in_file(path),
                   fmt::format("its header's unit of length has the unknown number {}", header.units() & space_bits),
                   "give the size of a voxel in mm (--spacing X,Y,Z)");
}

void put_form(const Form& form, double millimetres, FileImage& image) {
  constexpr Vector3 ras_to_lps{-1, -1, 1};
  for (std::size_t n = 0; n < 3; ++n) {
    const double length = length_of(form.axes[n]);
    image.spacing[n] = length * millimetres;
    for (std::size_t x = 0; x < 3; ++x)
      image.direction[n][x] = length > 0 ? ras_to_lps[x] * form.axes[n][x] / length : 0;
  }
  for (std::size_t x = 0; x < 3; ++x) image.origin[x] = ras_to_lps[x] * form.origin[x] * millimetres;
}

/// Both forms may be there. An sform may also be a registration to an atlas, which stretches: the scanner's own is
/// taken before it, and one with right angles before one without.
void read_geometry(const std::string& path, const Fields& header, const ReadVolumeOptions& options,
                   VolumeHeader& result) {
  FileImage& image = result.image;
  const Vector3 spacing = spacing_of(path, header);
  const double millimetres = millimetres_of_unit(path, header, options, result.remarks);
  constexpr int scanner = 1;
  const bool spaced = spacing[0] > 0 && spacing[1] > 0 && spacing[2] > 0;
  const bool has_q = header.qform_code() > 0 && spaced, has_s = header.sform_code() > 0;
  const bool prefer_q = has_q && (!has_s || (header.qform_code() == scanner && header.sform_code() != scanner));
  if (has_s && !prefer_q && (is_square(sform_of(header)) || !has_q)) {
    put_form(sform_of(header), millimetres, image);
  } else if (has_q) {
    put_form(qform_of(path, header, spacing), millimetres, image);
  } else {
    for (std::size_t n = 0; n < 3; ++n) {
      if (spacing[n] == 0 && !options.spacing) {
        throw InputError("bad-spacing", in_file(path), fmt::format("its header's pixdim[{}] is 0", n + 1),
                         "give the size of a voxel in mm (--spacing X,Y,Z)");
      }
      image.spacing[n] = spacing[n] * millimetres;
    }
    result.remarks.push_back("the file does not say how its axes lie in space: they are taken as they stand");
  }
  if (options.spacing) image.spacing = *options.spacing;
}

/// "x.hdr" to "x.img", "x.hdr.gz" to "x.img.gz" and so on.
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

void read_pixels_place(const std::string& path, const std::string& header_path, const Fields& header,
                       bool allow_outside, PixelFiles& pixels) {
  const bool one_file = header.magic() == "n+1" || header.magic() == "n+2";
  if (!one_file && header.magic() != "ni1" && header.magic() != "ni2") {
    refuse_nifti("unreadable-volume", path,
                 "it lacks the mark of NIfTI (Analyze 7.5 is not read, since it does not say which side is left)");
  }
  pixels.type = type_of(path, header.datatype());
  pixels.swapped = header.swapped();
  // 0 or not finite: none, says nifti1.h.
  if (header.slope() != 0 && std::isfinite(header.slope())) {
    pixels.slope = header.slope();
    pixels.intercept = std::isfinite(header.intercept()) ? header.intercept() : 0;
  }
  pixels.paths = {one_file ? path : image_of_pair(header_path)};
  if (!one_file && !allow_outside) check_inside(header_path, pixels.paths[0]);
  pixels.packed_whole = is_gzip(pixels.paths[0]);

  // The header and the four bytes that announce extensions; 0 is what programs write that mean just this.
  const double least = one_file ? (header.is_second() ? 544 : 352) : 0;
  const double offset = one_file && header.vox_offset() == 0 ? least : header.vox_offset();
  constexpr double most = 1e15;
  if (!(offset >= least) || offset > most || offset != std::floor(offset)) {
    refuse_nifti("unreadable-volume", path, fmt::format("its header's vox_offset is {}", offset));
  }
  pixels.offset = static_cast<std::size_t>(offset);
}

}  // namespace

VolumeHeader read_nifti_header(const std::string& path, const ReadVolumeOptions& options) {
  const std::string header_path = header_of_pair(path);
  const Fields fields(header_path);
  VolumeHeader header;
  header.image.source = path;
  read_pixels_place(path, header_path, fields, options.allow_outside, header.pixels);
  const std::vector<double> sizes = sizes_of(path, fields);
  for (std::size_t n = 0; n < 3; ++n) header.image.size[n] = static_cast<std::size_t>(sizes[n]);
  read_geometry(path, fields, options, header);
  return header;
}

}  // namespace odontoscope
