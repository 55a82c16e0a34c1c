// Any bytes as a series of PyReconstruct.
#include "recon/exchange/read_jser.h"
#include "recon/exchange/repair_contours.h"
#include "tests/fuzz/fuzz_bytes.h"

using namespace odontoscope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::refused_or_read([&] { repair_contours(parse_jser(fuzz::text(data, size), "fuzz").stack); });
}
