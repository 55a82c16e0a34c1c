// Any bytes as a volume in one file: NRRD, MetaImage, NIfTI or DICOM. ITK and GDCM come compiled, without counters and sanitizers: what they do
// wrong is seen only where it ends the program or takes too long, and the search is led by our own checks in front of them.
#include <filesystem>
#include <fstream>

#include "recon/volume/read_volume.h"
#include "tests/fuzz/fuzz_bytes.h"
#include "tests/hostile/volume_name.h"

using namespace odontoscope;

namespace {

/// Empty but for the file: a DICOM file is read with all others of its series in its folder.
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
    std::filesystem::remove(file_);
    file_ = path_ / hostile::volume_name(fuzz::text(data, size));
    std::ofstream(file_, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return file_.string();
  }

 private:
  std::filesystem::path path_, file_;
};

}  // namespace

/// ITK's reader of NRRD leaks some kilobytes for a file that it refuses; there is nothing that we could free.
extern "C" const char* __lsan_default_suppressions() { return "leak:libITK\nleak:libitk\n"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Folder folder;
  const std::string file = folder.file_of(data, size);
  return fuzz::refused_or_read([&] { validate_volume(read_volume(file)); });
}
