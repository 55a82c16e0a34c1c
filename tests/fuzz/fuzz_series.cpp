// Any bytes as a header and as a section of a series of Reconstruct.
#include "recon/exchange/read_series.h"
#include "tests/fuzz/fuzz_bytes.h"

using namespace odontoscope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::refused_or_read([&] { parse_series_header(fuzz::text(data, size), "fuzz"); });
  return fuzz::refused_or_read([&] { parse_series_section(fuzz::text(data, size), "fuzz"); });
}
