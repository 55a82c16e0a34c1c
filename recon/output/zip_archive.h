#pragma once
// A ZIP archive in memory. For the .cpp files of this room only.

#include <span>
#include <string>

namespace odontoscope {

struct ZipEntry {
  std::string name;  // with forward slashes
  std::string bytes;
};

/// Deflated, in the order given, all dated 1980-01-01: the same entries give the same bytes. FileError if that fails
/// (out of memory).
std::string zip_bytes(std::span<const ZipEntry> entries);

}  // namespace odontoscope
