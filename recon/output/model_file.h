#pragma once
// A reconstruction as a file, in the format that the file's name asks for.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "recon/core/atomic_file.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/formats/write_glb.h"

namespace odontoscope {

/// ".glb", ".stl", ".ply" ...: the endings that are known, in lower case; those of a file may be in any.
const std::vector<std::string>& model_endings();
/// Those that hold surfaces, and those that hold tetrahedra: ".vtu", ".msh", ".inp".
const std::vector<std::string>& surface_endings();
const std::vector<std::string>& tetrahedra_endings();

/// The bytes of `file`, which is not touched yet: give all that belong together to write_files
/// (recon/core/atomic_file.h). UsageError for an ending that is not known. See the write_*.h of this folder for what
/// each holds. `glb` is for .glb and .gltf.
FileContent model_file(const Reconstruction& reconstruction, const std::filesystem::path& file,
                       const GlbOptions& glb = {});
/// The same of a DB model; UsageError for formats of tetrahedra too, since it has none.
FileContent model_file(const DbReconstruction& reconstruction, const std::filesystem::path& file,
                       const GlbOptions& glb = {});

/// Writes all files or none. UsageError, FileError.
void write_model(const Reconstruction& reconstruction, std::span<const std::filesystem::path> files);

}  // namespace odontoscope
