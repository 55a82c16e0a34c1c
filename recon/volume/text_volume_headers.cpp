#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <string_view>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/lower_case.h"
#include "recon/volume/text_header.h"
#include "recon/volume/volume_header.h"

namespace odontoscope {
namespace {

[[noreturn]] void refuse(std::string_view cause, const std::string& path, const std::string& wrong) {
  Place place;
  place.file = path;
  throw InputError(cause, place, wrong, "correct the header, or convert the volume with the program that wrote it");
}

// --- MetaImage ---------------------------------------------------------------------------------------------------

struct ElementType {
  std::string_view name;
  std::size_t bytes;
  bool floating;
};
constexpr std::array<ElementType, 12> element_types{{{"MET_CHAR", 1, false},
                                                     {"MET_UCHAR", 1, false},
                                                     {"MET_SHORT", 2, false},
                                                     {"MET_USHORT", 2, false},
                                                     {"MET_INT", 4, false},
                                                     {"MET_UINT", 4, false},
                                                     {"MET_LONG", 4, false},
                                                     {"MET_ULONG", 4, false},
                                                     {"MET_LONG_LONG", 8, false},
                                                     {"MET_ULONG_LONG", 8, false},
                                                     {"MET_FLOAT", 4, true},
                                                     {"MET_DOUBLE", 8, true}}};

/// A MetaImage header by key; each may come once only, since the reader behind takes the last of two for the first
/// one's memory.
class MetaFields {
 public:
  MetaFields(const std::string& path, const TextHeader& header) : path_(path) {
    for (const HeaderField& field : header.fields) {
      if (!values_.emplace(field.key, field.value).second) {
        refuse("unreadable-volume", path,
               fmt::format("its header gives {} twice", field.key.substr(0, limits::quoted_length)));
      }
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
    std::istringstream in(get(key));
    std::vector<double> found;
    for (std::string word; in >> word;) {
      double number = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
      if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(number)) {
        refuse("unreadable-volume", path_, fmt::format("its header's {} is not made of finite numbers", key));
      }
      found.push_back(number);
    }
    if (found.size() != count) {
      refuse("unreadable-volume", path_,
             fmt::format("its header's {} has {} numbers instead of {}", key, found.size(), count));
    }
    return found;
  }

  /// A whole number from 0 to `most`.
  std::size_t whole(const std::string& key, double most) const {
    const double number = numbers(key, 1).front();
    if (number != std::floor(number) || number < 0 || number > most) {
      refuse("unreadable-volume", path_, fmt::format("its header's {} is {}", key, number));
    }
    return static_cast<std::size_t>(number);
  }

 private:
  std::string path_;
  std::map<std::string, std::string> values_;
};

std::size_t voxels_of(const std::string& path, const std::vector<double>& size) {
  double voxels = 1;
  for (const double length : size) {
    if (length != std::floor(length) || length < 1)
      refuse("empty-volume", path, fmt::format("one of its sizes is {}", length));
    voxels *= length;
  }
  if (voxels > static_cast<double>(limits::voxels)) {
    refuse("too-many-voxels", path, fmt::format("it has {:.3g} voxels; the limit is {}", voxels, limits::voxels));
  }
  return static_cast<std::size_t>(voxels);
}

const ElementType& element_type(const std::string& path, const MetaFields& fields) {
  const std::string& name = fields.get("elementtype");
  const auto type =
      std::find_if(element_types.begin(), element_types.end(), [&](const auto& t) { return t.name == name; });
  if (type == element_types.end()) {
    refuse("pixel-type", path,
           fmt::format("the voxels are {}: no plain numbers", name.substr(0, limits::quoted_length)));
  }
  return *type;
}

/// Fields whose length follows from the number of dimensions: the reader behind copies them unasked.
void check_geometry(const std::string& path, const MetaFields& fields, std::size_t dimensions) {
  for (const char* key : {"offset", "position", "origin", "centerofrotation", "elementsize"}) {
    if (fields.find(key) != nullptr) fields.numbers(key, dimensions);
  }
  for (const char* key : {"transformmatrix", "rotation", "orientation"}) {
    if (fields.find(key) != nullptr) fields.numbers(key, dimensions * dimensions);
  }
  if (fields.find("elementspacing") == nullptr) return;
  for (const double spacing : fields.numbers("elementspacing", dimensions)) {
    if (!(spacing > 0)) refuse("bad-spacing", path, fmt::format("its header's ElementSpacing holds {}", spacing));
  }
}

}  // namespace

PixelClaim read_meta_image_header(const std::string& path) {
  const TextHeader header = read_text_header(path, {"=:", "elementdatafile", OddLines::refused});
  const MetaFields fields(path, header);
  const std::size_t dimensions = fields.whole("ndims", 1e9);
  if (dimensions != 3) refuse("not-3d", path, fmt::format("the image has {} dimensions instead of 3", dimensions));
  if (fields.find("elementnumberofchannels") != nullptr && fields.whole("elementnumberofchannels", 1e9) != 1) {
    refuse("not-scalar", path, "each voxel has several numbers (a colour or a vector)");
  }
  check_geometry(path, fields, dimensions);
  const ElementType& type = element_type(path, fields);

  PixelClaim claim;
  claim.bytes = voxels_of(path, fields.numbers("dimsize", dimensions)) * type.bytes;
  const std::string& data = fields.get("elementdatafile");
  const bool local = lower_case(data) == "local";
  claim.file.path = local ? path : data_file_beside(path, data);
  claim.file.offset = local ? header.end : 0;
  if (fields.is_true("compresseddata")) {
    claim.file.packing = PixelFile::Packing::deflate;
    // Without the size the reader behind unpacks too little, and leaves zeros.
    const double most = static_cast<double>(*claim.bytes) + limits::header_bytes;
    claim.file.packed_bytes = fields.whole("compresseddatasize", most);
    if (claim.file.packed_bytes == 0) refuse("unreadable-volume", path, "its header's CompressedDataSize is 0");
  }
  if (fields.find("binarydata") != nullptr && !fields.is_true("binarydata")) {
    refuse("pixel-type", path, "its pixels are written as text, which is not read here");
  }
  if (const std::string* skip = fields.find("headersize"); skip != nullptr && *skip != "0") {
    if (local) refuse("unreadable-volume", path, "its HeaderSize contradicts that its pixels are LOCAL");
    // -1: the pixels are the end of the file, whatever comes before.
    if (*skip != "-1") claim.file.offset = fields.whole("headersize", 1e15);
  }
  return claim;
}

// --- NRRD --------------------------------------------------------------------------------------------------------

PixelClaim read_nrrd_header(const std::string& path) {
  PixelClaim claim;
  claim.file.path = path;
  bool attached = true;
  bool skips = false;
  std::string encoding;
  const TextHeader header = read_text_header(path, {":", "", OddLines::passed_over});
  for (const HeaderField& field : header.fields) {
    if (field.key == "encoding") encoding = lower_case(field.value);
    skips = skips || field.key.ends_with("skip");
    if (field.key == "data file" || field.key == "datafile") {
      claim.file.path = data_file_beside(path, field.value);
      attached = false;
    }
  }
  if (attached && !skips) claim.file.offset = header.end;
  const bool gzip = encoding == "gzip" || encoding == "gz";
  if (gzip && !skips) {
    claim.file.packing = PixelFile::Packing::deflate;
  } else if (encoding != "raw") {
    claim.file.packing = PixelFile::Packing::other;
  }
  return claim;
}

}  // namespace odontoscope
