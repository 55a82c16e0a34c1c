#pragma once
// Headers of "key separator value" lines, as NRRD and MetaImage have them. Inner part of volume_header.h.

#include <cstddef>
#include <string>
#include <vector>

namespace odontoscope {

struct HeaderField {
  std::string key;  // in lower case
  std::string value;
};

struct TextHeader {
  std::vector<HeaderField> fields;
  /// Where the header ends: behind the empty line or behind `last_key`'s line.
  std::size_t end = 0;
};

enum class OddLines { passed_over, refused };

struct TextHeaderRules {
  /// Any of these characters ends a key.
  std::string separators;
  /// The header ends with this key's line; if empty, with an empty line or the file.
  std::string last_key;
  /// Lines without separator or that begin with #.
  OddLines odd_lines = OddLines::passed_over;
};

/// Throws InputError unreadable-volume for refused lines and if the header or a line of it is longer than
/// limits::header_bytes or limits::header_line.
TextHeader read_text_header(const std::string& path, const TextHeaderRules& rules);

/// Path of a data file that the header at `header` names; many-data-files if the name is a list or a pattern.
std::string data_file_beside(const std::string& header, const std::string& name);

}  // namespace odontoscope
