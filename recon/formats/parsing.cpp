#include "recon/formats/parsing.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>

#include "recon/core/limits.h"

namespace odontoscope::parsing {

static_assert(std::endian::native == std::endian::little, "binary readers copy memory as it is");

Place at_byte(const std::string& file, std::size_t byte) {
  Place place;
  place.file = file;
  place.byte = byte;
  return place;
}

Place at_line(const std::string& file, std::size_t line) {
  Place place;
  place.file = file;
  place.line = line;
  return place;
}

/// Of a file that its reader can say no better of.
static std::string_view usual_remedy(std::string_view cause) {
  if (cause == "truncated") return "Get a whole copy of the file";
  if (cause == "too-large") return "Simplify or cut it first, with the program that made it";
  return "Export it again with the program that made it";
}

void refuse(std::string_view cause, const Place& place, std::string_view wrong, std::string_view remedy) {
  if (remedy.empty()) remedy = usual_remedy(cause);
  throw InputError(cause, place, wrong, remedy);
}

std::string_view coordinate_fault(const Point3& point) {
  std::string_view fault;
  for (const double coordinate : {point.x, point.y, point.z}) {
    if (!std::isfinite(coordinate)) return "not-finite";
    if (std::abs(coordinate) > limits::largest_coordinate) fault = "too-large";
  }
  return fault;
}

std::string tame(std::string_view name) {
  std::string tamed;
  for (const char c : name.substr(0, limits::name_length)) {
    tamed += static_cast<unsigned char>(c) < ' ' || c == 0x7f ? '?' : c;
  }
  return tamed;
}

std::string bytes_behind_told(std::size_t bytes) {
  return fmt::format("{} behind the data that the header announces left aside",
                     bytes == 1 ? "1 byte" : fmt::format("{} bytes", bytes));
}

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

bool same_word(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (lower(a[i]) != lower(b[i])) return false;
  }
  return true;
}

bool parse_number(std::string_view word, double& number) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (end != word.data() + word.size()) return false;
  if (error == std::errc::result_out_of_range) {
    // Too small to tell from zero, or too large to be true.
    const bool tiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
    number = tiny ? 0 : HUGE_VAL;
    return true;
  }
  return error == std::errc();
}

std::size_t line_end(std::string_view text, std::size_t from) {
  return std::min(text.find_first_of("\r\n", from), text.size());
}

std::size_t next_line(std::string_view text, std::size_t end) {
  if (end < text.size() && text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n') return end + 2;
  return std::min(end + 1, text.size());
}

std::string_view Words::next() {
  while (at_ < text_.size() && is_space(text_[at_])) {
    const bool ends_line = text_[at_] == '\n' || text_[at_] == '\r';
    line_ += ends_line;
    at_ = ends_line ? next_line(text_, at_) : at_ + 1;
  }
  const std::size_t first = at_;
  while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
  word_line_ = line_;
  return text_.substr(first, at_ - first);
}

std::string_view Words::rest_of_line() {
  const std::size_t first = at_;
  at_ = line_end(text_, first);
  std::string_view rest = text_.substr(first, at_ - first);
  while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
  return rest;
}

}  // namespace odontoscope::parsing
