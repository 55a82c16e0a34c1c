#pragma once
// What became of each input of a batch: a record beside what was made of it, by which the next call knows what is done,
// and the one report on all.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/child_run.h"

namespace odontoscope::app {

struct BatchRecord {
  std::string name, input;
  std::vector<std::string> words;    // all that `reconstruct` was given but input, outputs and threads
  std::vector<std::string> outputs;  // files
  /// Of the input, as it was read: what tells whether it is still the same. Of a folder: of all files in it.
  std::uint64_t bytes = 0;
  std::int64_t modified = 0;  // nanoseconds since 1970
  std::string program;        // version
  // What came of it.
  int exit_code = -1;                  // -1: did not end by itself
  std::string ending, cause, message;  // "0", "signal 9", "hang"; the last line of the message if it failed
  double seconds = 0, megabytes = 0;
  // From the model's own report, if there is one.
  std::string verdict;
  std::optional<bool> certified;
  std::size_t triangles = 0, tetrahedra = 0;
  bool made = false;  // all outputs were written, whatever the verdict
  bool kept = false;  // by this call: it was there already
};

/// Size and time of `input`; zeros if it is not there.
void stamp(BatchRecord& record);

/// Fills in what the model's report says; leaves it empty if the file is none.
void take_report(BatchRecord& record, const std::string& report);

/// The text of a record's file, and back. Nothing for a file that is missing or no such record: then it is made anew.
std::string record_text(const BatchRecord& record);
std::optional<BatchRecord> read_record(const std::string& file);

/// Is what `found` tells of done, for the same input as `wanted` is now, with the same words by the same program, and
/// are all outputs there?
bool is_done(const BatchRecord& found, const BatchRecord& wanted);

/// The one report: counts, then every input, in order. docs/batch.md describes the keys.
std::string batch_report_text(const std::vector<BatchRecord>& records, const std::string& part);

}  // namespace odontoscope::app
