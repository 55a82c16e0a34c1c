#include "recon/formats/gltf_buffers.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "recon/core/base64.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/read_file.h"
#include "recon/formats/parsing.h"

namespace odontoscope::gltf {
namespace {

using nlohmann::json;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// "%20" and the like as what they stand for.
std::string unescaped(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escaped =
        uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0;
    text += escaped ? static_cast<char>(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2])) : uri[i];
    if (escaped) i += 2;
  }
  return text;
}

std::string from_data_uri(const Glb& glb, std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == uri.npos) glb.refuse("unparsable", "a data URI has no comma");
  const std::string_view data = uri.substr(comma + 1);
  if (!uri.substr(0, comma).ends_with(";base64")) return unescaped(data);
  std::optional<std::string> bytes = from_base64(data);
  if (!bytes) glb.refuse("unparsable", "a buffer's data is not in base64");
  return std::move(*bytes);
}

bool leads_below(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code error;
  const auto above = std::filesystem::weakly_canonical(folder, error),
             below = std::filesystem::weakly_canonical(file, error);
  if (error) return false;
  return std::mismatch(above.begin(), above.end(), below.begin(), below.end()).first == above.end();
}

std::string from_file(const Glb& glb, std::string_view uri) {
  const std::string name = unescaped(uri);
  std::filesystem::path folder = std::filesystem::path(glb.file).parent_path();
  if (folder.empty()) folder = ".";
  const std::filesystem::path relative(name);
  const bool has_scheme = name.find(':') != name.npos,
             climbs = std::find(relative.begin(), relative.end(), "..") != relative.end();
  if (name.empty() || name.find('\0') != name.npos || has_scheme || climbs || relative.is_absolute() ||
      !leads_below(folder, folder / relative)) {
    glb.refuse("unsupported",
               fmt::format("the buffer \"{}\" lies outside the file's own folder",
                           parsing::tame(name.substr(0, limits::quoted_length))),
               "Put it beside the file, or export it as one .glb");
  }
  const std::filesystem::path file = folder / relative;
  std::error_code error;
  if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error)) {
    throw FileError(file.string(), "cannot be read: it is no regular file", {});
  }
  return read_file(file.string());
}

}  // namespace

std::string_view whole_buffer(const Glb& glb, std::size_t index) {
  const auto known = glb.fetched.find(index);
  if (known != glb.fetched.end()) return known->second;
  const json& buffer = entry(glb, "buffers", index);
  const auto uri = buffer.find("uri");
  if (uri == buffer.end()) {
    if (index != 0 || !glb.has_buffer)
      glb.refuse("unsupported", fmt::format("buffer {} has no data", index), "Export it with its data");
    return glb.buffer;
  }
  if (!uri->is_string()) glb.refuse("unparsable", "\"uri\" is no text");
  const auto& text = uri->get_ref<const std::string&>();
  std::size_t bytes = 0;
  for (const auto& [number, other] : glb.fetched) bytes += other.size();
  std::string fetched = text.starts_with("data:") ? from_data_uri(glb, text) : from_file(glb, text);
  if (bytes + fetched.size() > limits::file_bytes)
    glb.refuse("file-too-large", fmt::format("its buffers have more than {} bytes", limits::file_bytes));
  return glb.fetched.emplace(index, std::move(fetched)).first->second;
}

}  // namespace odontoscope::gltf
