#include "recon/formats/gltf_compression.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include "recon/core/limits.h"

namespace odontoscope::gltf {
namespace {

using nlohmann::json;

/// `object[key]` as text; `otherwise` where it is missing.
std::string word(const Glb& glb, const json& object, const char* key, const char* otherwise) {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  if (!found->is_string()) glb.refuse("unparsable", fmt::format("\"{}\" is no text", key));
  return found->get<std::string>();
}

struct Packed {
  std::string_view bytes;
  std::string mode, filter;
  std::size_t count = 0, stride = 0;
};

/// Of "ATTRIBUTES", "TRIANGLES" and "INDICES" each has its own rules.
void check_shape(const Glb& glb, const Packed& packed) {
  constexpr std::size_t largest_stride = 256;
  const bool attributes = packed.mode == "ATTRIBUTES", triangles = packed.mode == "TRIANGLES";
  if (!attributes && !triangles && packed.mode != "INDICES")
    glb.refuse("unparsable", "a compressed buffer view has a mode that is not known");
  const bool stride_fits = attributes ? packed.stride > 0 && packed.stride <= largest_stride && packed.stride % 4 == 0
                                      : packed.stride == 2 || packed.stride == 4;
  if (!stride_fits)
    glb.refuse("unparsable", fmt::format("a compressed buffer view has a stride of {} bytes", packed.stride));
  if (triangles && packed.count % 3 != 0)
    glb.refuse("not-triangles", fmt::format("{} compressed corners make no whole triangles", packed.count));
  if (packed.filter != "NONE" && !(attributes && packed.filter == "EXPONENTIAL"))
    glb.refuse("unsupported", "positions or indices are compressed with a filter that is not for them");
}

Packed described(const Glb& glb, const json& view) {
  const json& extension = view["extensions"][meshopt_extension];
  if (!extension.is_object()) glb.refuse("unparsable", "what is said of a compressed buffer view is no object");
  Packed packed;
  packed.bytes = buffer_bytes(glb, extension);
  packed.mode = word(glb, extension, "mode", "");
  packed.filter = word(glb, extension, "filter", "NONE");
  packed.count = whole(glb, extension, "count", 0);
  packed.stride = whole(glb, extension, "byteStride", 0);
  check_shape(glb, packed);
  // Two bits for sixteen equal bytes are the least that any of the three takes.
  constexpr std::size_t best_ratio = 64;
  if (packed.count > packed.bytes.size() * best_ratio / packed.stride)
    glb.refuse("truncated", fmt::format("{} bytes cannot hold the {} elements that a compressed buffer view announces",
                                        packed.bytes.size(), packed.count));
  return packed;
}

}  // namespace

std::string unpacked(const Glb& glb, const json& view) {
  const Packed packed = described(glb, view);
  const std::size_t size = packed.count * packed.stride;
  if (size > limits::file_bytes)
    glb.refuse("too-large", fmt::format("a compressed buffer view has more than {} bytes", limits::file_bytes));
  std::string bytes(size, '\0');
  const auto* from = reinterpret_cast<const unsigned char*>(packed.bytes.data());
  int failed = 0;
  if (packed.mode == "ATTRIBUTES")
    failed = meshopt_decodeVertexBuffer(bytes.data(), packed.count, packed.stride, from, packed.bytes.size());
  if (packed.mode == "TRIANGLES")
    failed = meshopt_decodeIndexBuffer(bytes.data(), packed.count, packed.stride, from, packed.bytes.size());
  if (packed.mode == "INDICES")
    failed = meshopt_decodeIndexSequence(bytes.data(), packed.count, packed.stride, from, packed.bytes.size());
  if (failed != 0)
    glb.refuse("damaged-buffer", "a compressed buffer view cannot be unpacked", "Copy or export it again");
  if (packed.filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), packed.count, packed.stride);
  return bytes;
}

}  // namespace odontoscope::gltf
