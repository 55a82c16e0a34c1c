#include "recon/volume/text_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/lower_case.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& path, std::size_t line, const std::string& wrong) {
  Place place;
  place.file = path;
  place.line = line;
  throw InputError("unreadable-volume", place, wrong, "convert the volume with the program that wrote it");
}

[[noreturn]] void refuse_names(const std::string& path, const std::string& wrong) {
  throw InputError("unreadable-volume", in_file(path), wrong, "correct the header, or convert the volume to one file");
}

/// Lines of a header with their number, each of bounded length.
class Lines {
 public:
  Lines(ByteSource& source, const std::string& path) : source_(source), path_(path) {}

  /// False at the end of the file.
  bool next(std::string& line) {
    line.clear();
    ++number_;
    for (char c; source_.next(c);) {
      if (++end_ > limits::header_bytes || line.size() > limits::header_line) {
        refuse(path_, number_,
               fmt::format("its header has a line of more than {} or more than {} characters in all",
                           limits::header_line, limits::header_bytes));
      }
      if (c == '\n') return true;
      line += c;
    }
    return !line.empty();
  }
  std::size_t end() const { return end_; }
  std::size_t number() const { return number_; }

 private:
  ByteSource& source_;
  std::string path_;
  std::size_t end_ = 0, number_ = 0;
};

bool begins_list(const std::string& key, const std::string& value) {
  const bool names_data = key == "data file" || key == "datafile" || key == "elementdatafile";
  return names_data && lower_case(value).substr(0, value.find_first_of(" \t[")) == "list";
}

/// A pattern's only "%d", "%3d" or "%03d".
struct Pattern {
  std::string before, after;
  std::size_t width = 0;
  bool zeros = false;
  std::string name(long number) const {
    return before + (zeros ? fmt::format("{:0{}}", number, width) : fmt::format("{:{}}", number, width)) + after;
  }
};

std::optional<Pattern> pattern_of(std::string_view text) {
  Pattern pattern;
  const std::size_t at = text.find('%');
  if (at == text.npos || text.find('%', at + 1) != text.npos) return std::nullopt;
  const std::size_t letter = text.find_first_not_of("0123456789", at + 1);
  if (letter == text.npos || text[letter] != 'd' || letter - at > 4) return std::nullopt;
  const std::string_view digits = text.substr(at + 1, letter - at - 1);
  pattern.before = text.substr(0, at);
  pattern.after = text.substr(letter + 1);
  pattern.zeros = digits.starts_with('0');
  for (const char c : digits) pattern.width = 10 * pattern.width + static_cast<std::size_t>(c - '0');
  return pattern;
}

std::vector<std::string> names_by_pattern(const std::string& header, const std::vector<std::string>& words) {
  const std::optional<Pattern> pattern = pattern_of(words[0]);
  double first = 0, last = 0, step = 1;
  const bool numbers = words.size() >= 3 && words.size() <= 5 && number_of(words[1], first) &&
                       number_of(words[2], last) && (words.size() < 4 || number_of(words[3], step));
  constexpr double most = 1e6;
  const auto whole = [](double x) { return std::abs(x) <= most && x == std::floor(x); };
  if (!pattern || !numbers || !whole(first) || !whole(last) || !whole(step) || step == 0 || (last - first) / step < 0) {
    refuse_names(header, fmt::format("\"{}\" is no pattern of file names like slice%03d.raw 1 100 1",
                                     words[0].substr(0, limits::quoted_length)));
  }
  const double count = std::floor((last - first) / step) + 1;
  if (count > static_cast<double>(limits::slices))
    refuse_names(header, fmt::format("it names {:.0f} files; the limit is {}", count, limits::slices));
  std::vector<std::string> names;
  for (long n = 0; n < static_cast<long>(count); ++n)
    names.push_back(pattern->name(static_cast<long>(first) + n * static_cast<long>(step)));
  return names;
}

bool lies_below(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

}  // namespace

/// A link in the header's folder that leads out of it lies outside.
bool lies_inside(const std::string& header, const std::string& file) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(file, error);
  const fs::path beside = fs::weakly_canonical(fs::absolute(header).parent_path(), error);
  const fs::path beside_real = fs::weakly_canonical(header, error).parent_path();
  return lies_below(real, beside) || lies_below(real, beside_real);
}

void check_inside(const std::string& header, const std::string& file) {
  if (lies_inside(header, file)) return;
  throw InputError("outside-folder", in_file(header),
                   fmt::format("its pixels are to come from {}, which lies outside the header's own folder", file),
                   "put the pixels beside the header, or give --allow-outside if you trust it");
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return words;
}

bool number_of(std::string_view word, double& number) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return !word.empty() && error == std::errc{} && end == word.data() + word.size();
}

const std::string* TextHeader::find(std::string_view key) const {
  for (const HeaderField& field : fields)
    if (field.key == key) return &field.value;
  return nullptr;
}

TextHeader read_text_header(ByteSource& source, const std::string& path, const TextHeaderRules& rules) {
  TextHeader header;
  Lines lines(source, path);
  for (std::string line; lines.next(line);) {
    const std::string_view text = trimmed(line);
    if (text.empty()) break;
    const std::size_t at = text.find_first_of(rules.separators);
    const bool odd = at == std::string_view::npos || text.front() == '#';
    if (odd && rules.odd_lines == OddLines::refused) refuse(path, lines.number(), "a line of its header is no field");
    if (odd) continue;
    const std::string key = lower_case(std::string(trimmed(text.substr(0, at))));
    const std::string_view rest = text.substr(at + 1);
    if (text[at] == ':' && rest.starts_with('=')) {
      header.pairs.push_back({key, std::string(trimmed(rest.substr(1)))});
      continue;
    }
    header.fields.push_back({key, std::string(trimmed(rest))});
    if (begins_list(key, header.fields.back().value)) {
      while (lines.next(line) && !trimmed(line).empty()) header.list.emplace_back(trimmed(line));
      break;
    }
    if (!rules.last_key.empty() && key == rules.last_key) break;
  }
  header.end = lines.end();
  return header;
}

std::vector<std::string> data_files_of(const std::string& header, const std::string& field,
                                       const std::vector<std::string>& list, bool allow_outside) {
  std::vector<std::string> names{field};
  const std::vector<std::string> words = words_of(field);
  if (words.empty()) refuse_names(header, "it names no file with its pixels");
  if (begins_list("data file", field)) {
    names = list;
    if (names.empty()) refuse_names(header, "its list of files with pixels is empty");
    if (names.size() > limits::slices)
      refuse_names(header, fmt::format("it names {} files; the limit is {}", names.size(), limits::slices));
  } else if (words.size() > 1 && words[0].find('%') != std::string::npos) {
    names = names_by_pattern(header, words);
  }
  for (std::string& name : names) {
    const fs::path path(name);
    if (!path.is_absolute()) name = (fs::path(header).parent_path() / path).string();
    if (!allow_outside) check_inside(header, name);
  }
  return names;
}

}  // namespace odontoscope
