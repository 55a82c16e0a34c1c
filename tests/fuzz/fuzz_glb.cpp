// Any bytes as GLB.
#include "tests/fuzz/fuzz_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return odontoscope::fuzz::mesh(odontoscope::parse_glb, data, size);
}
