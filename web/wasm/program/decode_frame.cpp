// In place of recon/volume/decode_frame.cpp: GDCM's decoders are a module of their own (decoder.cpp), so that what a
// damaged frame does to memory is done to theirs. What dies there is told as what a child process dies of; what never
// returns is ended with the worker.
#include <emscripten.h>

#include "recon/volume/decode_apart.h"

// clang-format off
EM_JS(int, odontoscope_decoder_knows, (const char* syntax), {
  return Module.decoder && Module.decoder.knows(UTF8ToString(syntax >>> 0)) ? 1 : 0;
});

EM_JS(int, odontoscope_decoder_decodes, (const char* syntax, const char* photometric, const unsigned* numbers, int count, const char* bytes,
                                         unsigned length, char* to, unsigned wanted), {
  const at = numbers >>> 2;
  const decoded = Module.decoder.decode(UTF8ToString(syntax >>> 0), UTF8ToString(photometric >>> 0), HEAPU32.slice(at, at + count),
                                        HEAPU8.subarray(bytes >>> 0, (bytes >>> 0) + length), wanted);
  if (!decoded) return 0;
  HEAPU8.set(decoded, to >>> 0);
  return 1;
});
// clang-format on

namespace odontoscope {

bool is_decodable(const std::string& syntax) { return odontoscope_decoder_knows(syntax.c_str()) != 0; }

bool decode_here(const CompressedFrame& frame, char* to) {
  const unsigned numbers[] = {frame.rows,        frame.columns,  frame.bits_allocated,
                              frame.bits_stored, frame.high_bit, frame.is_signed ? 1u : 0u};
  return odontoscope_decoder_decodes(frame.syntax.c_str(), frame.photometric.c_str(), numbers, std::size(numbers),
                                     frame.bytes.data(), static_cast<unsigned>(frame.bytes.size()), to,
                                     static_cast<unsigned>(frame.decoded_bytes())) != 0;
}

}  // namespace odontoscope
