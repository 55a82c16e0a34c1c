#pragma once
// Files that are written whole or not at all.
//
// The bytes go to a temporary file in the target's own folder, which a rename then puts in the target's place: at
// no moment does the target's name show a half-written file. Nothing is forced to the disk (no fsync): this
// guards against errors and interruption of the program, not against loss of power.
//
// A temporary file is locked while it is in use, so that remove_leftovers, of whatever process, machine or container
// that shares the folder, can tell it from one whose program was killed.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "recon/core/system_files.h"

namespace odontoscope {

/// A file that comes into being at commit(). Movable, not copyable.
class AtomicFile {
 public:
  /// Opens the temporary file. A link is followed: what it points to is replaced, not the link. A file that exists
  /// keeps its mode. FileError if the target is a folder, a device or pipe, or write-protected, or if its folder is
  /// missing or does not allow a new file.
  explicit AtomicFile(std::filesystem::path target);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  /// Removes the temporary file unless commit() was called.
  ~AtomicFile();

  /// Appends. FileError when the disk is full or the write fails for any other reason.
  void write(std::string_view bytes);
  /// All that can fail before the rename has failed after this; further writes are not allowed. Called by commit().
  void close();
  /// Puts the file in the target's place. FileError if that fails; the target is then as it was.
  void commit();

  const std::filesystem::path& target() const { return target_; }

 private:
  void abandon() noexcept;

  std::filesystem::path asked_for_, target_, temporary_;
  system::Descriptor written_, lock_;
};

/// Removes temporary files that a killed run left in `folder`: named as ours, no longer locked, and no process of that
/// number but this one lives. What cannot be listed or removed stays; nothing else is touched.
void remove_leftovers(const std::filesystem::path& folder) noexcept;

struct FileContent {
  std::filesystem::path file;
  std::string bytes;
};

/// Writes all files or none: every byte is on the disk before the first target is touched, and should putting one of
/// them in place then fail, those before it are put back as they were. Throws FileError, or UsageError if two of the
/// names are the same file. Not safe against another program that writes the same targets at that moment.
void write_files(std::span<const FileContent> files);

}  // namespace odontoscope
