// Any bytes as a scene; what is accepted must survive writing.
#include "engine/scene/scene_json.h"
#include "tests/fuzz/fuzz_bytes.h"

using namespace odontoscope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::refused_or_read([&] {
    const std::string written = to_json(scene_from_json(std::string(fuzz::text(data, size)), Scene{}, "fuzz"));
    fuzz::require(to_json(scene_from_json(written, Scene{}, "again")) == written);
  });
}
