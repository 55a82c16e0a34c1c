#include "engine/app/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace odontoscope::app {
namespace {

template <typename Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

CLI::Option* repeatable(CLI::Option* option) { return option->allow_extra_args(false); }

CLI::Validator at_least_zero() {
  return CLI::Validator(
      [](const std::string& text) {
        const auto number = number_in<double>(text);
        return number && std::isfinite(*number) && *number >= 0 ? std::string()
                                                                : fmt::format("{} is no number from 0 up", text);
      },
      "");
}

CLI::Validator whole_number_from_one_to(int largest) {
  return CLI::Validator(
      [largest](const std::string& text) {
        const auto number = number_in<int>(text);
        return number && *number >= 1 && *number <= largest
                   ? std::string()
                   : fmt::format("{} is no whole number from 1 to {}", text, largest);
      },
      "");
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  return CLI::Validator(
      [words](const std::string& text) {
        if (std::find(words.begin(), words.end(), lower_case(text)) != words.end()) return std::string();
        return fmt::format("{} is none of {}", text, fmt::join(words, ", "));
      },
      "");
}

}  // namespace odontoscope::app
