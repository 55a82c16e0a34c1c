#include "recon/core/error.h"

#include <fmt/format.h>

namespace odontoscope {
namespace {

std::string sentence(std::string_view place, std::string_view wrong, std::string_view remedy) {
  std::string text;
  if (!place.empty()) text += fmt::format("{}: ", place);
  text += wrong;
  if (!remedy.empty()) {   // a sentence of its own: what parts the two is that it begins with a capital
    const bool small = remedy.front() >= 'a' && remedy.front() <= 'z';
    text += fmt::format(". {}{}", static_cast<char>(small ? remedy.front() - 'a' + 'A' : remedy.front()), remedy.substr(1));
  }
  if (!text.empty() && text.back() != '.' && text.back() != '?') text += '.';
  return text;
}

}  // namespace

std::string Place::in_words() const {
  std::string words;
  const auto add = [&words](std::string_view separator, const std::string& text) {
    if (!words.empty()) words += separator;
    words += text;
  };
  if (!file.empty()) add("", file);
  if (line) add(":", fmt::format("{}", *line));
  if (byte) add(", ", fmt::format("byte {}", *byte));
  const std::string_view after_file = slice || z ? ": " : ", ";
  if (slice && z) add(after_file, fmt::format("slice {} (z = {})", *slice, *z));
  else if (slice) add(after_file, fmt::format("slice {}", *slice));
  else if (z) add(after_file, fmt::format("z = {}", *z));
  if (contour) add(", ", fmt::format("contour {}", *contour));
  if (point) add(", ", fmt::format("point {}", *point));
  if (at) add(" ", fmt::format("at ({}, {})", at->x, at->y));
  return words;
}

InputError::InputError(std::string_view cause, Place place, std::string_view wrong, std::string_view remedy)
    : Error(ExitCode::bad_input, fmt::format("{} [{}]", sentence(place.in_words(), wrong, remedy), cause)),
      cause_(cause),
      place_(std::move(place)) {}

FileError::FileError(std::string_view file, std::string_view wrong, std::string_view remedy)
    : Error(ExitCode::file, sentence(file, wrong, remedy)) {}

UsageError::UsageError(std::string_view wrong, std::string_view remedy)
    : Error(ExitCode::usage, sentence({}, wrong, remedy)) {}

InternalError::InternalError(std::string_view what)
    : Error(ExitCode::internal,
            sentence({}, fmt::format("internal error: {}", what),
                     "This is a bug in odontoscope, not in your data; please report it together with the input")) {}

}  // namespace odontoscope
