// Header of NRRD: "field: value" lines, then an empty one.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <string_view>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/lower_case.h"
#include "recon/core/portable_math.h"
#include "recon/volume/text_header.h"
#include "recon/volume/volume_header.h"

namespace odontoscope {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

struct NamedType {
  std::string_view name;
  PixelType type;
};
constexpr std::array<NamedType, 42> types{{{"signed char", PixelType::int8},
                                           {"int8", PixelType::int8},
                                           {"int8_t", PixelType::int8},
                                           {"uchar", PixelType::uint8},
                                           {"unsigned char", PixelType::uint8},
                                           {"uint8", PixelType::uint8},
                                           {"uint8_t", PixelType::uint8},
                                           {"short", PixelType::int16},
                                           {"short int", PixelType::int16},
                                           {"signed short", PixelType::int16},
                                           {"signed short int", PixelType::int16},
                                           {"int16", PixelType::int16},
                                           {"int16_t", PixelType::int16},
                                           {"ushort", PixelType::uint16},
                                           {"unsigned short", PixelType::uint16},
                                           {"unsigned short int", PixelType::uint16},
                                           {"uint16", PixelType::uint16},
                                           {"uint16_t", PixelType::uint16},
                                           {"int", PixelType::int32},
                                           {"signed int", PixelType::int32},
                                           {"int32", PixelType::int32},
                                           {"int32_t", PixelType::int32},
                                           {"uint", PixelType::uint32},
                                           {"unsigned int", PixelType::uint32},
                                           {"uint32", PixelType::uint32},
                                           {"uint32_t", PixelType::uint32},
                                           {"longlong", PixelType::int64},
                                           {"long long", PixelType::int64},
                                           {"long long int", PixelType::int64},
                                           {"signed long long", PixelType::int64},
                                           {"int64", PixelType::int64},
                                           {"int64_t", PixelType::int64},
                                           {"ulonglong", PixelType::uint64},
                                           {"unsigned long long", PixelType::uint64},
                                           {"uint64", PixelType::uint64},
                                           {"uint64_t", PixelType::uint64},
                                           {"float", PixelType::float32},
                                           {"double", PixelType::float64}}};

/// What x, y and z of a space are multiplied by to point left, back and up.
struct NamedSpace {
  std::string_view name, short_name;
  Vector3 to_lps;
};
constexpr std::array<NamedSpace, 5> spaces{{{"left-posterior-superior", "lps", {1, 1, 1}},
                                            {"right-anterior-superior", "ras", {-1, -1, 1}},
                                            {"left-anterior-superior", "las", {1, -1, 1}},
                                            {"scanner-xyz", "scanner-xyz", {1, 1, 1}},
                                            {"3d-right-handed", "3d-right-handed", {1, 1, 1}}}};

class NrrdHeader {
 public:
  NrrdHeader(const std::string& path, const ReadVolumeOptions& options) : path_(path), options_(options) {
    packed_ = is_gzip(path);
    ByteSource source(path, 0, packed_ ? ByteSource::Packing::zlib_or_gzip : ByteSource::Packing::none);
    header_ = read_text_header(source, path, {":", "", OddLines::passed_over});
  }

  VolumeHeader read() {
    read_axes();
    read_pixels_place();
    const auto kept = three_axes(path_, sizes_);
    read_space();
    make_image(kept);
    make_labels();
    return std::move(result_);
  }

 private:
  [[noreturn]] void refuse(
      std::string_view cause, const std::string& wrong,
      std::string_view remedy = "correct the header, or convert the volume with the program that wrote it") const {
    throw InputError(cause, in_file(path_), wrong, remedy);
  }

  const std::string& get(std::string_view key) const {
    const std::string* value = header_.find(key);
    if (value == nullptr) refuse("unreadable-volume", fmt::format("its header lacks {}", key));
    return *value;
  }

  const std::string* either(std::string_view key, std::string_view other) const {
    const std::string* value = header_.find(key);
    return value != nullptr ? value : header_.find(other);
  }

  std::vector<double> numbers(std::string_view key, const std::string& text) const {
    std::vector<double> found;
    for (const std::string& word : words_of(text)) {
      if (!number_of(word, found.emplace_back()))
        refuse("unreadable-volume", fmt::format("its header's {} is not made of numbers", key));
    }
    return found;
  }

  void read_axes() {
    sizes_ = numbers("sizes", get("sizes"));
    const std::vector<double> dimension = numbers("dimension", get("dimension"));
    if (dimension.size() != 1 || dimension[0] != static_cast<double>(sizes_.size()) || sizes_.empty()) {
      refuse("unreadable-volume", "its header's dimension and sizes contradict each other");
    }
    voxels_of(path_, sizes_);
    if (const std::string* kinds = header_.find("kinds")) check_kinds(words_of(lower_case(*kinds)));
  }

  /// Colours and vectors are numbers of one voxel, not voxels.
  void check_kinds(const std::vector<std::string>& kinds) const {
    for (std::size_t n = 0; n < std::min(kinds.size(), sizes_.size()); ++n) {
      if (sizes_[n] == 1) continue;
      if (kinds[n] == "time")
        refuse("not-3d", fmt::format("it has {} volumes, one after the other in time", sizes_[n]), "give one of them");
      bool plain = false;
      for (const std::string_view known : {"domain", "space", "none", "???", "stub"})
        plain = plain || kinds[n] == known;
      if (plain) continue;
      refuse("not-scalar",
             fmt::format("each voxel has {} numbers ({})", sizes_[n], kinds[n].substr(0, limits::quoted_length)),
             kinds[n] == "list" ? "export its segments as one label map, without overlaps"
                                : "give a volume with one number a voxel");
    }
  }

  void read_pixels_place() {
    PixelFiles& pixels = result_.pixels;
    pixels.type = type();
    read_encoding(lower_case(get("encoding")));
    pixels.line_skip = skip("line skip", "lineskip");
    if (const std::string* text = either("byte skip", "byteskip"); text != nullptr && *text == "-1") {
      if (pixels.encoding != PixelFiles::Encoding::raw || packed_)
        refuse("unreadable-volume", "its byte skip of -1 is about raw pixels only");
      pixels.at_end = true;
    } else {
      pixels.byte_skip = skip("byte skip", "byteskip");
    }
    if (const std::string* data = either("data file", "datafile")) {
      pixels.paths = data_files_of(path_, *data, header_.list, options_.allow_outside);
    } else {
      pixels.paths = {path_};
      pixels.offset = header_.end;
      pixels.packed_whole = packed_;
    }
    if (bytes_of(pixels.type) == 1 || pixels.encoding == PixelFiles::Encoding::text) return;
    const std::string* endian = header_.find("endian");
    const std::string order = endian == nullptr ? "" : lower_case(*endian);
    if (order != "little" && order != "big") {
      refuse("unreadable-volume", "its header does not say in which order the bytes of a number lie",
             "add a line \"endian: little\" or \"endian: big\" to it");
    }
    pixels.swapped = (order == "little") != (std::endian::native == std::endian::little);
  }

  PixelType type() const {
    const std::string name = lower_case(get("type"));
    const auto found = std::find_if(types.begin(), types.end(), [&](const NamedType& t) { return t.name == name; });
    if (found == types.end())
      refuse("pixel-type",
             fmt::format("the voxels are \"{}\": no plain numbers", name.substr(0, limits::quoted_length)));
    return found->type;
  }

  void read_encoding(const std::string& name) {
    PixelFiles& pixels = result_.pixels;
    if (name == "raw")
      pixels.encoding = PixelFiles::Encoding::raw;
    else if (name == "gzip" || name == "gz")
      pixels.encoding = PixelFiles::Encoding::deflate;
    else if (name == "txt" || name == "text" || name == "ascii")
      pixels.encoding = PixelFiles::Encoding::text;
    else if (name == "hex")
      pixels.encoding = PixelFiles::Encoding::hex;
    else {
      refuse(
          "unreadable-volume",
          fmt::format("its pixels are packed as \"{}\", which is not read here", name.substr(0, limits::quoted_length)),
          "save it with the encoding gzip or raw");
    }
    if (packed_ && pixels.encoding == PixelFiles::Encoding::deflate && either("data file", "datafile") == nullptr) {
      refuse("unreadable-volume", "its pixels are packed within a file that is packed itself", "unpack the file first");
    }
  }

  std::size_t skip(std::string_view key, std::string_view other) const {
    const std::string* text = either(key, other);
    if (text == nullptr) return 0;
    const std::vector<double> number = numbers(key, *text);
    constexpr double most = 1e15;
    if (number.size() != 1 || number[0] < 0 || number[0] > most || number[0] != std::floor(number[0])) {
      refuse("unreadable-volume", fmt::format("its header's {} is no number of them", key));
    }
    return static_cast<std::size_t>(number[0]);
  }

  /// To LPS, and to millimetres where the units are known.
  void read_space() {
    std::string name = header_.find("space") == nullptr ? "" : lower_case(*header_.find("space"));
    if (name.ends_with("-time")) name.resize(name.size() - 5);
    if (name == "rast" || name == "last" || name == "lpst") name.resize(3);
    if (name == "3d-left-handed") {
      refuse("left-handed-space", "its space is 3D-left-handed: read as it stands, the tooth would be mirrored",
             "give its true space, such as \"space: left-posterior-superior\" with directions to match, or \"space: "
             "3D-right-handed\" if its numbers are right-handed all the same");
    }
    if (name.empty()) return;
    const auto found = std::find_if(spaces.begin(), spaces.end(),
                                    [&](const NamedSpace& s) { return name == s.name || name == s.short_name; });
    if (found == spaces.end())
      refuse("unreadable-volume",
             fmt::format("its space \"{}\" is none of NRRD", name.substr(0, limits::quoted_length)));
    to_lps_ = found->to_lps;
    is_patient_ = found - spaces.begin() < 3;
  }

  /// "(1,0,0)" or "none".
  std::vector<std::optional<Vector3>> vectors(std::string_view key, std::string_view text) const {
    std::vector<std::optional<Vector3>> found;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
      if (text.starts_with("none")) {
        found.emplace_back();
        text.remove_prefix(4);
        continue;
      }
      const std::size_t end = text.find(')');
      if (!text.starts_with('(') || end == text.npos)
        refuse("unreadable-volume", fmt::format("its header's {} is not made of (x,y,z)", key));
      std::string inner(text.substr(1, end - 1));
      std::replace(inner.begin(), inner.end(), ',', ' ');
      const std::vector<double> three = numbers(key, inner);
      if (three.size() != 3 || !std::isfinite(three[0] + three[1] + three[2])) {
        refuse("unreadable-volume", fmt::format("its header's {} is not made of three finite numbers each", key));
      }
      found.push_back(Vector3{three[0], three[1], three[2]});
      text.remove_prefix(end + 1);
    }
    return found;
  }

  /// "um" "um" "um", one each.
  std::vector<std::string> quoted(const std::string& text) const {
    std::vector<std::string> found;
    for (std::size_t at = text.find('"'); at != text.npos; at = text.find('"', at + 1)) {
      const std::size_t end = std::min(text.find('"', at + 1), text.size());
      found.emplace_back(trimmed(std::string_view(text).substr(at + 1, end - at - 1)));
      at = end;
      if (end == text.size()) break;
    }
    return found;
  }

  /// Millimetres a unit, along world axes ("space units") or along the file's own ("units"). An unknown unit needs a
  /// spacing by hand.
  Vector3 unit_scales(const std::string* field, const std::vector<std::size_t>& axes) {
    Vector3 scale{1, 1, 1};
    const std::vector<std::string> units = field == nullptr ? std::vector<std::string>{} : quoted(*field);
    bool known = false;
    for (std::size_t n = 0; n < axes.size() && n < 3; ++n) {
      const std::string unit = axes[n] < units.size() ? units[axes[n]] : "";
      if (unit.empty() || unit == "???" || unit == "none") continue;
      const std::optional<double> millimetres = millimetres_in(unit);
      if (!millimetres && !options_.spacing) {
        refuse("unknown-unit",
               fmt::format("its unit \"{}\" is no length that is known here", unit.substr(0, limits::quoted_length)),
               "give the size of a voxel in mm (--spacing X,Y,Z)");
      }
      unknown_unit_ = unknown_unit_ || !millimetres;
      known = true;
      scale[n] = millimetres.value_or(1);
    }
    if (!known && !is_patient_) result_.remarks.push_back("the file names no unit of length: millimetres are assumed");
    return scale;
  }

  void make_image(const std::vector<std::size_t>& kept) {
    FileImage& image = result_.image;
    image.source = path_;
    for (std::size_t n = 0; n < kept.size(); ++n) image.size[n] = static_cast<std::size_t>(sizes_[kept[n]]);
    const std::string* directions = header_.find("space directions");
    if (directions != nullptr)
      make_directions(vectors("space directions", *directions), kept);
    else
      make_spacings(kept);
    if (!options_.spacing) return;
    // An origin in a unit that nobody knows goes with the spacing that was given instead.
    if (unknown_unit_ && image.spacing[0] > 0) {
      for (double& x : image.origin) x *= (*options_.spacing)[0] / image.spacing[0];
    }
    image.spacing = *options_.spacing;
  }

  void make_directions(const std::vector<std::optional<Vector3>>& found, const std::vector<std::size_t>& kept) {
    FileImage& image = result_.image;
    if (found.size() != sizes_.size())
      refuse("unreadable-volume",
             fmt::format("its header has {} space directions for {} axes", found.size(), sizes_.size()));
    const Vector3 scale = unit_scales(either("space units", "spaceunits"), {0, 1, 2});
    std::string unspaced;
    for (std::size_t n = 0; n < kept.size(); ++n) {
      if (!found[kept[n]])
        refuse("not-scalar",
               fmt::format("its axis {} has no direction in space: it counts numbers of one voxel", kept[n] + 1));
      Vector3 axis = *found[kept[n]];
      for (std::size_t x = 0; x < 3; ++x) axis[x] *= scale[x] * to_lps_[x];
      const double length = portable::hypot(axis[0], axis[1], axis[2]);
      image.spacing[n] = length;
      for (std::size_t x = 0; x < 3; ++x) image.direction[n][x] = length > 0 ? axis[x] / length : 0;
    }
    if (const std::string* text = header_.find("space origin")) {
      const auto origin = vectors("space origin", *text);
      if (origin.size() != 1 || !origin[0]) refuse("unreadable-volume", "its header's space origin is no point");
      for (std::size_t x = 0; x < 3; ++x) image.origin[x] = (*origin[0])[x] * scale[x] * to_lps_[x];
    }
  }

  /// Without directions: axes as they stand, one after the other.
  void make_spacings(const std::vector<std::size_t>& kept) {
    FileImage& image = result_.image;
    const auto by_axis = [&](std::string_view key, std::string_view other) {
      const std::string* text = either(key, other);
      std::vector<double> found = text == nullptr ? std::vector<double>{} : numbers(key, *text);
      found.resize(sizes_.size(), missing);
      return found;
    };
    const std::vector<double> spacings = by_axis("spacings", "spacing"), low = by_axis("axis mins", "axismins"),
                              high = by_axis("axis maxs", "axismaxs");
    const std::string* centering = either("centers", "centerings");
    const std::vector<std::string> centres = words_of(centering == nullptr ? "" : lower_case(*centering));
    const Vector3 scale = unit_scales(either("units", "unit"), kept);
    std::string unspaced;
    for (std::size_t n = 0; n < kept.size(); ++n) {
      const std::size_t axis = kept[n];
      const bool node = axis < centres.size() && centres[axis] == "node";
      double spacing = spacings[axis];
      if (std::isnan(spacing))
        spacing = (high[axis] - low[axis]) / (node ? std::max(sizes_[axis] - 1, 1.0) : sizes_[axis]);
      if (std::isnan(spacing)) {
        spacing = 1;
        if (!options_.spacing) unspaced += fmt::format("{}{}", unspaced.empty() ? "" : " and ", axis + 1);
      }
      image.spacing[n] = spacing * scale[n];
      if (std::isfinite(low[axis])) image.origin[n] = (low[axis] + (node ? 0 : spacing / 2)) * scale[n];
    }
    if (!unspaced.empty()) {
      result_.remarks.push_back(fmt::format(
          "the file gives no spacing along axis {}: 1 mm is assumed; --spacing X,Y,Z gives the true one", unspaced));
    }
    if (header_.find("space") != nullptr)
      result_.remarks.push_back("the file names a space, but not how its axes lie in it: they are taken as they stand");
  }

  /// Segment3_Name and Segment3_LabelValue of 3D Slicer.
  void make_labels() {
    std::map<std::string, std::string> names, values;
    for (const HeaderField& pair : header_.pairs) {
      if (!pair.key.starts_with("segment") || pair.value.empty()) continue;
      if (pair.key.ends_with("_name")) names[pair.key.substr(0, pair.key.size() - 5)] = pair.value;
      if (pair.key.ends_with("_labelvalue")) values[pair.key.substr(0, pair.key.size() - 11)] = pair.value;
    }
    for (const auto& [segment, name] : names) {
      double value = 0;
      if (!values.contains(segment) || !number_of(values[segment], value) || value != std::floor(value)) continue;
      if (std::abs(value) > static_cast<double>(limits::largest_label) || result_.labels.size() == limits::structures)
        continue;
      result_.labels.push_back({static_cast<std::int64_t>(value), name.substr(0, limits::name_length)});
    }
    std::stable_sort(result_.labels.begin(), result_.labels.end(),
                     [](const VolumeLabel& a, const VolumeLabel& b) { return a.value < b.value; });
  }

  std::string path_;
  const ReadVolumeOptions& options_;
  bool packed_ = false, is_patient_ = false, unknown_unit_ = false;
  TextHeader header_;
  std::vector<double> sizes_;
  Vector3 to_lps_{1, 1, 1};
  VolumeHeader result_;
};

}  // namespace

VolumeHeader read_nrrd_header(const std::string& path, const ReadVolumeOptions& options) {
  return NrrdHeader(path, options).read();
}

}  // namespace odontoscope
