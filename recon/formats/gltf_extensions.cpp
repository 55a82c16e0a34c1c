#include "recon/formats/gltf_extensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "recon/core/limits.h"
#include "recon/formats/gltf_compression.h"
#include "recon/formats/parsing.h"

namespace odontoscope::gltf {
namespace {

using nlohmann::json;

constexpr std::string_view instancing_extension = "EXT_mesh_gpu_instancing";

/// Looks, lights, sounds and notes, by the words of the registry's names.
bool says_nothing_of_shape(std::string_view name) {
  for (const std::string_view word : {"_materials_", "_texture_", "_lights_", "_packing_"}) {
    if (name.find(word) != name.npos) return true;
  }
  constexpr std::array<std::string_view, 19> others{"KHR_xmp",
                                                    "KHR_xmp_json_ld",
                                                    "KHR_animation_pointer",
                                                    "KHR_audio_emitter",
                                                    "KHR_techniques_webgl",
                                                    "KHR_interactivity",
                                                    "KHR_node_hoverability",
                                                    "KHR_node_selectability",
                                                    "EXT_structural_metadata",
                                                    "EXT_mesh_features",
                                                    "EXT_instance_features",
                                                    "EXT_feature_metadata",
                                                    "CESIUM_primitive_outline",
                                                    "AGI_articulations",
                                                    "AGI_stk_metadata",
                                                    "FB_geometry_metadata",
                                                    "MOZ_lightmap",
                                                    "GODOT_single_root",
                                                    "EXT_mesh_manifold"};
  return std::find(others.begin(), others.end(), name) != others.end();
}

}  // namespace

void check_extensions(Glb& glb) {
  for (const json& extension : list(glb, "extensionsRequired")) {
    if (extension == meshopt_extension || extension == quantization_extension) continue;
    const std::string name = extension.is_string() ? extension.get<std::string>() : "?";
    if (says_nothing_of_shape(name)) continue;
    glb.refuse("unsupported",
               fmt::format("it requires the extension {}, which is not understood here",
                           parsing::tame(name.substr(0, limits::quoted_length))),
               "Export it without that extension");
  }
  const json& used = list(glb, "extensionsUsed");
  if (std::find(used.begin(), used.end(), instancing_extension) != used.end()) {
    glb.remarks.push_back(
        fmt::format("{} is not understood: a mesh that it draws many times is read once", instancing_extension));
  }
}

}  // namespace odontoscope::gltf
