// The module that decodes compressed DICOM frames (recon/volume/decode_frame.cpp, as it stands) for the engine, which
// is another module. JavaScript carries bytes between the two (npm/decoder.mjs).
#include <cstdlib>
#include <new>
#include <string>

#include "recon/volume/decode_apart.h"

namespace {

odontoscope::CompressedFrame frame;
std::string decoded;

}  // namespace

extern "C" {

/// Zeros where there is no memory for them, as in a process that ended.
char* odontoscope_memory(std::size_t bytes) { return static_cast<char*>(std::malloc(bytes)); }

bool odontoscope_knows(const char* syntax) { return odontoscope::is_decodable(syntax); }

/// The next frame's head. Strings end with a zero.
void odontoscope_head(const char* syntax, const char* photometric, unsigned rows, unsigned columns,
                      unsigned bits_allocated, unsigned bits_stored, unsigned high_bit, bool is_signed) {
  frame = {{}, syntax, photometric, rows, columns, bits_allocated, bits_stored, high_bit, is_signed, {}};
}

/// Its bytes, decoded: frame.decoded_bytes() of them; null if they cannot be.
const char* odontoscope_decode(const char* bytes, std::size_t count) {
  frame.bytes.assign(bytes, count);
  decoded.assign(frame.decoded_bytes(), '\0');
  return odontoscope::decode_here(frame, decoded.data()) ? decoded.data() : nullptr;
}

}  // extern "C"
