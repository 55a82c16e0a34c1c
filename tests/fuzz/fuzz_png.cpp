// Any bytes as a PNG; what is accepted must survive writing.
#include "engine/picture/png.h"
#include "tests/fuzz/fuzz_bytes.h"

using namespace odontoscope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::refused_or_read([&] {
    const Image image = read_png(fuzz::File(data, size).name());
    const std::string written = png_bytes(image);
    const Image again =
        read_png(fuzz::File(reinterpret_cast<const std::uint8_t*>(written.data()), written.size()).name());
    fuzz::require(again.width == image.width && again.height == image.height && again.rgba == image.rgba);
  });
}
