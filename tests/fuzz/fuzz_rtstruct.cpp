// Any bytes as a DICOM structure set.
#include "recon/exchange/read_rtstruct.h"
#include "tests/fuzz/fuzz_bytes.h"

using namespace odontoscope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::refused_or_read([&] { parse_rtstruct(fuzz::text(data, size), "fuzz"); });
}
