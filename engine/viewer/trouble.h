#pragma once
// What went wrong, in words for a person.

#include <string>

namespace odontoscope {

/// Called in a catch block.
std::string words_for_current_exception();

}  // namespace odontoscope
