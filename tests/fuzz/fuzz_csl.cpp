// Any bytes as CSL, mended where that can be done.
#include "recon/exchange/read_csl.h"
#include "recon/exchange/repair_contours.h"
#include "recon/input/validate.h"
#include "tests/fuzz/fuzz_bytes.h"

using namespace odontoscope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::refused_or_read([&] {
    const FileContours read = parse_csl(fuzz::text(data, size), "fuzz");
    validate(repair_contours(read.stack).stack);
  });
}
