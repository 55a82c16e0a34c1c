#include "recon/input/structure_names.h"

#include <fmt/format.h>

#include <cstdint>

#include "recon/core/limits.h"

namespace odontoscope {
namespace {

constexpr std::string_view remedy = "Give the structure a short plain name such as \"dentine\"";

bool is_control(char32_t c) { return c < 0x20 || (c >= 0x7f && c <= 0x9f); }

/// Length of the UTF-8 sequence that starts with this byte; 0 if none does.
std::size_t sequence_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first <= 0xdf) return 2;
  if (first >= 0xe0 && first <= 0xef) return 3;
  if (first >= 0xf0 && first <= 0xf4) return 4;
  return 0;
}

/// Takes one character off the front of `text`; false if it is no well-formed UTF-8.
bool take_character(std::string_view& text, char32_t& character) {
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = sequence_length(byte(0));
  if (length == 0 || length > text.size()) return false;
  character = length == 1 ? byte(0) : byte(0) & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0u) != 0x80u) return false;
    character = (character << 6) | (byte(i) & 0x3fu);
  }
  constexpr char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = character >= 0xd800 && character <= 0xdfff;
  if (character < smallest[length] || surrogate || character > 0x10ffff) return false;
  text.remove_prefix(length);
  return true;
}

}  // namespace

void check_structure_name(std::string_view name, const Place& place) {
  if (name.empty()) throw InputError("bad-name", place, "the structure's name is empty", remedy);
  if (name.size() > limits::name_length) {
    throw InputError("bad-name", place,
                     fmt::format("the structure's name {} is {} bytes long, more than {}", in_quotes(name), name.size(),
                                 limits::name_length),
                     remedy);
  }
  for (std::string_view rest = name; !rest.empty();) {
    char32_t character = 0;
    if (!take_character(rest, character)) {
      throw InputError("bad-name", place, fmt::format("the structure's name {} is not UTF-8", in_quotes(name)), remedy);
    }
    if (is_control(character)) {
      throw InputError("bad-name", place,
                       fmt::format("the structure's name {} contains a control character", in_quotes(name)), remedy);
    }
  }
}

std::string in_quotes(std::string_view name) {
  std::string text = "\"";
  for (std::string_view rest = name; !rest.empty();) {
    if (text.size() > limits::quoted_length) return text + "...\"";
    const std::string_view whole = rest;
    char32_t character = 0;
    if (!take_character(rest, character)) {
      text += '?';
      rest.remove_prefix(1);
    } else if (is_control(character)) {
      text += '?';
    } else {
      text += whole.substr(0, whole.size() - rest.size());
    }
  }
  return text + '"';
}

}  // namespace odontoscope
