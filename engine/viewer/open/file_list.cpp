#include "engine/viewer/open/file_list.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "recon/core/lower_case.h"
#include "recon/volume/dicom_file.h"

namespace odontoscope {

bool openable(std::string_view name) {
  static constexpr std::array<std::string_view, 20> endings = {
      ".json", ".glb", ".gltf", ".stl", ".ply",  ".obj", ".nrrd", ".nhdr", ".nii", ".nii.gz",
      ".mha",  ".mhd", ".dcm",  ".ser", ".jser", ".csl", ".hdr",  ".img",  ".ima", ".dicom"};
  const std::string lower = lower_case(std::string(name));
  return std::any_of(endings.begin(), endings.end(),
                     [&](std::string_view ending) { return lower.size() > ending.size() && lower.ends_with(ending); });
}

FolderList list_folder(const std::filesystem::path& folder) {
  FolderList list;
  std::error_code error;
  list.folder =
      std::filesystem::absolute(folder.empty() ? std::filesystem::path(".") : folder, error).lexically_normal();
  if (!list.folder.has_filename() && list.folder.has_parent_path() && list.folder != list.folder.root_path())
    list.folder = list.folder.parent_path();  // "a/"
  std::filesystem::directory_iterator entry(list.folder, std::filesystem::directory_options::skip_permission_denied,
                                            error);
  if (error) {
    list.trouble = error.message();
    return list;
  }
  std::size_t looked_into = 0;
  for (const std::filesystem::directory_iterator end; entry != end && !error; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code unknown;
    const bool folder_there = entry->is_directory(unknown);
    if (name.starts_with(".")) continue;
    // Plain files alone: a pipe would be waited for.
    const auto is_dicom = [&] {
      return entry->is_regular_file(unknown) && looked_into++ < most_looked_into &&
             looks_like_dicom(entry->path().string());
    };
    if (!folder_there && !openable(name) && !is_dicom()) continue;
    list.entries.push_back({name, folder_there});
  }
  std::sort(list.entries.begin(), list.entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
    return std::tuple(!a.folder, lower_case(a.name), a.name) < std::tuple(!b.folder, lower_case(b.name), b.name);
  });
  if (list.entries.size() > most_listed) {
    list.left_out = list.entries.size() - most_listed;
    list.entries.resize(most_listed);
  }
  return list;
}

}  // namespace odontoscope
