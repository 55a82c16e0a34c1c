#pragma once
// What a structure may be called. The rule is one and the same for files and for stacks made in memory.

#include <string_view>

#include "recon/core/error.h"

namespace odontoscope {

/// Throws InputError bad-name unless `name` is 1 to limits::name_length bytes of UTF-8 without control characters.
void check_structure_name(std::string_view name, const Place& place);

/// `name` in quotes, shortened and with control characters replaced, fit for a message.
std::string in_quotes(std::string_view name);

}  // namespace odontoscope
