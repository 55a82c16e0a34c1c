#include "engine/web/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

#include "recon/core/error.h"

namespace odontoscope {

std::vector<std::uint8_t> gzip(std::string_view bytes) {
  constexpr int level = 6, gzip_window = 15 + 16, memory = 8;
  constexpr std::size_t piece = std::size_t{1} << 24;
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, gzip_window, memory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw InternalError("zlib does not start");
  std::vector<std::uint8_t> packed, room(piece);
  int state = Z_OK;
  for (std::size_t at = 0; state != Z_STREAM_END;) {
    const std::size_t size = std::min(piece, bytes.size() - at);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + at));
    stream.avail_in = static_cast<uInt>(size);
    at += size;
    do {
      stream.next_out = room.data();
      stream.avail_out = static_cast<uInt>(room.size());
      state = deflate(&stream, at == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
      packed.insert(packed.end(), room.begin(), room.end() - stream.avail_out);
    } while (stream.avail_out == 0);
  }
  deflateEnd(&stream);
  return packed;
}

}  // namespace odontoscope
