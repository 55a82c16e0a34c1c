#pragma once
// The files that one call writes: looked at before the long work, written all or none after it.

#include <string>
#include <string_view>
#include <vector>

#include "engine/app/interrupt.h"
#include "recon/core/atomic_file.h"

namespace odontoscope::app {

/// Refuses what could only fail later. UsageError: two outputs are one file, or an output is also an input.
/// FileError: an output cannot be written. Removes what killed runs left in the outputs' folders.
struct PlannedFiles {
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;
};
void refuse_unwritable(const PlannedFiles& files);

/// The ending of a file's name in lower case, with the dot; UsageError unless it is one of `known`.
std::string known_ending(const std::string& file, const std::vector<std::string>& known);

/// All files or none, undisturbed by Ctrl-C.
void write_all(const std::vector<FileContent>& files, Interrupts& interrupts);

}  // namespace odontoscope::app
