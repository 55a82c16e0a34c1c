#include "recon/formats/compress_glb.h"

#include <meshoptimizer.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "recon/core/base64.h"
#include "recon/core/error.h"
#include "recon/formats/little_endian.h"

namespace odontoscope {
namespace {

using nlohmann::json;

constexpr const char* extension = "EXT_meshopt_compression";
constexpr std::uint32_t json_chunk = 0x4E4F534A, buffer_chunk = 0x004E4942;

struct Parts {
  json document;
  std::string buffer;
};

Parts parts_of(const std::string& glb) {
  constexpr std::size_t heads = 20, chunk_head = 8;
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, sizeof(length));
  Parts parts{json::parse(glb.substr(heads, length)), {}};
  if (heads + length < glb.size()) parts.buffer = glb.substr(heads + length + chunk_head);
  return parts;
}

/// Numbers of a view, to be changed in place.
template <class Number>
Number* numbers(Parts& parts, const json& accessor) {
  const json& view = parts.document["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  return reinterpret_cast<Number*>(parts.buffer.data() + view.value("byteOffset", std::size_t{0}));
}

/// Triangles in an order in which each shares an edge with one before where it can, and vertices in the order of their
/// first use.
void put_in_order(Parts& parts, const json& primitive) {
  const json& accessors = parts.document["accessors"];
  const json &corners = accessors[primitive["indices"].get<std::size_t>()],
             &positions = accessors[primitive["attributes"]["POSITION"].get<std::size_t>()];
  auto* indices = numbers<unsigned int>(parts, corners);
  const std::size_t count = corners["count"], vertices = positions["count"];
  std::vector<unsigned int> ordered(count), place(vertices);
  meshopt_optimizeVertexCacheStrip(ordered.data(), indices, count, vertices);
  meshopt_optimizeVertexFetchRemap(place.data(), ordered.data(), count, vertices);
  meshopt_remapIndexBuffer(indices, ordered.data(), count, place.data());
  for (const json& attribute : primitive["attributes"]) {
    auto* values = numbers<float>(parts, accessors[attribute.get<std::size_t>()]);
    const std::vector<float> before(values, values + 3 * vertices);
    meshopt_remapVertexBuffer(values, before.data(), vertices, 3 * sizeof(float), place.data());
  }
}

std::size_t components(const json& accessor) {
  const std::string type = accessor["type"];
  return type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4;
}

std::string encoded(const char* data, std::size_t count, std::size_t stride, bool triangles) {
  std::string bytes(
      triangles ? meshopt_encodeIndexBufferBound(count, count) : meshopt_encodeVertexBufferBound(count, stride), '\0');
  auto* out = reinterpret_cast<unsigned char*>(bytes.data());
  bytes.resize(triangles
                   ? meshopt_encodeIndexBuffer(out, bytes.size(), reinterpret_cast<const unsigned int*>(data), count)
                   : meshopt_encodeVertexBuffer(out, bytes.size(), data, count, stride));
  if (bytes.empty()) throw InternalError("meshoptimizer compressed nothing");
  return bytes;
}

void pad(std::string& bytes, char with) { bytes.resize((bytes.size() + 3) / 4 * 4, with); }

/// Every view replaced by its compressed form. They name a second buffer, which holds nothing, for readers to unpack
/// into.
Parts compressed(Parts plain) {
  json& document = plain.document;
  if (!document.contains("buffers")) return plain;
  for (const json& mesh : document["meshes"])
    for (const json& primitive : mesh["primitives"]) put_in_order(plain, primitive);
  meshopt_encodeVertexVersion(0);  // the versions that the extension knows
  meshopt_encodeIndexVersion(1);
  std::string buffer;
  for (const json& accessor : document["accessors"]) {
    json& view = document["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    constexpr int element_array = 34963;
    const bool triangles = view.value("target", 0) == element_array;
    const std::size_t count = accessor["count"], stride = components(accessor) * sizeof(float);
    const std::string bytes =
        encoded(plain.buffer.data() + view.value("byteOffset", std::size_t{0}), count, stride, triangles);
    view["buffer"] = 1;
    view["extensions"][extension] = {{"buffer", 0},
                                     {"byteOffset", buffer.size()},
                                     {"byteLength", bytes.size()},
                                     {"byteStride", stride},
                                     {"count", count},
                                     {"mode", triangles ? "TRIANGLES" : "ATTRIBUTES"}};
    buffer += bytes;
    pad(buffer, '\0');
  }
  json unpacked = {{"byteLength", document["buffers"][0]["byteLength"]}};
  unpacked["extensions"][extension]["fallback"] = true;
  document["buffers"] = {{{"byteLength", buffer.size()}}, std::move(unpacked)};
  document["extensionsUsed"] = document["extensionsRequired"] = {extension};
  return {std::move(plain.document), std::move(buffer)};
}

}  // namespace

std::string compressed_glb(const std::string& glb) {
  const Parts parts = compressed(parts_of(glb));
  if (parts.buffer.empty()) return glb;
  std::string text = parts.document.dump();
  pad(text, ' ');
  std::string bytes = "glTF";
  constexpr std::size_t heads = 28;
  append(bytes, std::uint32_t{2});
  append(bytes, static_cast<std::uint32_t>(heads + text.size() + parts.buffer.size()));
  append(bytes, static_cast<std::uint32_t>(text.size()));
  append(bytes, json_chunk);
  bytes += text;
  append(bytes, static_cast<std::uint32_t>(parts.buffer.size()));
  append(bytes, buffer_chunk);
  return bytes + parts.buffer;
}

std::string compressed_gltf(const std::string& glb) {
  Parts parts = compressed(parts_of(glb));
  if (!parts.buffer.empty())
    parts.document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(parts.buffer);
  constexpr int indent = 2;
  return parts.document.dump(indent) + "\n";
}

}  // namespace odontoscope
