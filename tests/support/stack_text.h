#pragma once
// Contour stacks as the JSON text of docs/formats.md, so that a stack printed by a failed test can be fed to the
// program, and one from the corpus to a test. Written apart from the library's reader on purpose; it trusts its input.

#include <string>
#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/input/links.h"

namespace odontoscope::test {

std::string to_text(const ContourStack& stack);
std::string to_text(const std::vector<Link>& links);
ContourStack from_text(const std::string& text);
ContourStack read_stack_file(const std::string& path);

}  // namespace odontoscope::test
