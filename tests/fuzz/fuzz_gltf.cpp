// Any bytes as glTF in JSON. Files beside it are looked for in a folder that is not there.
#include "tests/fuzz/fuzz_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto parse = [](std::string_view bytes, const std::string&) {
    return odontoscope::parse_gltf(bytes, "no-such-folder/fuzz.gltf");
  };
  return odontoscope::fuzz::mesh(parse, data, size);
}
