#include "recon/formats/text_values.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "recon/core/lower_case.h"

namespace odontoscope {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

void append_number(std::string& text, double value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value + 0.0).ptr;
  text.append(digits.data(), end);
}

void append_number(std::string& text, double value, std::size_t most) {
  std::string number;
  append_number(number, value);
  for (int digits = 16; number.size() > most; --digits) number = fmt::format("{:.{}e}", value + 0.0, digits);
  text += number;
}

void append_point(std::string& text, const Point3& p) {
  const char* separator = "";
  for (const double coordinate : {p.x, p.y, p.z}) {
    text += separator;
    append_number(text, coordinate);
    separator = " ";
  }
}

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string Identifiers::unique(std::string_view name) {
  constexpr std::size_t longest = 64;  // solvers allow 80
  std::string plain;
  for (const char c : name.substr(0, longest)) plain += is_letter(c) || is_digit(c) ? c : '_';
  if (plain.empty() || !is_letter(plain.front())) plain.insert(plain.begin(), 'S');
  std::string chosen = plain;
  for (int n = 2; !taken_.insert(lower_case(chosen)).second; ++n) chosen = fmt::format("{}_{}", plain, n);
  return chosen;
}

}  // namespace odontoscope
