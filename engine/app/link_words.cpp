#include "engine/app/link_words.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string_view>

#include "recon/core/error.h"

namespace odontoscope::app {
namespace {

std::optional<std::size_t> whole_number(std::string_view digits) {
  std::size_t number = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (digits.empty() || fault != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return number;
}

std::optional<Link> understood_link(std::string_view word) {
  const std::size_t last = word.rfind(':'), dash = word.rfind('-');
  if (last == word.npos || last == 0 || dash == word.npos || dash < last) return std::nullopt;
  const std::size_t first = word.rfind(':', last - 1);
  if (first == word.npos || first == 0) return std::nullopt;
  const auto slice = whole_number(word.substr(first + 1, last - first - 1)),
             lower = whole_number(word.substr(last + 1, dash - last - 1)), upper = whole_number(word.substr(dash + 1));
  if (!slice || !lower || !upper) return std::nullopt;
  return Link{std::string(word.substr(0, first)), *slice, *lower, *upper};
}

}  // namespace

Link link_from(const std::string& word, LinkOption option) {
  const bool connect = option == LinkOption::link;
  std::optional<Link> link = understood_link(word);
  if (!link)
    throw UsageError(fmt::format("--{} {}: that is no structure, lower slice, and contour below and above",
                                 connect ? "link" : "unlink", word),
                     "For example --link pulp:12:0-1; the report lists every link with these numbers");
  link->connect = connect;
  return *link;
}

std::vector<Link> links_from(const LinkWords& words) {
  std::vector<Link> links;
  for (const std::string& word : words.connect) links.push_back(link_from(word, LinkOption::link));
  for (const std::string& word : words.apart) links.push_back(link_from(word, LinkOption::unlink));
  return links;
}

}  // namespace odontoscope::app
