// In place of recon/volume/decode_apart.cpp and decode_frame.cpp: a WebAssembly module can start no process to keep damaged data in, and has no
// decoders. Compressed DICOM pixels are refused by whoever asks is_decodable first.
#include "recon/core/error.h"
#include "recon/volume/decode_apart.h"

namespace odontoscope {

bool is_decodable(const std::string&) { return false; }

std::vector<std::string> decode_apart(const std::vector<CompressedFrame>& frames, const Progress&) {
  if (frames.empty()) return {};
  throw InternalError("compressed pixels were to be decoded where nothing can decode them");
}

}  // namespace odontoscope
