#include "recon/formats/given_slices.h"

#include "recon/core/limits.h"
#include "recon/formats/gltf_accessors.h"

namespace odontoscope {

std::optional<std::size_t> slices_given(std::string_view bytes, const std::string& file) {
  const gltf::Glb glb =
      bytes.starts_with("glTF") ? gltf::parse_container(bytes, file) : gltf::parse_document(bytes, file);
  const nlohmann::json* found = &glb.document;
  for (const char* key : {"asset", "extras", "slices_checked"}) {
    if (!found->is_object()) return std::nullopt;
    const auto entry = found->find(key);
    if (entry == found->end()) return std::nullopt;
    found = &*entry;
  }
  if (!found->is_number_unsigned()) return std::nullopt;
  const auto slices = found->get<std::uint64_t>();
  if (slices < 2 || slices > limits::slices) return std::nullopt;
  return static_cast<std::size_t>(slices);
}

}  // namespace odontoscope
