#pragma once
// Comparisons and the canal experiment as JSON. docs/formats.md describes every key.

#include <string>

#include "recon/compare/canal.h"
#include "recon/compare/compare.h"

namespace odontoscope {

/// Keys in a fixed order. Only `seconds`, `peak_memory_bytes` and `threads` differ between two runs on the same input.
std::string comparison_json(const Comparison& comparison);
std::string canal_json(const CanalExperiment& experiment);

}  // namespace odontoscope
