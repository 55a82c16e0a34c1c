#include <fcntl.h>
#include <glob.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <utility>

#include "recon/core/system_files.h"

namespace odontoscope::system {
namespace {

bool is_still_named(const Descriptor& file, const std::filesystem::path& name) {
  struct stat opened {
  }, named{};
  return ::fstat(file.number(), &opened) == 0 && ::lstat(name.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

}  // namespace

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this == &other) return *this;
  close();
  number_ = std::exchange(other.number_, -1);
  return *this;
}

bool Descriptor::close() noexcept { return number_ < 0 || ::close(std::exchange(number_, -1)) == 0; }

// --- reading ---------------------------------------------------------------------------------------------------------

Descriptor open_to_read(const std::filesystem::path& file) {
  return Descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
}

std::optional<OpenedFile> look_at(const Descriptor& file) {
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) return std::nullopt;
  using Kind = OpenedFile::Kind;
  const Kind kind = S_ISREG(status.st_mode)    ? Kind::regular
                    : S_ISDIR(status.st_mode)  ? Kind::folder
                    : S_ISFIFO(status.st_mode) ? Kind::pipe
                                               : Kind::other;
  return OpenedFile{kind, static_cast<std::size_t>(std::max<off_t>(status.st_size, 0))};
}

std::ptrdiff_t read_within(const Descriptor& from, char* to, std::size_t count, int milliseconds) {
  pollfd waiting{from.number(), POLLIN, 0};
  const int ready = ::poll(&waiting, 1, milliseconds);
  if (ready == 0 || (ready < 0 && errno == EINTR)) return nothing_yet;
  const ssize_t got = ::read(from.number(), to, count);
  if (got >= 0) return got;
  return errno == EINTR || errno == EAGAIN ? nothing_yet : -1;
}

std::optional<std::vector<std::string>> files_matching(const std::string& pattern) {
  glob_t found{};
  const int failed = ::glob(pattern.c_str(), 0, nullptr, &found);
  std::vector<std::string> files;
  if (failed == 0) files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  ::globfree(&found);
  if (failed != 0 && failed != GLOB_NOMATCH) return std::nullopt;
  return files;
}

// --- writing ---------------------------------------------------------------------------------------------------------

Descriptor create(const std::filesystem::path& file) {
  constexpr mode_t everyone_as_umask_allows = 0666;
  return Descriptor(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, everyone_as_umask_allows));
}

bool write(const Descriptor& to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(to.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = 0;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool may_write(const std::filesystem::path& file) { return ::access(file.c_str(), W_OK) == 0; }

bool may_run(const std::filesystem::path& file) { return ::access(file.c_str(), X_OK) == 0; }

void copy_mode(const std::filesystem::path& from, const Descriptor& to) {
  constexpr mode_t all_modes = 07777;
  struct stat existing {};
  if (::stat(from.c_str(), &existing) == 0) (void)!::fchmod(to.number(), existing.st_mode & all_modes);
}

// --- temporary files -------------------------------------------------------------------------------------------------

Descriptor lock_in_use(const Descriptor& file) {
  (void)!::flock(file.number(), LOCK_SH | LOCK_NB);
  return Descriptor(::fcntl(file.number(), F_DUPFD_CLOEXEC, 0));
}

void remove_unless_in_use(const std::filesystem::path& file) noexcept {
  const Descriptor left(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  struct stat status {};
  if (!left.is_open() || ::fstat(left.number(), &status) != 0 || !S_ISREG(status.st_mode)) return;
  if (::flock(left.number(), LOCK_EX | LOCK_NB) == 0 && is_still_named(left, file)) ::unlink(file.c_str());
}

Descriptor nameless_file() {
  std::string name = (std::filesystem::temp_directory_path() / "odontoscope-XXXXXX").string();
  Descriptor file(::mkostemp(name.data(), O_CLOEXEC));
  if (file.is_open()) ::unlink(name.c_str());
  return file;
}

std::string all_bytes(const Descriptor& file) {
  std::string bytes;
  std::array<char, 1 << 16> piece;
  for (off_t at = 0;;) {
    const ssize_t count = ::pread(file.number(), piece.data(), piece.size(), at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(piece.data(), static_cast<std::size_t>(count));
    at += count;
  }
}

std::optional<std::filesystem::path> new_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "odontoscope-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) return std::nullopt;
  return name;
}

}  // namespace odontoscope::system
