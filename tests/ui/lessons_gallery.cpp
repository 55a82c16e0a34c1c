// Pictures of every note of the built-in lessons, to be looked at, for whoever changes one: run with
// --gtest_also_run_disabled_tests.

#include "engine/navigate/built_in_lessons.h"
#include "tests/ui/flight_fixture.h"

namespace odontoscope::testing_support {
namespace {

TEST_F(FlightTest, DISABLED_LessonsGallery) {
  size_ = {1280, 800};
  viewer_with(sample_tooth_loaded());
  type(U'g');
  frames(2);
  keep_picture("lessons-menu");
  press_key(Key::escape);
  for (std::size_t number = 0; number < built_in_lessons().size(); ++number) {
    viewer().open({.lesson = number});
    const std::size_t count = built_in_lessons()[number].notes;
    for (std::size_t note = 0; note < count; ++note) {
      mode<NotesMode>().notes().go_to = note;
      frame();
      size_ = {64, 48};  // on the way nobody looks
      for (int i = 0; i < 8; ++i) frame(0.3);
      size_ = {1280, 800};
      frames(4, 0.01);
      keep_picture("lesson-" + std::to_string(number + 1) + "-" + std::to_string(note + 1));
    }
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
