#pragma once
// The files of a folder that the viewer opens, to choose one from.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace odontoscope {

struct FolderEntry {
  std::string name;
  bool folder = false;
  friend bool operator==(const FolderEntry&, const FolderEntry&) = default;
};

struct FolderList {
  std::filesystem::path folder;      // absolute
  std::vector<FolderEntry> entries;  // folders first, then files, by name without regard to capitals
  std::size_t left_out = 0;          // beyond the most that are listed
  std::string trouble;               // why it cannot be read; empty if it can
};

inline constexpr std::size_t most_listed = 500;
/// Files without a known ending that are looked into for the mark of DICOM, which seldom has one.
inline constexpr std::size_t most_looked_into = 2000;

/// By its ending: contours, meshes, volumes, lessons.
bool openable(std::string_view name);
/// What begins with a dot is left out; what is DICOM by its content is in, whatever its name. Never throws for what the
/// disk holds.
FolderList list_folder(const std::filesystem::path& folder);

}  // namespace odontoscope
