#include "engine/app/outputs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "recon/core/error.h"
#include "recon/core/lower_case.h"

namespace odontoscope::app {
namespace {

namespace fs = std::filesystem;

/// By name with links followed, or by being one file on the disk (hard links).
bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::exists(a, error) && fs::exists(b, error)) return fs::equivalent(a, b, error);
  return fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

}  // namespace

void refuse_unwritable(const PlannedFiles& files) {
  for (std::size_t i = 0; i < files.outputs.size(); ++i) {
    const std::string& output = files.outputs[i];
    for (std::size_t j = 0; j < i; ++j) {
      if (!same_file(output, files.outputs[j])) continue;
      throw UsageError(fmt::format("{} is named twice as an output", output), "Give every output a name of its own");
    }
    for (const std::string& input : files.inputs) {
      if (!same_file(output, input)) continue;
      throw UsageError(fmt::format("{} is both input and output", output), "Give the output another name");
    }
  }
  for (const std::string& output : files.outputs) remove_leftovers(fs::path(output).parent_path());
  // Opening what comes before a rename, and dropping it, is the surest test of whether it will open later.
  for (const std::string& output : files.outputs) AtomicFile trial{output};
}

std::string known_ending(const std::string& file, const std::vector<std::string>& known) {
  std::string ending = lower_case(fs::path(file).extension().string());
  if (std::find(known.begin(), known.end(), ending) != known.end()) return ending;
  const std::string found = ending.empty() ? "this one has none" : fmt::format("{} is not written here", ending);
  throw UsageError(fmt::format("{}: the ending of a name tells the format, and {}", file, found),
                   fmt::format("Use {}", fmt::join(known, ", ")));
}

void write_all(const std::vector<FileContent>& files, Interrupts& interrupts) {
  const auto undisturbed = interrupts.hold();
  write_files(files);
  if (!files.empty()) interrupts.note_written();
}

}  // namespace odontoscope::app
