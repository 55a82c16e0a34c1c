#include "recon/core/error.h"

#include <fmt/format.h>

namespace odontoscope {
namespace {

constexpr std::string_view bug_remedy =
    "This is a bug in odontoscope, not in your data; please report it together with the input";

std::string stopped(std::string text) {
  if (!text.empty() && text.back() != '.' && text.back() != '?') text += '.';
  return text;
}

/// With a capital and a full stop.
std::string sentence(std::string_view words) {
  std::string text(words);
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return stopped(std::move(text));
}

std::string message(std::string_view place, std::string_view wrong, std::string_view remedy) {
  const std::string trouble = place.empty() ? std::string(wrong) : fmt::format("{}: {}", place, wrong);
  return remedy.empty() ? stopped(trouble) : fmt::format("{}. {}", trouble, sentence(remedy));
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
  if (slice && z)
    add(after_file, fmt::format("slice {} (z = {})", *slice, *z));
  else if (slice)
    add(after_file, fmt::format("slice {}", *slice));
  else if (z)
    add(after_file, fmt::format("z = {}", *z));
  if (contour) add(", ", fmt::format("contour {}", *contour));
  if (point) add(", ", fmt::format("point {}", *point));
  if (at) add(" ", fmt::format("at ({}, {})", at->x, at->y));
  return words;
}

Error::Error(ExitCode code, const std::string& message, std::string_view wrong, std::string_view remedy)
    : std::runtime_error(message), exit_code_(code), wrong_(wrong), remedy_(sentence(remedy)) {}

InputError::InputError(std::string_view cause, Place place, std::string_view wrong, std::string_view remedy)
    : Error(ExitCode::bad_input, fmt::format("{} [{}]", message(place.in_words(), wrong, remedy), cause), wrong,
            remedy),
      cause_(cause),
      place_(std::move(place)) {}

FileError::FileError(std::string_view file, std::string_view wrong, std::string_view remedy)
    : Error(ExitCode::file, message(file, wrong, remedy), wrong, remedy), file_(file) {}

UsageError::UsageError(std::string_view wrong, std::string_view remedy)
    : Error(ExitCode::usage, message({}, wrong, remedy), wrong, remedy) {}

InternalError::InternalError(std::string_view what)
    : Error(ExitCode::internal, message({}, fmt::format("internal error: {}", what), bug_remedy),
            fmt::format("internal error: {}", what), bug_remedy) {}

}  // namespace odontoscope
