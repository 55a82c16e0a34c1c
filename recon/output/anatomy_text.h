#pragma once
// A tooth's measures as JSON and as a table. docs/formats.md describes keys and columns.

#include <string>

#include "recon/cavity/anatomy.h"

namespace odontoscope {

/// Keys in a fixed order; the same anatomy gives the same bytes. `source` is the input's name.
std::string anatomy_json(const Anatomy& anatomy, const std::string& source);

/// One row a canal, with a header; fields after RFC 4180. What is not known is empty.
std::string anatomy_csv(const Anatomy& anatomy);

}  // namespace odontoscope
