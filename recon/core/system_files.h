#pragma once
// What the operating system is asked for about files. posix_files.cpp and posix_processes.cpp are all that names one: a
// program for another system brings its own two.
//
// Whatever fails leaves errno set, unless it says otherwise; what to say about it is the caller's business.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odontoscope::system {

/// An open file, or an end of a connection, that goes with its owner.
class Descriptor {
 public:
  Descriptor() = default;
  /// Takes what was opened; none, if it is negative.
  explicit Descriptor(int opened) : number_(opened) {}
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor() { close(); }

  /// False if only now something turns out to have failed: network file systems tell of a full disk here.
  bool close() noexcept;
  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }  // negative: none

 private:
  int number_ = -1;
};

// --- reading ---------------------------------------------------------------------------------------------------------

/// Without waiting for a pipe's other end.
Descriptor open_to_read(const std::filesystem::path& file);

struct OpenedFile {
  enum class Kind { regular, folder, pipe, other } kind = Kind::other;
  std::size_t bytes = 0;  // of a regular one
};

std::optional<OpenedFile> look_at(const Descriptor& file);

/// Nothing has come yet, as a count of bytes.
inline constexpr std::ptrdiff_t nothing_yet = -2;

/// Up to `count` bytes, once some are there; 0 at the end, -1 if they cannot be read, `nothing_yet` after so long.
std::ptrdiff_t read_within(const Descriptor& from, char* to, std::size_t count, int milliseconds);

/// Files that a pattern of *, ? and [] matches, in order; nothing if folders could not be read.
std::optional<std::vector<std::string>> files_matching(const std::string& pattern);

// --- writing ---------------------------------------------------------------------------------------------------------

/// A new file, with the mode that the user's mask allows. errno is EEXIST where something has that name.
Descriptor create(const std::filesystem::path& file);
/// False if not all of it was taken; errno is 0 if the system says no more than that.
bool write(const Descriptor& to, std::string_view bytes);
bool may_write(const std::filesystem::path& file);
bool may_run(const std::filesystem::path& file);
/// Best effort: a file system without modes is no reason to write nothing.
void copy_mode(const std::filesystem::path& from, const Descriptor& to);

// --- temporary files -------------------------------------------------------------------------------------------------

/// Tells that a file is in use, for as long as the result or `file` is open: the lock outlives closing one of them.
/// Best effort: a file system without locks is no reason to write nothing.
Descriptor lock_in_use(const Descriptor& file);
/// Removes a regular file that nobody has locked, and that still has this name then.
void remove_unless_in_use(const std::filesystem::path& file) noexcept;

/// Without a name, open for reading and writing.
Descriptor nameless_file();
/// All that was written to such a file.
std::string all_bytes(const Descriptor& file);
/// A new folder for temporary files, of this user alone.
std::optional<std::filesystem::path> new_folder();

}  // namespace odontoscope::system
