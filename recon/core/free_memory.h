#pragma once
// Memory that is asked for before it is taken: what a small file would become may be more than a machine has, and a
// system that gives more than it has ends the program later.

#include <string>
#include <string_view>

namespace odontoscope {

/// Throws FileError, naming `file`, if this machine (by the system's own estimate, and a limit on the address space)
/// has not so many bytes left. A system that does not tell has enough.
void check_memory(const std::string& file, double bytes, std::string_view remedy);

}  // namespace odontoscope
