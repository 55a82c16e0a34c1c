#include "recon/volume/decode_apart.h"

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/work_apart.h"
#include "recon/volume/byte_source.h"

namespace odontoscope {

std::vector<std::string> decode_apart(const std::vector<CompressedFrame>& frames, const Progress& progress) {
  if (frames.empty()) return {};
  const std::size_t each = frames.front().decoded_bytes();
  const ApartLimits allowed{limits::decoding_seconds * static_cast<unsigned>(frames.size() + 1),
                            limits::decoding_seconds_by_clock, limits::decoding_bytes + 8 * each};
  const DoneApart done = work_apart(
      [&](const SendToParent& send) {
        std::string decoded(each, '\0');
        for (const CompressedFrame& frame : frames) {
          if (!decode_here(frame, decoded.data())) return;
          send(decoded.data(), each);
        }
      },
      allowed, progress);
  const std::size_t good = each == 0 ? 0 : done.sent.size() / each;
  if (good < frames.size()) {
    throw InputError("damaged-volume", in_file(frames[good].file), "its compressed pixels cannot be decoded",
                     "get a whole copy of the file, or store it uncompressed");
  }
  std::vector<std::string> decoded;
  for (std::size_t n = 0; n < frames.size(); ++n) decoded.push_back(done.sent.substr(n * each, each));
  return decoded;
}

}  // namespace odontoscope
