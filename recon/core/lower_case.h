#pragma once
// Words compared without regard to capitals.

#include <string>

namespace odontoscope {

/// A to Z become small; every other byte stays as it is, whatever the locale.
inline std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

}  // namespace odontoscope
