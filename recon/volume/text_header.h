#pragma once
// Headers of "key separator value" lines, as NRRD and MetaImage have them. Inner part of volume_header.h.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "recon/volume/byte_source.h"

namespace odontoscope {

struct HeaderField {
  std::string key;  // in lower case
  std::string value;
};

struct TextHeader {
  std::vector<HeaderField> fields;
  /// NRRD's "key:=value" lines, which mean something to programs only.
  std::vector<HeaderField> pairs;
  /// Lines that follow a data file called LIST, up to the header's end.
  std::vector<std::string> list;
  /// Where the header ends: behind the empty line or behind `last_key`'s line. Counted in the unpacked file.
  std::size_t end = 0;

  /// Of the first field of that key; null if there is none.
  const std::string* find(std::string_view key) const;
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
/// limits::header_bytes or limits::header_line. `source` stands at the file's first byte.
TextHeader read_text_header(ByteSource& source, const std::string& path, const TextHeaderRules& rules);

/// Without blanks and line ends around it.
std::string_view trimmed(std::string_view text);

/// Words between blanks.
std::vector<std::string> words_of(std::string_view text);

/// The whole of `word` as a number; NRRD's "nan" and "inf" too. False if it is none.
bool number_of(std::string_view word, double& number);

/// Files with the pixels that `field` of a header names: one; with "LIST" those of `list`; with "name%03d.raw FIRST
/// LAST STEP" those of that pattern. Throws InputError unreadable-volume for a pattern or list that makes no sense,
/// outside-folder for a file that lies neither in the header's folder nor below it, unless `allow_outside`: a header
/// that somebody sent could name any file of the machine.
std::vector<std::string> data_files_of(const std::string& header, const std::string& field,
                                       const std::vector<std::string>& list, bool allow_outside);

/// Does `file`, with links followed, lie in the header's folder or below it?
bool lies_inside(const std::string& header, const std::string& file);

/// Throws InputError outside-folder if `file`, with links followed, lies neither in the header's folder nor below it.
void check_inside(const std::string& header, const std::string& file);

}  // namespace odontoscope
