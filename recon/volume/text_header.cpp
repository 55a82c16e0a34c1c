#include "recon/volume/text_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/lower_case.h"

namespace odontoscope {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

[[noreturn]] void refuse(const std::string& path, std::size_t line, const std::string& wrong) {
  Place place;
  place.file = path;
  place.line = line;
  throw InputError("unreadable-volume", place, wrong, "convert the volume with the program that wrote it");
}

}  // namespace

TextHeader read_text_header(const std::string& path, const TextHeaderRules& rules) {
  TextHeader header;
  std::ifstream in(path, std::ios::binary);
  std::string line;
  std::size_t number = 1;
  for (char c; in.get(c);) {
    if (++header.end > limits::header_bytes || line.size() > limits::header_line) {
      refuse(path, number,
             fmt::format("its header has a line of more than {} or more than {} characters in all", limits::header_line,
                         limits::header_bytes));
    }
    if (c != '\n') {
      line += c;
      continue;
    }
    const std::string_view text = trimmed(line);
    if (text.empty()) break;
    const std::size_t at = text.find_first_of(rules.separators);
    const bool odd = at == std::string_view::npos || text.front() == '#';
    if (odd && rules.odd_lines == OddLines::refused) refuse(path, number, "a line of its header is no field");
    if (!odd) {
      const std::string key = lower_case(std::string(trimmed(text.substr(0, at))));
      header.fields.push_back({key, std::string(trimmed(text.substr(at + 1)))});
      if (!rules.last_key.empty() && key == rules.last_key) break;
    }
    line.clear();
    ++number;
  }
  return header;
}

std::string data_file_beside(const std::string& header, const std::string& name) {
  if (lower_case(name).starts_with("list") || name.find('%') != std::string::npos) {
    Place place;
    place.file = header;
    throw InputError("many-data-files", place, fmt::format("the pixels are spread over several files (\"{}\")", name),
                     "convert the volume to one file");
  }
  const std::filesystem::path path(name);
  return path.is_absolute() ? name : (std::filesystem::path(header).parent_path() / path).string();
}

}  // namespace odontoscope
