// Any bytes as a teacher's notes; what is accepted must survive writing.
#include "engine/navigate/notes.h"
#include "tests/fuzz/fuzz_bytes.h"

using namespace odontoscope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::refused_or_read([&] {
    const Lesson lesson = parse_lesson(fuzz::text(data, size), "fuzz");
    fuzz::require(parse_lesson(to_json(lesson), "again") == lesson);
  });
}
