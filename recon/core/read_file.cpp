#include "recon/core/read_file.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "recon/core/error.h"
#include "recon/core/patient_read.h"

namespace odontoscope {
namespace {

struct Descriptor {
  int number = -1;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

[[noreturn]] void cannot_read(const std::string& file, std::string_view why, std::string_view remedy) {
  throw FileError(file, fmt::format("cannot be read: {}", why), remedy);
}

[[noreturn]] void too_large(const std::string& file, std::size_t most_bytes) {
  Place place;
  place.file = file;
  throw InputError("file-too-large", place, fmt::format("the file holds more than {} bytes", most_bytes),
                   "Split it, or check that it is the file you mean");
}

}  // namespace

std::string read_file(const std::string& file, std::size_t most_bytes, const std::stop_token& stop) {
  Descriptor in{open_to_read(file)};
  if (in.number < 0) cannot_read(file, std::strerror(errno), "Check its name and your rights to it");
  struct stat status {};
  if (::fstat(in.number, &status) != 0) cannot_read(file, std::strerror(errno), {});
  if (S_ISDIR(status.st_mode)) cannot_read(file, "it is a folder", "Name a file in it");
  // An endless device would fill the memory up to the limit before it is refused.
  if (!S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode)) cannot_read(file, "it is no regular file", {});
  const auto size = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
  if (size > most_bytes) too_large(file, most_bytes);

  // One byte more than the size tells, so that the end is met without growing; a pipe tells no size and grows.
  std::string bytes(size + 1, '\0');
  std::size_t filled = 0;
  for (;;) {
    if (filled == bytes.size()) bytes.resize(2 * bytes.size());
    const std::ptrdiff_t got = read_some(in.number, bytes.data() + filled, bytes.size() - filled, stop);
    if (got < 0) cannot_read(file, std::strerror(errno), {});
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
    if (filled > most_bytes) too_large(file, most_bytes);
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace odontoscope
