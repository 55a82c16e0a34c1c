#pragma once
// Contours from files of other programs, told by what is in them.
//
//   Reconstruct series   `.ser` and its sections NAME.1, NAME.2, ... beside it (read_series.h)
//   PyReconstruct        `.jser`, the same in one JSON file (read_jser.h)
//   CSL                  parallel planes of the cross-section literature (read_csl.h)
//   DICOM RTSTRUCT       structure sets of radiotherapy (read_rtstruct.h)
//
// What comes back is in millimetres and within the limits of contour_stack.h, but as the file has it: `validate` may
// refuse it, and `repair_contours` may mend it.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/input/patient_origin.h"

namespace odontoscope {

struct FileContours {
  ContourStack stack;
  /// What was left out or is worth knowing, in words.
  std::vector<std::string> remarks;
  /// Of structure sets.
  PatientOrigin patient = {};
};

enum class ContourFileKind { series, jser, csl, rtstruct };

/// Nothing if `bytes` (all, or the first few thousand) are of no such file.
std::optional<ContourFileKind> contour_file_kind(std::string_view bytes);

/// Reads `file`, whose content is `bytes`. `structures` are those wanted, in any order; all if empty. Throws FileError,
/// or InputError with one of the causes of the readers, or unknown-structure.
FileContours read_contour_file(ContourFileKind kind, std::string_view bytes, const std::string& file,
                               const std::vector<std::string>& structures = {});

/// Drops all other structures; throws InputError unknown-structure, listing those that are there. For readers of any
/// format.
void keep_structures(ContourStack& stack, const std::vector<std::string>& structures);

}  // namespace odontoscope
