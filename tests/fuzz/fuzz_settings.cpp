// Any bytes as the viewer's settings, which are never refused; what comes out must survive writing.
#include "engine/viewer/settings.h"
#include "tests/fuzz/fuzz_bytes.h"

using namespace odontoscope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Settings settings = settings_from_json(std::string(fuzz::text(data, size))).settings;
  const ReadSettings again = settings_from_json(to_json(settings));
  fuzz::require(again.settings == settings && again.complaint.empty());
  return 0;
}
