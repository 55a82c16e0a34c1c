#include "recon/formats/read_mesh.h"

#include <fmt/format.h>

#include <filesystem>

#include "recon/core/error.h"
#include "recon/core/read_file.h"
#include "recon/formats/parsing.h"

namespace odontoscope {

const std::vector<std::string>& mesh_endings() {
  static const std::vector<std::string> endings{".glb", ".gltf", ".stl", ".ply", ".obj"};
  return endings;
}

std::vector<NamedMesh> read_mesh(const std::string& file) {
  using Parser = std::vector<NamedMesh> (*)(std::string_view, const std::string&);
  constexpr Parser parsers[] = {parse_glb, parse_gltf, parse_stl, parse_ply, parse_obj};
  const std::string ending = std::filesystem::path(file).extension().string();
  for (std::size_t i = 0; i < mesh_endings().size(); ++i) {
    if (parsing::same_word(ending, mesh_endings()[i])) return parsers[i](read_file(file), file);
  }
  throw UsageError(fmt::format("{}: the ending tells no mesh format", file),
                   fmt::format("Known are {}", fmt::join(mesh_endings(), ", ")));
}

}  // namespace odontoscope
