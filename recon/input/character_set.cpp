#include "recon/input/character_set.h"

#include <iconv.h>

#include <optional>
#include <utility>

namespace odontoscope {
namespace {

constexpr char escape = '\x1b';

/// Nothing if `text` is not in the encoding, or the system does not know that.
std::optional<std::string> converted(std::string_view text, const char* encoding) {
  const iconv_t converter = ::iconv_open("UTF-8", encoding);
  if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
  std::string from(text), to(4 * text.size() + 16, '\0');
  char *in = from.data(), *out = to.data();
  std::size_t in_left = from.size(), out_left = to.size();
  const bool failed =
      ::iconv(converter, &in, &in_left, &out, &out_left) == static_cast<std::size_t>(-1) || in_left != 0;
  ::iconv_close(converter);
  if (failed) return std::nullopt;
  to.resize(to.size() - out_left);
  return to;
}

/// What the terms of PS3.3, table C.12-2 to C.12-5 are called by iconv, and the escape sequence (PS3.3, C.12-3 and
/// C.12-4) that switches to them.
struct CharacterSet {
  std::string_view term, sequence;
  const char* encoding;
  /// The converter wants the sequence itself before the text.
  bool keeps_sequence = false;
};
constexpr CharacterSet character_sets[] = {{"ISO_IR 192", "", "UTF-8"},
                                           {"GB18030", "", "GB18030"},
                                           {"GBK", "", "GBK"},
                                           {"ISO_IR 100", "-A", "ISO-8859-1"},
                                           {"ISO_IR 101", "-B", "ISO-8859-2"},
                                           {"ISO_IR 109", "-C", "ISO-8859-3"},
                                           {"ISO_IR 110", "-D", "ISO-8859-4"},
                                           {"ISO_IR 144", "-L", "ISO-8859-5"},
                                           {"ISO_IR 127", "-G", "ISO-8859-6"},
                                           {"ISO_IR 126", "-F", "ISO-8859-7"},
                                           {"ISO_IR 138", "-H", "ISO-8859-8"},
                                           {"ISO_IR 148", "-M", "ISO-8859-9"},
                                           {"ISO_IR 203", "-b", "ISO-8859-15"},
                                           {"ISO_IR 166", "-T", "TIS-620"},
                                           {"ISO_IR 13", ")I", "SHIFT_JIS"},
                                           {"ISO_IR 87", "$B", "ISO-2022-JP-2", true},
                                           {"ISO_IR 159", "$(D", "ISO-2022-JP-2", true},
                                           {"ISO_IR 149", "$)C", "EUC-KR"},
                                           {"ISO_IR 58", "$)A", "GB2312"},
                                           {"ISO_IR 14", "(J", "SHIFT_JIS"},
                                           {"ISO_IR 6", "(B", "ASCII"}};

std::string_view first_term(std::string_view terms) {
  std::string_view term = terms.substr(0, terms.find('\\'));
  while (!term.empty() && term.back() == ' ') term.remove_suffix(1);
  while (!term.empty() && term.front() == ' ') term.remove_prefix(1);
  return term;
}

/// "ISO 2022 IR 100" is "ISO_IR 100" that may be switched away from. Without a term it is ASCII; nothing if the term is
/// unknown.
const CharacterSet* set_of_term(std::string_view term) {
  if (term.empty()) term = "ISO_IR 6";
  const bool extended = term.starts_with("ISO 2022 IR ");
  const std::string name = extended ? "ISO_IR " + std::string(term.substr(12)) : std::string(term);
  for (const CharacterSet& set : character_sets) {
    if (set.term == name) return &set;
  }
  return nullptr;
}

/// By the sequence that `text` begins with, behind the escape.
const CharacterSet* set_of_sequence(std::string_view text) {
  for (const CharacterSet& set : character_sets) {
    if (!set.sequence.empty() && text.starts_with(set.sequence)) return &set;
  }
  return nullptr;
}

std::optional<std::string> as_stated(std::string_view text, std::string_view character_set) {
  const CharacterSet* set = set_of_term(first_term(character_set));
  std::string result;
  while (true) {
    const std::size_t end = std::min(text.find(escape), text.size());
    const std::string_view piece = text.substr(0, end);
    if (!piece.empty()) {
      if (!set) return std::nullopt;
      const std::string prefix = set->keeps_sequence ? escape + std::string(set->sequence) : "";
      const auto utf8 = converted(prefix + std::string(piece), set->encoding);
      if (!utf8) return std::nullopt;
      result += *utf8;
    }
    if (end == text.size()) return result;
    text.remove_prefix(end + 1);
    set = set_of_sequence(text);
    if (!set) return std::nullopt;
    text.remove_prefix(set->sequence.size());
  }
}

/// Those of Latin-1 (C2 80 to C2 9F in UTF-8) as well.
std::string without_control_characters(std::string_view utf8) {
  std::string tame;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto byte = static_cast<unsigned char>(utf8[i]);
    const bool of_latin = byte == 0xc2 && i + 1 < utf8.size() && static_cast<unsigned char>(utf8[i + 1]) < 0xa0;
    const bool control = byte < 0x20 || byte == 0x7f || of_latin;
    tame += control ? '?' : utf8[i];
    i += of_latin;
  }
  return tame;
}

}  // namespace

DecodedText to_utf8(std::string_view text, std::string_view character_set) {
  if (const auto stated = as_stated(text, character_set)) return {without_control_characters(*stated), false};
  if (const auto utf8 = converted(text, "UTF-8")) return {without_control_characters(*utf8), true};
  return {without_control_characters(converted(text, "ISO-8859-1").value_or("?")), true};
}

}  // namespace odontoscope
