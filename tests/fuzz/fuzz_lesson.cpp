// Any bytes as a lesson.
#include "engine/comparison/artefact_lesson.h"
#include "tests/fuzz/fuzz_bytes.h"

using namespace odontoscope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::refused_or_read([&] {
    for (const ArtefactLessonStep& step : parse_artefact_lesson(fuzz::text(data, size), "fuzz").steps)
      step.scene_over(Scene{});
  });
}
