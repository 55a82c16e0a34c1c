#pragma once
// What a batch is about: many inputs, each with a name of its own for what is made of it, and with words for
// `reconstruct`.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace odontoscope::app {

struct BatchItem {
  std::string input;               // as `reconstruct` is given it
  std::vector<std::string> words;  // of this input alone, from its line in a list
  std::string name;                // of its files, without ending: distinct
};

/// A line in words, as a shell would: parted by blanks, '...' and "..." hold blanks, a backslash takes the next
/// character as it is (but in '...'). UsageError, naming `what`, for a quote that does not end, and for a byte 0.
std::vector<std::string> words_in_line(std::string_view line, const std::string& what);

/// What `sources` name, in order: a file, or folder of DICOM, stands for itself; a pattern (* ? [) that is no file, for
/// all that match, sorted; a text file that ends in .txt or .list, for what its lines name, each with words for
/// `reconstruct` behind it (a line that begins with # is none). Names are what files are called without ending; where
/// two are called alike, with the folders that tell them apart. UsageError: a pattern that nothing matches, nothing at
/// all, the same input twice. FileError, InputError (file-too-large, too-many-inputs): a list.
std::vector<BatchItem> batch_items(const std::vector<std::string>& sources);

}  // namespace odontoscope::app
