#include "recon/volume/volume_data_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "recon/core/error.h"
#include "recon/core/limits.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;

struct DataFile {
  fs::path path;
  bool raw = true;
};

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Calls `take(key in lower case, value)` for each line of a text header until that returns false or an empty line or the limit comes.
template <class Take>
void for_each_field(const fs::path& path, char separator, const Take& take) {
  std::ifstream in(path, std::ios::binary);
  std::size_t read = 0;
  std::string line;
  for (char c; read < limits::header_bytes && in.get(c); ++read) {
    if (c != '\n') {
      line += c;
      continue;
    }
    const std::string_view text = trimmed(line);
    if (text.empty()) return;
    const std::size_t at = text.find(separator);
    if (at != std::string_view::npos && text.front() != '#') {
      if (!take(lower(trimmed(text.substr(0, at))), std::string(trimmed(text.substr(at + 1))))) return;
    }
    line.clear();
  }
}

fs::path beside(const fs::path& header, const std::string& name) {
  const fs::path path(name);
  return path.is_absolute() ? path : header.parent_path() / path;
}

[[noreturn]] void refuse_many(const fs::path& header, const std::string& name) {
  Place place;
  place.file = header.string();
  throw InputError("many-data-files", place, fmt::format("the pixels are spread over several files (\"{}\")", name),
                   "convert the volume to one file");
}

DataFile nrrd_data(const fs::path& header) {
  DataFile data{header};
  for_each_field(header, ':', [&](const std::string& key, const std::string& value) {
    if (key == "encoding") data.raw = lower(value) == "raw";
    if (key == "data file" || key == "datafile") {
      if (lower(value).starts_with("list") || value.find('%') != std::string::npos) refuse_many(header, value);
      data.path = beside(header, value);
    }
    return true;
  });
  return data;
}

DataFile meta_image_data(const fs::path& header) {
  DataFile data{header};
  for_each_field(header, '=', [&](const std::string& key, const std::string& value) {
    if (key == "compresseddata" && !value.empty()) data.raw = value.front() != 'T' && value.front() != 't';
    if (key != "elementdatafile") return true;
    if (lower(value).starts_with("list") || value.find('%') != std::string::npos) refuse_many(header, value);
    if (lower(value) != "local") data.path = beside(header, value);
    return false;
  });
  return data;
}

DataFile nifti_data(fs::path path) {
  if (path.extension() == ".hdr") {
    path.replace_extension(".img");
    if (!fs::exists(path)) path += ".gz";
  }
  return {path, path.extension() != ".gz"};
}

DataFile data_of(const fs::path& path, VolumeFormat format) {
  switch (format) {
    case VolumeFormat::nrrd: return nrrd_data(path);
    case VolumeFormat::meta_image: return meta_image_data(path);
    case VolumeFormat::nifti: return nifti_data(path);
  }
  throw InternalError("unknown volume format");
}

}  // namespace

void check_data_file(const std::string& path, VolumeFormat format, std::size_t bytes) {
  const DataFile data = data_of(path, format);
  std::error_code error;
  if (!fs::is_regular_file(data.path, error)) {
    throw FileError(data.path.string(), "does not exist or is no plain file, but is to hold the pixels",
                    fmt::format("put it beside {}", path));
  }
  const std::uintmax_t length = fs::file_size(data.path, error);
  const std::uintmax_t needed = data.raw ? bytes : bytes / limits::compression_ratio;
  if (!error && length >= needed) return;
  Place place;
  place.file = data.path.string();
  throw InputError("truncated-volume", place,
                   fmt::format("the header promises {} bytes of pixels, the file has {} bytes{}", bytes, length,
                               data.raw ? "" : " (compressed)"),
                   "get a whole copy of the file, or correct the sizes in its header");
}

}  // namespace odontoscope
