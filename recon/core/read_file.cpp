#include "recon/core/read_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "recon/core/error.h"
#include "recon/core/patient_read.h"

namespace odontoscope {
namespace {

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
  const system::Descriptor in = system::open_to_read(file);
  if (!in.is_open()) cannot_read(file, std::strerror(errno), "Check its name and your rights to it");
  const auto opened = system::look_at(in);
  if (!opened) cannot_read(file, std::strerror(errno), {});
  using Kind = system::OpenedFile::Kind;
  if (opened->kind == Kind::folder) cannot_read(file, "it is a folder", "Name a file in it");
  // An endless device would fill the memory up to the limit before it is refused.
  if (opened->kind == Kind::other) cannot_read(file, "it is no regular file", {});
  const std::size_t size = opened->bytes;
  if (size > most_bytes) too_large(file, most_bytes);

  // One byte more than the size tells, so that the end is met without growing; a pipe tells no size and grows.
  std::string bytes(size + 1, '\0');
  std::size_t filled = 0;
  for (;;) {
    if (filled == bytes.size()) bytes.resize(2 * bytes.size());
    const std::ptrdiff_t got = read_some(in, bytes.data() + filled, bytes.size() - filled, stop);
    if (got < 0) cannot_read(file, std::strerror(errno), {});
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
    if (filled > most_bytes) too_large(file, most_bytes);
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace odontoscope
