#pragma once
// The most memory that a piece of work took.

#include <cstddef>
#include <functional>
#include <optional>

namespace odontoscope {

/// Runs `work`; most bytes resident meanwhile, less those before. Heap that earlier work has freed is given back to the
/// system first. Nothing where the system does not tell (Linux does).
std::optional<std::size_t> peak_memory_of(const std::function<void()>& work);

}  // namespace odontoscope
