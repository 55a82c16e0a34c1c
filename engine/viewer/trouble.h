#pragma once
// What went wrong, in words for a person.

#include <string>

namespace odontoscope {

class Interface;

/// Called in a catch block.
std::string words_for_current_exception();

/// Draws them: where the interface's language has words for the cause, the rule that was broken and what to do, and
/// below them the precise English ones.
void draw_trouble(const Interface& interface, const std::string& words);

}  // namespace odontoscope
