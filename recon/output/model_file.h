#pragma once
// A reconstruction as a file, in the format that the file's name asks for.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "recon/core/atomic_file.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/distance/db_reconstruction.h"

namespace odontoscope {

/// ".glb", ".stl", ".ply", ".vtu": the endings that are known, in lower case; those of a file may be in any.
const std::vector<std::string>& model_endings();
/// Those that hold surfaces: all but ".vtu".
const std::vector<std::string>& surface_endings();

/// The bytes of `file`, which is not touched yet: give all that belong together to write_files
/// (recon/core/atomic_file.h). UsageError for an ending that is not known. See write_glb.h, write_stl.h, write_ply.h,
/// write_vtu.h for what each holds.
FileContent model_file(const Reconstruction& reconstruction, const std::filesystem::path& file);
/// The same of a DB model; UsageError for ".vtu" too, since it has no tetrahedra.
FileContent model_file(const DbReconstruction& reconstruction, const std::filesystem::path& file);

/// Writes all files or none. UsageError, FileError.
void write_model(const Reconstruction& reconstruction, std::span<const std::filesystem::path> files);

}  // namespace odontoscope
