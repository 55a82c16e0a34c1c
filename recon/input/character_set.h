#pragma once
// Text of DICOM in its many character sets (PS3.5, 6.1.2, and PS3.3, C.12.1.1.2), as UTF-8.

#include <string>
#include <string_view>

namespace odontoscope {

struct DecodedText {
  std::string utf8;
  /// It is not in the set that the file states: taken as UTF-8 if it is that, or else as Latin-1.
  bool guessed = false;
};

/// `character_set` is the value of (0008,0005), terms separated by backslashes; empty for the default, ASCII. Sets of
/// one byte, UTF-8, GB18030 and GBK; with code extensions (ISO 2022) those of Japanese, Korean and Chinese too. Control
/// characters become question marks.
DecodedText to_utf8(std::string_view text, std::string_view character_set);

}  // namespace odontoscope
