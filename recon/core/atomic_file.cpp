#include "recon/core/atomic_file.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

#include "recon/core/error.h"
#include "recon/core/system_processes.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const fs::path& file, std::string_view why, std::string_view remedy = {}) {
  throw FileError(file.string(), fmt::format("cannot be written: {}", why), remedy);
}

/// A name that no other temporary file of this program has; short, since the target's own may be as long as the system
/// allows.
fs::path temporary_name(const fs::path& folder) {
  static std::atomic<unsigned> count{0};
  return folder / fmt::format(".odontoscope-{}-{}.tmp", system::own_number(), count++);
}

/// The process that a temporary file's name tells; nothing if it is none of ours.
std::optional<int> owner_of(std::string_view name) {
  constexpr std::string_view begin = ".odontoscope-", end = ".tmp";
  if (!name.starts_with(begin) || !name.ends_with(end) || name.size() < begin.size() + end.size()) return std::nullopt;
  name = name.substr(begin.size(), name.size() - begin.size() - end.size());
  int process = 0;
  unsigned count = 0;
  const char* const last = name.data() + name.size();
  const auto [dash, wrong] = std::from_chars(name.data(), last, process);
  if (wrong != std::errc{} || dash == last || *dash != '-' || process <= 0) return std::nullopt;
  const auto [rest, wrong_too] = std::from_chars(dash + 1, last, count);
  if (wrong_too != std::errc{} || rest != last) return std::nullopt;
  return process;
}

/// Held while a temporary file comes into being and is not locked yet, and while leftovers are looked for.
std::mutex& making() {
  static std::mutex mutex;
  return mutex;
}

void remove_if_left(const fs::path& file, int owner) {
  if (owner == system::own_number() || !system::runs(owner)) system::remove_unless_in_use(file);
}

/// Where `file` really lies, links followed; checks that something regular, or nothing, is there.
fs::path resolved_target(const fs::path& file) {
  if (file.empty() || !file.has_filename()) cannot_write(file, "it names no file", "Name a file to write");
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) cannot_write(file, "it is a folder", "Name a file to write");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    cannot_write(file, "it is a device or a pipe", "Name a regular file");
  }
  if (fs::exists(status) && !system::may_write(file)) {
    cannot_write(file, std::strerror(errno), "Change its mode or choose another name");
  }
  if (!fs::is_symlink(fs::symlink_status(file, error))) return file;
  if (!fs::exists(status)) cannot_write(file, "it is a link that leads nowhere", "Remove the link");
  fs::path real = fs::canonical(file, error);
  if (error) cannot_write(file, error.message());
  return real;
}

fs::path folder_of(const fs::path& target) {
  const fs::path folder = target.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

}  // namespace

AtomicFile::AtomicFile(fs::path target) : asked_for_(std::move(target)), target_(resolved_target(asked_for_)) {
  {
    const std::lock_guard guard(making());
    do {
      temporary_ = temporary_name(folder_of(target_));
      written_ = system::create(temporary_);
    } while (!written_.is_open() && errno == EEXIST);
    if (written_.is_open()) lock_ = system::lock_in_use(written_);  // kept when the file is closed before the rename
  }
  if (!written_.is_open()) {
    cannot_write(asked_for_, std::strerror(errno), "Check that its folder exists and that you may write there");
  }
  system::copy_mode(target_, written_);
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept { *this = std::move(other); }

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this == &other) return *this;
  abandon();
  asked_for_ = std::move(other.asked_for_);
  target_ = std::move(other.target_);
  temporary_ = std::exchange(other.temporary_, {});
  written_ = std::move(other.written_);
  lock_ = std::move(other.lock_);
  return *this;
}

AtomicFile::~AtomicFile() { abandon(); }

void AtomicFile::abandon() noexcept {
  written_.close();
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
  temporary_.clear();
  lock_.close();
}

void AtomicFile::write(std::string_view bytes) {
  if (!written_.is_open()) throw InternalError("a file was written to after it was closed");
  if (!system::write(written_, bytes))
    cannot_write(asked_for_, errno != 0 ? std::strerror(errno) : "nothing more is taken", "Free some space");
}

void AtomicFile::close() {
  if (!written_.close()) cannot_write(asked_for_, std::strerror(errno), "Free some space");
}

void AtomicFile::commit() {
  if (temporary_.empty()) throw InternalError("a file was committed twice");
  close();
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) cannot_write(asked_for_, error.message());
  temporary_.clear();
  abandon();
}

void remove_leftovers(const fs::path& folder) noexcept try {
  const std::lock_guard guard(making());
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path file = entry->path();
    if (const auto owner = owner_of(file.filename().native())) remove_if_left(file, *owner);
  }
} catch (...) {  // no memory for a name: they stay
}

namespace {

/// Keeps what a target held until release(); the destructor puts it back.
class Rollback {
 public:
  explicit Rollback(fs::path target) : target_(std::move(target)) {
    std::error_code error;
    if (!fs::exists(fs::symlink_status(target_, error))) return;
    const std::lock_guard guard(making());
    backup_ = temporary_name(folder_of(target_));
    fs::create_hard_link(target_, backup_, error);
    // Some file systems know no hard links.
    if (error) fs::copy_file(target_, backup_, fs::copy_options::none, error);
    if (!error) {
      lock_backup();
      return;
    }
    std::error_code ignored;
    fs::remove(backup_, ignored);
    cannot_write(target_, fmt::format("what it holds now cannot be kept safe ({})", error.message()));
  }
  Rollback(Rollback&& other) noexcept
      : target_(std::move(other.target_)),
        backup_(std::exchange(other.backup_, {})),
        lock_(std::move(other.lock_)),
        replaced_(std::exchange(other.replaced_, false)) {}
  Rollback& operator=(Rollback&&) = delete;
  ~Rollback() {
    std::error_code ignored;
    if (replaced_ && backup_.empty()) fs::remove(target_, ignored);
    if (replaced_ && !backup_.empty()) fs::rename(backup_, target_, ignored);
    if (!backup_.empty()) fs::remove(backup_, ignored);  // renaming a link onto itself leaves both names
  }

  void target_was_replaced() { replaced_ = true; }
  void release() { replaced_ = false; }

 private:
  void lock_backup() {
    lock_ = system::open_to_read(backup_);
    if (lock_.is_open()) system::lock_in_use(lock_);
  }

  fs::path target_, backup_;
  system::Descriptor lock_;
  bool replaced_ = false;
};

/// The same for all names of one file, as far as the system can tell.
fs::path one_name(const fs::path& target) {
  std::error_code error;
  const fs::path folder = fs::canonical(folder_of(target), error);
  return error ? target : folder / target.filename();
}

void refuse_same_target_twice(const std::vector<AtomicFile>& files) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (one_name(files[i].target()) != one_name(files[j].target())) continue;
      throw UsageError(fmt::format("{} is named twice as an output", files[i].target().string()),
                       "Give every output a name of its own");
    }
  }
}

}  // namespace

void write_files(std::span<const FileContent> files) {
  std::vector<AtomicFile> prepared;
  prepared.reserve(files.size());
  for (const FileContent& content : files) prepared.emplace_back(content.file);
  refuse_same_target_twice(prepared);
  for (std::size_t i = 0; i < files.size(); ++i) {
    prepared[i].write(files[i].bytes);
    prepared[i].close();
  }
  std::vector<Rollback> rollbacks;
  rollbacks.reserve(files.size());
  for (const AtomicFile& file : prepared) rollbacks.emplace_back(file.target());
  for (std::size_t i = 0; i < files.size(); ++i) {
    prepared[i].commit();
    rollbacks[i].target_was_replaced();
  }
  for (Rollback& rollback : rollbacks) rollback.release();
}

}  // namespace odontoscope
