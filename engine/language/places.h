#pragma once
// The places in a text that are filled in: "Step {step} of {steps}".

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace odontoscope {

struct TextPlace {
  std::size_t begin = 0, end = 0;  // with its braces
  std::string name;
};

/// Only words of letters, digits and _ within braces are places.
std::vector<TextPlace> places_in(std::string_view text);

/// Has it places, and besides them enough to be told from other texts by?
bool has_words_to_find(std::string_view text);

}  // namespace odontoscope
