#pragma once
// The contour stack format of docs/formats.md.

#include <stop_token>
#include <string>
#include <string_view>

#include "recon/input/contour_stack.h"

namespace odontoscope {

/// The stack in `file`, in millimetres whatever unit the file has, as it stands there: checked for form and limits, not
/// yet by `validate`. Memory: the stack and a small buffer. Throws FileError, or InputError: unparsable, wrong-format,
/// wrong-version, wrong-unit, wrong-type, missing-key, repeated-key, unknown-key, not-finite, too-large, too-deep,
/// file-too-large, bad-name, too-many-slices / -contours / -points.
ContourStack read_stack(const std::string& file, std::stop_token stop = {});

/// The same from memory; `name` stands for the file in messages and becomes `source`.
ContourStack parse_stack(std::string_view bytes, std::string name);

/// The text of a file that `read_stack` reads back to an equal stack. Unit mm; a contour a line; shortest numbers that
/// give the same double again, so equal stacks have equal texts. Precondition: `validate` passed.
std::string to_json(const ContourStack& stack);

/// Writes `to_json(stack)`, whole or not at all. Throws FileError.
void write_stack(const ContourStack& stack, const std::string& file);

}  // namespace odontoscope
