#include "engine/app/options.h"

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
        return number && std::isfinite(*number) && *number >= 0 ? std::string() : text + " is no number from 0 up";
      },
      "");
}

CLI::Validator whole_number_from_one_to(int largest) {
  return CLI::Validator(
      [largest](const std::string& text) {
        const auto number = number_in<int>(text);
        return number && *number >= 1 && *number <= largest
                   ? std::string()
                   : text + " is no whole number from 1 to " + std::to_string(largest);
      },
      "");
}

}  // namespace odontoscope::app
