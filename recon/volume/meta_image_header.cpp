// Header of MetaImage: "Key = value" lines up to ElementDataFile.

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
#include "recon/volume/text_header.h"
#include "recon/volume/volume_header.h"

namespace odontoscope {
namespace {

[[noreturn]] void refuse(std::string_view cause, const std::string& path, const std::string& wrong) {
  throw InputError(cause, in_file(path), wrong,
                   "correct the header, or convert the volume with the program that wrote it");
}

struct ElementType {
  std::string_view name;
  PixelType type;
};
constexpr std::array<ElementType, 12> element_types{{{"MET_CHAR", PixelType::int8},
                                                     {"MET_UCHAR", PixelType::uint8},
                                                     {"MET_SHORT", PixelType::int16},
                                                     {"MET_USHORT", PixelType::uint16},
                                                     {"MET_INT", PixelType::int32},
                                                     {"MET_UINT", PixelType::uint32},
                                                     {"MET_LONG", PixelType::int32},
                                                     {"MET_ULONG", PixelType::uint32},
                                                     {"MET_LONG_LONG", PixelType::int64},
                                                     {"MET_ULONG_LONG", PixelType::uint64},
                                                     {"MET_FLOAT", PixelType::float32},
                                                     {"MET_DOUBLE", PixelType::float64}}};

/// By key; each may come once only, since nobody knows which of two is meant.
class MetaFields {
 public:
  MetaFields(const std::string& path, const TextHeader& header) : path_(path) {
    for (const HeaderField& field : header.fields) {
      if (values_.emplace(field.key, field.value).second) continue;
      refuse("unreadable-volume", path,
             fmt::format("its header gives {} twice", field.key.substr(0, limits::quoted_length)));
    }
  }

  const std::string* find(const std::string& key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? nullptr : &found->second;
  }

  const std::string& get(const std::string& key) const {
    const std::string* value = find(key);
    if (value == nullptr) refuse("unreadable-volume", path_, fmt::format("its header lacks {}", key));
    return *value;
  }

  bool is_true(const std::string& key) const {
    const std::string* value = find(key);
    return value != nullptr && !value->empty() &&
           (value->front() == 'T' || value->front() == 't' || value->front() == '1');
  }

  /// Exactly `count` finite numbers.
  std::vector<double> numbers(const std::string& key, std::size_t count) const {
    std::vector<double> found;
    for (const std::string& word : words_of(get(key))) {
      if (!number_of(word, found.emplace_back()) || !std::isfinite(found.back())) {
        refuse("unreadable-volume", path_, fmt::format("its header's {} is not made of finite numbers", key));
      }
    }
    if (found.size() == count) return found;
    refuse("unreadable-volume", path_,
           fmt::format("its header's {} has {} numbers instead of {}", key, found.size(), count));
  }

  /// The numbers of the first of several names for one thing that is there.
  std::optional<std::vector<double>> first_of(std::initializer_list<const char*> keys, std::size_t count) const {
    for (const char* key : keys)
      if (find(key) != nullptr) return numbers(key, count);
    return std::nullopt;
  }

  /// A whole number from 0 to `most`.
  std::size_t whole(const std::string& key, double most) const {
    const double number = numbers(key, 1).front();
    if (number == std::floor(number) && number >= 0 && number <= most) return static_cast<std::size_t>(number);
    refuse("unreadable-volume", path_, fmt::format("its header's {} is {}", key, number));
  }

 private:
  std::string path_;
  std::map<std::string, std::string> values_;
};

std::vector<double> read_sizes(const std::string& path, const MetaFields& fields) {
  constexpr double most_dimensions = 10;  // MetaIO's own limit
  const double dimensions = fields.numbers("ndims", 1).front();
  if (dimensions < 1 || dimensions != std::floor(dimensions))
    refuse("unreadable-volume", path, fmt::format("its header's NDims is {}", dimensions));
  if (dimensions > most_dimensions || dimensions < 3)
    refuse("not-3d", path, fmt::format("the image has {} dimensions instead of 3", dimensions));
  if (fields.find("elementnumberofchannels") != nullptr && fields.whole("elementnumberofchannels", 1e9) != 1) {
    refuse("not-scalar", path, "each voxel has several numbers (a colour or a vector)");
  }
  return fields.numbers("dimsize", static_cast<std::size_t>(dimensions));
}

/// Millimetres a unit of its lengths.
double unit_of(const std::string& path, const MetaFields& fields, const ReadVolumeOptions& options) {
  const std::string* name = fields.find("distanceunits");
  if (name == nullptr || name->empty() || *name == "?") return 1;  // MetaIO's own is the millimetre
  const std::optional<double> millimetres = millimetres_in(*name);
  if (millimetres || options.spacing) return millimetres.value_or(1);
  throw InputError(
      "unknown-unit", in_file(path),
      fmt::format("its unit \"{}\" is no length that is known here", name->substr(0, limits::quoted_length)),
      "give the size of a voxel in mm (--spacing X,Y,Z)");
}

void read_geometry(const std::string& path, const MetaFields& fields, std::size_t dimensions,
                   const std::vector<std::size_t>& kept, const ReadVolumeOptions& options, VolumeHeader& header) {
  FileImage& image = header.image;
  const double unit = unit_of(path, fields, options);
  if (const auto spacing = fields.first_of({"elementspacing", "elementsize"}, dimensions)) {
    for (std::size_t n = 0; n < 3; ++n) {
      if (!((*spacing)[kept[n]] > 0))
        refuse("bad-spacing", path, fmt::format("its header's ElementSpacing holds {}", (*spacing)[kept[n]]));
      image.spacing[n] = (*spacing)[kept[n]] * unit;
    }
  } else if (!options.spacing) {
    header.remarks.push_back("the file gives no spacing: 1 mm is assumed; --spacing X,Y,Z gives the true one");
  }
  if (const auto origin = fields.first_of({"offset", "position", "origin"}, dimensions)) {
    for (std::size_t n = 0; n < 3; ++n) image.origin[n] = (*origin)[kept[n]] * unit;
  }
  if (const auto matrix = fields.first_of({"transformmatrix", "rotation", "orientation"}, dimensions * dimensions)) {
    for (std::size_t n = 0; n < 3; ++n)
      for (std::size_t x = 0; x < 3; ++x) image.direction[n][x] = (*matrix)[kept[n] * dimensions + kept[x]];
  }
  if (options.spacing) image.spacing = *options.spacing;
}

void read_pixels_place(const std::string& path, const MetaFields& fields, const TextHeader& text, std::size_t voxels,
                       const ReadVolumeOptions& options, PixelFiles& pixels) {
  const std::string& name = fields.get("elementtype");
  const auto type =
      std::find_if(element_types.begin(), element_types.end(), [&](const ElementType& t) { return t.name == name; });
  if (type == element_types.end())
    refuse("pixel-type", path,
           fmt::format("the voxels are {}: no plain numbers", name.substr(0, limits::quoted_length)));
  pixels.type = type->type;
  const char* order =
      fields.find("binarydatabyteordermsb") != nullptr ? "binarydatabyteordermsb" : "elementbyteordermsb";
  pixels.swapped = fields.is_true(order) == (std::endian::native == std::endian::little);

  const std::string& data = fields.get("elementdatafile");
  const bool local = lower_case(data) == "local";
  pixels.paths = local ? std::vector<std::string>{path} : data_files_of(path, data, text.list, options.allow_outside);
  pixels.offset = local ? text.end : 0;
  const bool packed_whole = local && is_gzip(path);
  pixels.packed_whole = packed_whole;
  if (fields.find("binarydata") != nullptr && !fields.is_true("binarydata"))
    pixels.encoding = PixelFiles::Encoding::text;
  if (fields.is_true("compresseddata")) {
    if (packed_whole) refuse("unreadable-volume", path, "its pixels are packed within a file that is packed itself");
    pixels.encoding = PixelFiles::Encoding::deflate;
    // Some writers leave the size out: then all that follows is packed pixels.
    if (fields.find("compresseddatasize") != nullptr) {
      const double most = static_cast<double>(voxels * bytes_of(pixels.type)) + limits::header_bytes;
      pixels.packed_bytes = fields.whole("compresseddatasize", most);
    }
  }
  const std::string* skip = fields.find("headersize");
  if (skip == nullptr || *skip == "0") return;
  if (local) refuse("unreadable-volume", path, "its HeaderSize contradicts that its pixels are LOCAL");
  if (*skip == "-1")
    pixels.at_end = true;
  else
    pixels.offset = fields.whole("headersize", 1e15);
}

}  // namespace

VolumeHeader read_meta_image_header(const std::string& path, const ReadVolumeOptions& options) {
  ByteSource source(path, 0, is_gzip(path) ? ByteSource::Packing::zlib_or_gzip : ByteSource::Packing::none);
  const TextHeader text = read_text_header(source, path, {"=:", "elementdatafile", OddLines::refused});
  const MetaFields fields(path, text);
  const std::vector<double> sizes = read_sizes(path, fields);
  const std::size_t voxels = voxels_of(path, sizes);
  const std::vector<std::size_t> kept = three_axes(path, sizes);

  VolumeHeader header;
  header.image.source = path;
  for (std::size_t n = 0; n < 3; ++n) header.image.size[n] = static_cast<std::size_t>(sizes[kept[n]]);
  read_geometry(path, fields, sizes.size(), kept, options, header);
  read_pixels_place(path, fields, text, voxels, options, header.pixels);
  return header;
}

}  // namespace odontoscope
