#include "recon/volume/volume_header.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>
#include <string_view>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/lower_case.h"
#include "recon/volume/byte_source.h"
#include "recon/volume/text_header.h"

namespace odontoscope {
namespace {

bool is_nifti(std::string_view head) {
  constexpr std::size_t first_size = 348, second_size = 540, mark_of_first = 344, mark_of_second = 4;
  const auto size_is = [head](unsigned size) {
    if (head.size() < size) return false;
    const auto byte = [head](std::size_t n) { return static_cast<unsigned char>(head[n]); };
    return (byte(0) == (size & 0xff) && byte(1) == size >> 8 && byte(2) == 0 && byte(3) == 0) ||
           (byte(3) == (size & 0xff) && byte(2) == size >> 8 && byte(1) == 0 && byte(0) == 0);
  };
  if (size_is(first_size)) {
    const std::string_view mark = head.substr(mark_of_first, 3);
    return mark == "n+1" || mark == "ni1";
  }
  if (!size_is(second_size)) return false;
  const std::string_view mark = head.substr(mark_of_second, 3);
  return mark == "n+2" || mark == "ni2";
}

/// Lines of "key = value" among which are those that each MetaImage has.
bool is_meta_image(std::string_view head) {
  while (!head.empty()) {
    const std::string_view line = head.substr(0, head.find('\n'));
    const std::string key = lower_case(std::string(trimmed(line.substr(0, line.find_first_of("=:")))));
    if (line.find_first_of("=:") == line.npos) return false;
    if (key == "ndims" || key == "dimsize" || key == "objecttype") return true;
    head.remove_prefix(std::min(line.size() + 1, head.size()));
  }
  return false;
}

bool has_ending(std::string name, std::initializer_list<std::string_view> endings) {
  name = lower_case(std::move(name));
  if (name.ends_with(".gz")) name.resize(name.size() - 3);
  for (const std::string_view ending : endings)
    if (name.ends_with(ending)) return true;
  return false;
}

}  // namespace

std::optional<VolumeFormat> volume_format(const std::string& path) {
  constexpr std::size_t looked_at = 4096;
  std::string head(looked_at, '\0');
  try {
    ByteSource source(path, 0, is_gzip(path) ? ByteSource::Packing::zlib_or_gzip : ByteSource::Packing::none);
    head.resize(source.read(head.data(), head.size()));
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (head.empty()) return std::nullopt;
  if (head.starts_with("NRRD000")) return VolumeFormat::nrrd;
  if (is_nifti(head) || has_ending(path, {".hdr", ".img"})) return VolumeFormat::nifti;
  if (is_meta_image(head) || has_ending(path, {".mha", ".mhd"})) return VolumeFormat::meta_image;
  return std::nullopt;
}

std::optional<double> millimetres_in(const std::string& unit) {
  struct Unit {
    std::string_view word;
    double millimetres;
  };
  constexpr std::array<Unit, 36> units{
      {{"mm", 1},         {"millimeter", 1},    {"millimeters", 1},    {"millimetre", 1},    {"millimetres", 1},
       {"um", 1e-3},      {"\xc2\xb5m", 1e-3},  {"\xce\xbcm", 1e-3},   {"\xb5m", 1e-3},      {"micron", 1e-3},
       {"microns", 1e-3}, {"micrometer", 1e-3}, {"micrometers", 1e-3}, {"micrometre", 1e-3}, {"micrometres", 1e-3},
       {"nm", 1e-6},      {"nanometer", 1e-6},  {"nanometers", 1e-6},  {"nanometre", 1e-6},  {"nanometres", 1e-6},
       {"cm", 10},        {"centimeter", 10},   {"centimeters", 10},   {"centimetre", 10},   {"centimetres", 10},
       {"dm", 100},       {"m", 1000},          {"meter", 1000},       {"meters", 1000},     {"metre", 1000},
       {"metres", 1000},  {"in", 25.4},         {"inch", 25.4},        {"inches", 25.4},     {"mu", 1e-3},
       {"micro", 1e-3}}};
  const std::string word = lower_case(unit);
  for (const Unit& known : units)
    if (word == known.word) return known.millimetres;
  return std::nullopt;
}

std::size_t voxels_of(const std::string& path, const std::vector<double>& sizes) {
  double voxels = 1;
  for (const double size : sizes) {
    if (size != std::floor(size) || size < 1) {
      throw InputError("empty-volume", in_file(path), fmt::format("one of its sizes is {}", size),
                       "correct the header");
    }
    voxels *= size;
  }
  if (voxels > static_cast<double>(limits::voxels)) {
    throw InputError("too-many-voxels", in_file(path),
                     fmt::format("it has {:.3g} voxels; the limit is {}", voxels, limits::voxels),
                     "crop it to the tooth or resample it more coarsely");
  }
  return static_cast<std::size_t>(voxels);
}

std::vector<std::size_t> three_axes(const std::string& path, const std::vector<double>& sizes) {
  std::vector<std::size_t> kept;
  for (std::size_t n = 0; n < sizes.size(); ++n) kept.push_back(n);
  for (std::size_t n = sizes.size(); n-- > 0 && kept.size() > 3;)
    if (sizes[n] == 1) kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(n));
  if (kept.size() <= 3) return kept;
  throw InputError("not-3d", in_file(path),
                   fmt::format("it has {} axes that are longer than one voxel: several volumes", kept.size()),
                   "give one volume of a time series");
}

}  // namespace odontoscope
