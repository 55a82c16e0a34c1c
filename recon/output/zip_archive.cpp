#include "recon/output/zip_archive.h"

#include <zip.h>

#include <memory>

#include "recon/core/error.h"

namespace odontoscope {
namespace {

constexpr zip_uint16_t midnight = 0, new_year_1980 = (1 << 5) | 1;  // as ZIP counts: the earliest it can say

struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
struct DiscardArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Source = std::unique_ptr<zip_source_t, FreeSource>;
using Archive = std::unique_ptr<zip_t, DiscardArchive>;

[[noreturn]] void refuse_zip(const std::string& why) {
  throw FileError("the archive of a .3mf", "it cannot be made: " + why, "Free some memory, and try again");
}

void add_entry(zip_t* archive, const ZipEntry& entry) {
  Source source(zip_source_buffer(archive, entry.bytes.data(), entry.bytes.size(), 0));
  if (!source) refuse_zip(zip_strerror(archive));
  const zip_int64_t index = zip_file_add(archive, entry.name.c_str(), source.get(), ZIP_FL_ENC_UTF_8);
  if (index < 0) refuse_zip(zip_strerror(archive));
  static_cast<void>(source.release());  // the archive's now
  const auto at = static_cast<zip_uint64_t>(index);
  if (zip_set_file_compression(archive, at, ZIP_CM_DEFLATE, 6) != 0 ||
      zip_file_set_dostime(archive, at, midnight, new_year_1980, 0) != 0)
    refuse_zip(zip_strerror(archive));
}

std::string content_of(zip_source_t* source) {
  std::string bytes;
  if (zip_source_open(source) != 0) refuse_zip(zip_error_strerror(zip_source_error(source)));
  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_source_stat(source, &stat) == 0 && (stat.valid & ZIP_STAT_SIZE) != 0) bytes.resize(stat.size);
  const zip_int64_t read = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (read < 0 || static_cast<std::size_t>(read) != bytes.size() || bytes.empty())
    refuse_zip("it could not be read back");
  return bytes;
}

}  // namespace

std::string zip_bytes(std::span<const ZipEntry> entries) {
  zip_error_t error;
  zip_error_init(&error);
  Source memory(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!memory) refuse_zip(zip_error_strerror(&error));
  Archive archive(zip_open_from_source(memory.get(), ZIP_TRUNCATE, &error));
  if (!archive) refuse_zip(zip_error_strerror(&error));
  zip_source_keep(memory.get());  // once for the archive, once for us
  for (const ZipEntry& entry : entries) add_entry(archive.get(), entry);
  if (zip_close(archive.get()) != 0) refuse_zip(zip_strerror(archive.get()));
  static_cast<void>(archive.release());
  return content_of(memory.get());
}

}  // namespace odontoscope
