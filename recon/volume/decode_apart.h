#pragma once
// Compressed DICOM frames decoded in a child process, so that nothing in a file can end this program: the decoders
// behind GDCM assert, abort and overrun on some damaged data, and what else they do wrong is not known. Inner part of
// read_volume.h.
//
// The child (work_apart.h) may take limits::decoding_seconds of processor time for each frame,
// limits::decoding_seconds_by_clock from one that it finishes to the next, and limits::decoding_bytes of memory beyond
// what it began with.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/core/progress.h"

namespace odontoscope {

struct CompressedFrame {
  std::string file;    // for messages
  std::string syntax;  // transfer syntax UID
  std::string photometric;
  unsigned rows = 0, columns = 0, bits_allocated = 0, bits_stored = 0, high_bit = 0;
  bool is_signed = false;
  std::string bytes;  // its pieces in a row

  /// As decoded.
  std::size_t decoded_bytes() const { return std::size_t{rows} * columns * (bits_allocated / 8); }
};

/// The numbers of each frame as stored, in this machine's byte order. All frames have as many bytes decoded. Throws
/// InputError damaged-volume, naming the file of the first frame that the child does not come back with.
std::vector<std::string> decode_apart(const std::vector<CompressedFrame>& frames, const Progress& progress);

/// In this process: for the child, and for what bounds itself. False if it cannot be decoded.
bool decode_here(const CompressedFrame& frame, char* to);

/// Does GDCM know a decoder for the transfer syntax?
bool is_decodable(const std::string& syntax);

}  // namespace odontoscope
