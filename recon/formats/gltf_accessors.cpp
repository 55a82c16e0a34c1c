#include "recon/formats/gltf_accessors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "recon/core/limits.h"
#include "recon/formats/gltf_buffers.h"
#include "recon/formats/gltf_compression.h"
#include "recon/formats/gltf_extensions.h"
#include "recon/formats/parsing.h"

namespace odontoscope::gltf {
namespace {

using nlohmann::json;
using parsing::at_byte;
using parsing::little_endian;
using parsing::refuse;

constexpr std::size_t header_size = 12, chunk_header_size = 8;
constexpr std::uint32_t json_chunk = 0x4E4F534A, buffer_chunk = 0x004E4942;

struct Chunk {
  std::uint32_t type = 0;
  std::string_view bytes;
  std::size_t offset = 0;
};

/// The bytes that the header announces; what follows is left aside.
std::string_view announced_bytes(std::string_view bytes, const std::string& file) {
  if (bytes.size() < 4 || bytes.substr(0, 4) != "glTF") {
    refuse("bad-header", at_byte(file, 0), "the file does not begin with \"glTF\"", "Export it as binary glTF (.glb)");
  }
  if (bytes.size() < header_size) refuse("truncated", at_byte(file, bytes.size()), "the file ends within its header");
  const auto version = little_endian<std::uint32_t>(bytes, 4);
  if (version != 2)
    refuse("bad-header", at_byte(file, 4), fmt::format("glTF version {} is not known, only 2", version));
  const std::size_t announced = little_endian<std::uint32_t>(bytes, 8);
  if (announced < header_size)
    refuse("bad-header", at_byte(file, 8), fmt::format("its header announces {} bytes", announced));
  if (bytes.size() < announced) {
    refuse("truncated", at_byte(file, 8),
           fmt::format("its header announces {} bytes, and it has {}", announced, bytes.size()),
           "Copy or export it again");
  }
  return bytes.substr(0, announced);
}

Chunk next_chunk(std::string_view bytes, std::size_t at, const std::string& file) {
  if (bytes.size() - at < chunk_header_size)
    refuse("truncated", at_byte(file, at), "the file ends within the head of a chunk");
  const std::size_t length = little_endian<std::uint32_t>(bytes, at);
  const std::size_t offset = at + chunk_header_size;
  if (length > bytes.size() - offset) {
    refuse("truncated", at_byte(file, at),
           fmt::format("a chunk announces {} bytes, and {} are left", length, bytes.size() - offset));
  }
  return {little_endian<std::uint32_t>(bytes, at + 4), bytes.substr(offset, length), offset};
}

/// Where the bytes of an accessor lie.
struct View {
  std::string_view bytes;  // from the accessor's first byte to the view's last
  std::size_t count = 0, stride = 0;
  std::uint64_t component_type = 0;
};

constexpr std::uint64_t signed_byte = 5120, unsigned_byte = 5121, signed_short = 5122, unsigned_short = 5123,
                        unsigned_int = 5125, single = 5126;

std::size_t component_size(std::uint64_t type) {
  switch (type) {
    case signed_byte:
    case unsigned_byte:
      return 1;
    case signed_short:
    case unsigned_short:
      return 2;
    case unsigned_int:
    case single:
      return 4;
    default:
      return 0;
  }
}

/// The bytes of a buffer view, unpacked if need be.
std::string_view view_bytes(const Glb& glb, std::size_t index) {
  const json& view = entry(glb, "bufferViews", index);
  const auto extensions = view.find("extensions");
  if (extensions == view.end() || !extensions->is_object() || !extensions->contains(meshopt_extension))
    return buffer_bytes(glb, view);
  const auto known = glb.unpacked.find(index);
  if (known != glb.unpacked.end()) return known->second;
  std::size_t bytes = 0;
  for (const auto& [number, other] : glb.unpacked) bytes += other.size();
  if (bytes > limits::file_bytes)
    glb.refuse("too-large", fmt::format("the compressed buffer views have more than {} bytes", limits::file_bytes));
  return glb.unpacked.emplace(index, unpacked(glb, view)).first->second;
}

View resolve(const Glb& glb, std::size_t index, const char* wanted_type, std::size_t components) {
  const json& accessor = entry(glb, "accessors", index);
  const auto type = accessor.find("type");
  if (type == accessor.end() || *type != wanted_type) {
    glb.refuse("unsupported", fmt::format("accessor {} is no {}", index, wanted_type));
  }
  if (accessor.contains("sparse")) glb.refuse("unsupported", fmt::format("accessor {} is sparse", index));
  const std::size_t view_index = index_into(glb, accessor, "bufferView", "bufferViews");
  const json& view = entry(glb, "bufferViews", view_index);
  View resolved;
  resolved.component_type = whole(glb, accessor, "componentType", 0);
  const std::size_t size = component_size(resolved.component_type) * components;
  if (size == 0) {
    glb.refuse("unsupported", fmt::format("accessor {} has component type {}", index, resolved.component_type));
  }
  resolved.bytes = view_bytes(glb, view_index);
  resolved.stride = whole(glb, view, "byteStride", size);
  const std::uint64_t offset = whole(glb, accessor, "byteOffset", 0);
  resolved.count = whole(glb, accessor, "count", 0);
  constexpr std::size_t largest_stride = 252;
  if (resolved.stride < size || resolved.stride > largest_stride) {
    glb.refuse("unparsable", fmt::format("a buffer view has a stride of {} bytes", resolved.stride));
  }
  const bool fits =
      resolved.count == 0 || (offset <= resolved.bytes.size() && size <= resolved.bytes.size() - offset &&
                              resolved.count - 1 <= (resolved.bytes.size() - offset - size) / resolved.stride);
  if (!fits) {
    glb.refuse("truncated", fmt::format("accessor {} announces {} elements, more than its buffer view holds", index,
                                        resolved.count));
  }
  resolved.bytes = resolved.count == 0 ? std::string_view() : resolved.bytes.substr(offset);
  return resolved;
}

template <typename Number>
std::array<float, 3> three(const View& view, std::size_t element, bool normalized) {
  std::array<float, 3> values{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto value =
        static_cast<float>(little_endian<Number>(view.bytes, element * view.stride + k * sizeof(Number)));
    values[k] = normalized ? std::max(value / static_cast<float>(std::numeric_limits<Number>::max()), -1.0f) : value;
  }
  return values;
}

/// Whole numbers as KHR_mesh_quantization means them.
std::array<float, 3> quantized(const View& view, std::size_t element, bool normalized) {
  switch (view.component_type) {
    case signed_byte:
      return three<std::int8_t>(view, element, normalized);
    case unsigned_byte:
      return three<std::uint8_t>(view, element, normalized);
    case signed_short:
      return three<std::int16_t>(view, element, normalized);
    default:
      return three<std::uint16_t>(view, element, normalized);
  }
}

void parse_json(Glb& glb, std::string_view text) {
  glb.document = json::parse(text, nullptr, false);
  if (glb.document.is_discarded() || !glb.document.is_object())
    glb.refuse("unparsable", "the JSON part is no JSON object");
  check_extensions(glb);
}

/// Bytes that are not within quotes: those within take no more when parsed.
std::size_t bytes_outside_texts(std::string_view text) {
  std::size_t outside = 0;
  bool within = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (within && text[i] == '\\')
      ++i;
    else if (text[i] == '"')
      within = !within;
    outside += !within;
  }
  return outside;
}

}  // namespace

void Glb::refuse(std::string_view cause, std::string_view wrong, std::string_view remedy) const {
  parsing::refuse(cause, at_byte(file, json_offset), wrong, remedy);
}

Glb parse_container(std::string_view all_bytes, const std::string& file) {
  const std::string_view bytes = announced_bytes(all_bytes, file);
  const Chunk first = next_chunk(bytes, header_size, file);
  if (first.type != json_chunk) refuse("bad-header", at_byte(file, header_size), "the first chunk is not JSON");
  if (first.bytes.size() > limits::gltf_json_bytes) {
    refuse("too-large", at_byte(file, header_size),
           fmt::format("the JSON part has more than {} bytes", limits::gltf_json_bytes));
  }
  Glb glb;
  glb.file = file;
  glb.json_offset = first.offset;
  if (all_bytes.size() > bytes.size())
    glb.remarks.push_back(parsing::bytes_behind_told(all_bytes.size() - bytes.size()));
  for (std::size_t at = first.offset + first.bytes.size(); at < bytes.size();) {
    const Chunk chunk = next_chunk(bytes, at, file);
    if (chunk.type == buffer_chunk && !glb.has_buffer) {
      glb.buffer = chunk.bytes;
      glb.has_buffer = true;
    }
    at = chunk.offset + chunk.bytes.size();
  }
  parse_json(glb, first.bytes);
  return glb;
}

Glb parse_document(std::string_view bytes, const std::string& file) {
  if (bytes_outside_texts(bytes) > limits::gltf_json_bytes) {
    refuse("too-large", at_byte(file, 0),
           fmt::format("it has more than {} bytes besides its texts", limits::gltf_json_bytes));
  }
  Glb glb;
  glb.file = file;
  parse_json(glb, bytes);
  return glb;
}

std::uint64_t whole(const Glb& glb, const json& value, const char* name) {
  constexpr double largest_exact = 9007199254740992.0;  // 2^53
  if (!value.is_number()) glb.refuse("unparsable", fmt::format("\"{}\" is no number", name));
  const double number = value.get<double>();
  if (!(number >= 0) || number > largest_exact || number != std::floor(number)) {
    glb.refuse("unparsable", fmt::format("\"{}\" is no whole number from 0", name));
  }
  return static_cast<std::uint64_t>(number);
}

std::uint64_t whole(const Glb& glb, const json& object, const char* key, std::uint64_t otherwise) {
  const auto found = object.find(key);
  return found == object.end() ? otherwise : whole(glb, *found, key);
}

std::size_t index_into(const Glb& glb, const json& value, const char* of) {
  const std::uint64_t index = whole(glb, value, of);
  if (index >= list(glb, of).size()) {
    glb.refuse("index-out-of-range", fmt::format("number {} is named of {} {}", index, list(glb, of).size(), of));
  }
  return index;
}

std::size_t index_into(const Glb& glb, const json& object, const char* key, const char* of) {
  const auto found = object.find(key);
  if (found == object.end()) glb.refuse("unparsable", fmt::format("\"{}\" is missing", key));
  return index_into(glb, *found, of);
}

const json& list(const Glb& glb, const char* key) {
  static const json empty = json::array();
  const auto found = glb.document.find(key);
  if (found == glb.document.end()) return empty;
  if (!found->is_array()) glb.refuse("unparsable", fmt::format("\"{}\" is no list", key));
  return *found;
}

const json& entry(const Glb& glb, const char* key, std::size_t index) {
  const json& all = list(glb, key);
  if (index >= all.size()) glb.refuse("index-out-of-range", fmt::format("there is no number {} in \"{}\"", index, key));
  if (!all[index].is_object()) glb.refuse("unparsable", fmt::format("number {} in \"{}\" is no object", index, key));
  return all[index];
}

std::string_view buffer_bytes(const Glb& glb, const json& place) {
  const std::string_view buffer = whole_buffer(glb, index_into(glb, place, "buffer", "buffers"));
  const std::uint64_t offset = whole(glb, place, "byteOffset", 0), length = whole(glb, place, "byteLength", 0);
  if (offset > buffer.size() || length > buffer.size() - offset) {
    glb.refuse("truncated",
               fmt::format("a buffer view of {} bytes from {} leaves the buffer of {}", length, offset, buffer.size()));
  }
  return buffer.substr(offset, length);
}

std::vector<std::array<float, 3>> read_positions(const Glb& glb, std::size_t accessor) {
  const View view = resolve(glb, accessor, "VEC3", 3);
  std::vector<std::array<float, 3>> positions;
  positions.reserve(view.count);
  if (view.component_type != single) {
    const json& used = list(glb, "extensionsUsed");
    if (view.component_type == unsigned_int ||
        std::find(used.begin(), used.end(), quantization_extension) == used.end())
      glb.refuse("unsupported", "positions are not single-precision numbers");
    const bool normalized = entry(glb, "accessors", accessor).value("normalized", json(false)) == true;
    for (std::size_t i = 0; i < view.count; ++i) positions.push_back(quantized(view, i, normalized));
    return positions;
  }
  for (std::size_t i = 0; i < view.count; ++i) {
    positions.push_back(little_endian<std::array<float, 3>>(view.bytes, i * view.stride));
  }
  return positions;
}

std::vector<std::uint32_t> read_indices(const Glb& glb, std::size_t accessor) {
  const View view = resolve(glb, accessor, "SCALAR", 1);
  if (view.component_type == single || view.component_type == signed_byte || view.component_type == signed_short)
    glb.refuse("unsupported", "indices are not whole numbers from 0");
  std::vector<std::uint32_t> indices;
  indices.reserve(view.count);
  for (std::size_t i = 0; i < view.count; ++i) {
    const std::size_t at = i * view.stride;
    switch (view.component_type) {
      case unsigned_byte:
        indices.push_back(little_endian<std::uint8_t>(view.bytes, at));
        break;
      case unsigned_short:
        indices.push_back(little_endian<std::uint16_t>(view.bytes, at));
        break;
      default:
        indices.push_back(little_endian<std::uint32_t>(view.bytes, at));
    }
  }
  return indices;
}

}  // namespace odontoscope::gltf
