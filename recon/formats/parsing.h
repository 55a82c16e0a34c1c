#pragma once
// What readers of meshes and of other programs' contours have in common. For the .cpp files of these rooms only.

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

#include "recon/core/error.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::parsing {

Place at_byte(const std::string& file, std::size_t byte);
Place at_line(const std::string& file, std::size_t line);

/// Throws the InputError, with the usual remedy for its cause where `remedy` is empty. A test compares the causes that
/// are called by this name with those in docs/formats.md.
[[noreturn]] void refuse(std::string_view cause, const Place& place, std::string_view wrong,
                         std::string_view remedy = {});

/// What is wrong with a coordinate: "not-finite", "too-large" or nothing (empty).
std::string_view coordinate_fault(const Point3& point);

/// Fit for a message or a list: control characters replaced, length bounded.
std::string tame(std::string_view name);

/// Where the line that holds `from` ends: at LF, CR LF, a CR by itself as of old, or with the text.
std::size_t line_end(std::string_view text, std::size_t from);
/// The first byte behind such an end.
std::size_t next_line(std::string_view text, std::size_t end);

/// A remark: what follows the data was left aside.
std::string bytes_behind_told(std::size_t bytes);

bool is_space(char c);
/// The same, letters A to Z aside from their case.
bool same_word(std::string_view a, std::string_view b);

/// Numbers as text have them; "nan" and "inf" are understood (and refused later). False if `word` is not wholly a
/// number.
bool parse_number(std::string_view word, double& number);

/// `bytes` must hold sizeof(Number) from `at` on.
template <typename Number>
Number little_endian(std::string_view bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof(Number));
  return number;
}

/// Words of a text, with their line.
class Words {
 public:
  Words(std::string_view text, std::size_t first_line) : text_(text), line_(first_line) {}

  /// The next word; empty at the end.
  std::string_view next();
  /// Line of the word that next() gave last.
  std::size_t line() const { return word_line_; }
  /// What is left of that line, without the line end.
  std::string_view rest_of_line();
  std::size_t left() const { return text_.size() - at_; }

 private:
  std::string_view text_;
  std::size_t at_ = 0, line_, word_line_ = 1;
};

}  // namespace odontoscope::parsing
