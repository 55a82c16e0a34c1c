#include "recon/exchange/dicom_set.h"

#include <fmt/format.h>

#include <utility>

#include "recon/formats/parsing.h"

namespace odontoscope {
namespace {

using namespace parsing;

constexpr std::size_t preamble_length = 128, mark_length = 4;
constexpr std::uint64_t delimiter = 8;
constexpr DicomManner of_structure_sets{.truncated = "truncated",
                                        .unreadable = "unreadable-structure-set",
                                        .get_whole = "Get a whole copy of the file",
                                        .export_again = "Export it again",
                                        .exact = false};

std::string_view trimmed(std::string_view text) {
  const auto is_padding = [](char c) { return c == '\0' || is_space(c); };
  while (!text.empty() && is_padding(text.back())) text.remove_suffix(1);
  while (!text.empty() && is_padding(text.front())) text.remove_prefix(1);
  return text;
}

bool has_representation(std::string_view bytes, std::size_t at) {
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  return bytes.size() >= at + 6 && is_capital(bytes[at + 4]) && is_capital(bytes[at + 5]);
}

}  // namespace

bool begins_as_data_set(std::string_view bytes) {
  constexpr std::size_t header = 8;
  if (bytes.size() < header || (bytes[0] != 2 && bytes[0] != 8) || bytes[1] != 0 || bytes[3] != 0) return false;
  return has_representation(bytes, 0) || little_endian<std::uint32_t>(bytes, 4) <= bytes.size();
}

DicomSet::DicomSet(std::string_view bytes, std::string file)
    : bytes_(bytes), file_(std::move(file)), source_(bytes), walk_(source_, file_, of_structure_sets) {
  const bool marked =
      bytes_.size() >= preamble_length + mark_length && bytes_.substr(preamble_length, mark_length) == "DICM";
  const bool without_preamble = !marked && bytes_.starts_with("DICM");
  if (!marked && !without_preamble && !begins_as_data_set(bytes_)) walk_.refuse("the file has no mark of DICOM");
  read_meta_information(marked ? preamble_length + mark_length : without_preamble ? mark_length : 0);
}

/// Group 2 says how the rest is coded.
void DicomSet::read_meta_information(std::uint64_t at) {
  const bool bare = at == 0;
  std::string_view syntax;
  walk_.go_to(at);
  walk_.meta_information([&](const DicomHead& head) {
    const std::uint64_t first = walk_.at();
    walk_.pass(head, false, bytes_.size(), 0);
    if (head.tag == dicom::transfer_syntax && !head.is_undefined())
      syntax = trimmed(bytes_.substr(static_cast<std::size_t>(first), head.length));
  });
  at = walk_.at();
  constexpr std::string_view implicit_little = "1.2.840.10008.1.2", explicit_little = "1.2.840.10008.1.2.1";
  // Without it the coding shows in the first element: representations are two capital letters.
  if (syntax.empty() && bare)
    syntax = has_representation(bytes_, static_cast<std::size_t>(at)) ? explicit_little : implicit_little;
  if (syntax != implicit_little && syntax != explicit_little) {
    walk_.refuse(syntax.empty() ? "it names no transfer syntax"
                                : fmt::format("transfer syntax {} is not supported", tame(syntax)));
  }
  top_ = {at, bytes_.size(), syntax == implicit_little};
  while (walk_.at() < top_.end) walk_.pass(walk_.next(top_.implicit_vr, top_.end), top_.implicit_vr, top_.end, 0);
}

std::string_view DicomSet::text(const DataSet& data, std::uint32_t tag) const {
  const auto found = find(data, tag);
  return found && !found->is_undefined() ? trimmed(bytes_.substr(static_cast<std::size_t>(walk_.at()), found->length))
                                         : std::string_view();
}

std::vector<DicomSet::DataSet> DicomSet::items(const DataSet& data, std::uint32_t tag) const {
  std::vector<DataSet> items;
  const auto sequence = find(data, tag);
  if (!sequence) return items;
  walk_.items(*sequence, data.implicit_vr, data.end, 1,
              [&](const DicomHead& item, bool implicit_vr, std::uint64_t end) {
                const std::uint64_t first = walk_.at();
                walk_.pass_item(item, implicit_vr, end, 1);
                items.push_back({first, item.is_undefined() ? walk_.at() - delimiter : walk_.at(), implicit_vr});
              });
  return items;
}

std::optional<DicomHead> DicomSet::find(const DataSet& data, std::uint32_t tag) const {
  walk_.go_to(data.first);
  while (walk_.at() < data.end) {
    const DicomHead head = walk_.next(data.implicit_vr, data.end);
    if (head.tag == tag) {
      if (!head.is_undefined()) walk_.require(head.length, data.end);
      return head;
    }
    walk_.pass(head, data.implicit_vr, data.end, 0);
  }
  return std::nullopt;
}

}  // namespace odontoscope
