#include "recon/volume/label_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/read_file.h"
#include "recon/volume/text_header.h"

namespace odontoscope {
namespace {

[[noreturn]] void refuse(const std::string& file, std::size_t line) {
  Place place;
  place.file = file;
  place.line = line;
  throw InputError("unparsable", place, "the line is not made of seven numbers and a name in quotation marks",
                   "export the label descriptions from ITK-SNAP again");
}

VolumeLabel label_of(std::string_view line, const std::string& file, std::size_t number) {
  const std::size_t open = line.find('"'), close = line.rfind('"');
  if (open == line.npos || close == open) refuse(file, number);
  const std::vector<std::string> words = words_of(line.substr(0, open));
  constexpr std::size_t numbers = 7;  // index, red, green, blue, opacity, two switches
  double index = 0;
  if (words.size() != numbers || !number_of(words[0], index) || index != std::floor(index) ||
      std::abs(index) > static_cast<double>(limits::largest_label))
    refuse(file, number);
  std::string name(trimmed(line.substr(open + 1, close - open - 1)).substr(0, limits::name_length));
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
  return {static_cast<std::int64_t>(index), name};
}

}  // namespace

std::vector<VolumeLabel> parse_label_names(std::string_view text, const std::string& file) {
  std::vector<VolumeLabel> labels;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.starts_with('#')) continue;
    const VolumeLabel label = label_of(line, file, number);
    if (label.value != 0 && !label.name.empty()) labels.push_back(label);
    if (labels.size() <= limits::structures) continue;
    Place place;
    place.file = file;
    throw InputError("too-many-structures", place, fmt::format("it names more than {} labels", limits::structures),
                     "leave out those that are not there");
  }
  std::stable_sort(labels.begin(), labels.end(),
                   [](const VolumeLabel& a, const VolumeLabel& b) { return a.value < b.value; });
  return labels;
}

std::vector<VolumeLabel> read_label_names(const std::string& file) {
  constexpr std::size_t most_bytes = 1u << 20;
  return parse_label_names(read_file(file, most_bytes), file);
}

}  // namespace odontoscope
