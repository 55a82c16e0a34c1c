#pragma once
// Contours and solids as files that go back to where images come from: DICOM RTSTRUCT and SEG, label maps.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "recon/core/atomic_file.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/input/contour_stack.h"
#include "recon/input/patient_origin.h"
#include "recon/segmentation/voxel_grid.h"

namespace odontoscope::app {

/// What an input says of itself beside its contours.
struct Whence {
  PatientOrigin patient;
  /// Of volumes.
  std::optional<VoxelGrid> grid;
};

/// As typed.
struct VoxelWords {
  std::string size, origin;  // "X,Y,Z"
};

void add_voxel_options(CLI::App& parser, VoxelWords& words);

/// Does the name's ending ask for one of these formats?
bool is_structures_file(const std::string& file);

/// UsageError for words about voxels without a file that is made of them, or such a file where neither words nor a
/// volume say how large voxels are.
void refuse_senseless(const VoxelWords& words, const std::vector<std::string>& outputs, bool of_volume);

/// UsageError for such a file of a volume that was cropped, resampled or turned: it would refer to slices that are no
/// longer there.
void refuse_reshaped(const std::vector<std::string>& outputs);

/// `file`, not yet written, and tells what is worth knowing of it. Slices become the slices of voxels: UsageError where
/// --voxels says another distance, InputError uneven-slices. Precondition: `validate` passed.
FileContent structures_file(const ContourStack& stack, const std::string& file, const VoxelWords& words,
                            const Whence& whence, Session& session);

/// The same of solids, whose voxels may lie between the slices of `stack`.
FileContent structures_file(const Reconstruction& model, const ContourStack& stack, const std::string& file,
                            const VoxelWords& words, const Whence& whence, Session& session);

}  // namespace odontoscope::app
