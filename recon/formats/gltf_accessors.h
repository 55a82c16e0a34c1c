#pragma once
// The numbers of glTF, in one file or with its data beside it: the parts told apart, and accessors read with every
// bound checked. For the .cpp files of this room only.

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace odontoscope::gltf {

struct Glb {
  nlohmann::json document;
  std::string_view buffer;  // the binary part of a .glb; empty if there is none
  bool has_buffer = false;
  std::string file;
  std::size_t json_offset = 0;
  std::vector<std::string> remarks;  // see NamedMesh
  /// Compressed buffer views that were asked for, by number: each is unpacked once.
  mutable std::map<std::size_t, std::string> unpacked;
  /// Buffers from data URIs and from files beside, by number: each is fetched once.
  mutable std::map<std::size_t, std::string> fetched;

  /// InputError at the JSON part.
  [[noreturn]] void refuse(std::string_view cause, std::string_view wrong, std::string_view remedy = {}) const;
};

/// Splits and parses a .glb; causes truncated, bad-header, unparsable, too-large, unsupported (see gltf_extensions.h).
Glb parse_container(std::string_view bytes, const std::string& file);
/// The same of a .gltf, which is JSON alone.
Glb parse_document(std::string_view bytes, const std::string& file);

/// `object[key]` as a whole number from 0 to 2^53; `otherwise` where it is missing. InputError unparsable if it is
/// something else.
std::uint64_t whole(const Glb& glb, const nlohmann::json& object, const char* key, std::uint64_t otherwise);
/// `value` itself, which is called `name` in messages.
std::uint64_t whole(const Glb& glb, const nlohmann::json& value, const char* name);
/// The same, required, and below the length of the document's array `of`. InputError index-out-of-range.
std::size_t index_into(const Glb& glb, const nlohmann::json& object, const char* key, const char* of);
/// `value` itself. Never copies it: a copy of deeply nested JSON would overflow the stack.
std::size_t index_into(const Glb& glb, const nlohmann::json& value, const char* of);
/// document[key], an array; an empty one where it is missing.
const nlohmann::json& list(const Glb& glb, const char* key);
/// document[key][index], an object.
const nlohmann::json& entry(const Glb& glb, const char* key, std::size_t index);

/// The part of a buffer that `place` names by buffer, byteOffset and byteLength. InputError truncated, and those of
/// gltf_buffers.h.
std::string_view buffer_bytes(const Glb& glb, const nlohmann::json& place);

/// A VEC3 of floats, or, where the file says that it uses KHR_mesh_quantization, of bytes or shorts.
std::vector<std::array<float, 3>> read_positions(const Glb& glb, std::size_t accessor);
/// A SCALAR of unsigned bytes, shorts or ints.
std::vector<std::uint32_t> read_indices(const Glb& glb, std::size_t accessor);

}  // namespace odontoscope::gltf
