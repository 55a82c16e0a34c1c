// Any bytes as a volume in one file (NRRD, MetaImage, NIfTI or DICOM), or as a DICOM folder of several: "FOLDER" and
// then files, each with its length in two bytes before it; one that is a DICOMDIR is called so. All of it is code of
// ours but the decoders of compressed pixels, which run in a process of their own: GDCM comes compiled, without
// counters and sanitizers.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "recon/volume/read_volume.h"
#include "tests/fuzz/fuzz_bytes.h"
#include "tests/hostile/volume_name.h"

using namespace odontoscope;

namespace {

/// Empty but for what is put in: a DICOM file is read with all others of its series in its folder.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "odontoscope-fuzz-XXXXXX").string();
    fuzz::require(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  /// The only file in it, from now on.
  std::string file_of(const std::uint8_t* data, std::size_t size) {
    clear();
    return put(hostile::volume_name(fuzz::text(data, size)), fuzz::text(data, size)).string();
  }

  /// Several files, up to four; the folder's name.
  std::string files_of(std::string_view bytes) {
    clear();
    for (const char* name : {"a", "b", "c", "d"}) {
      if (bytes.size() < 2) break;
      const std::size_t length =
          static_cast<unsigned char>(bytes[0]) | static_cast<std::size_t>(static_cast<unsigned char>(bytes[1])) << 8;
      bytes.remove_prefix(2);
      put(is_directory(bytes.substr(0, length)) ? "DICOMDIR" : name, bytes.substr(0, length));
      bytes.remove_prefix(std::min(length, bytes.size()));
    }
    return path_.string();
  }

 private:
  static bool is_directory(std::string_view bytes) { return bytes.find("1.2.840.10008.1.3.10") != bytes.npos; }
  void clear() {
    for (const std::filesystem::path& file : files_) std::filesystem::remove(file);
    files_.clear();
  }
  std::filesystem::path put(const std::string& name, std::string_view bytes) {
    files_.push_back(path_ / name);
    std::ofstream(files_.back(), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return files_.back();
  }

  std::filesystem::path path_;
  std::vector<std::filesystem::path> files_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Folder folder;
  constexpr std::string_view several = "FOLDER";
  const std::string_view bytes = fuzz::text(data, size);
  const std::string file =
      bytes.starts_with(several) ? folder.files_of(bytes.substr(several.size())) : folder.file_of(data, size);
  return fuzz::refused_or_read([&] { validate_volume(read_volume(file)); });
}
