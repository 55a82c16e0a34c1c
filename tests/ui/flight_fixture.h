#pragma once
// A person who flies, scripted: over driver.h.

#include <memory>
#include <string>

#include "tests/ui/driver.h"
#include "tests/ui/teeth.h"

namespace odontoscope::testing_support {

class FlightTest : public ViewerTest {
 protected:
  void SetUp() override {
    ViewerTest::SetUp();
    size_ = {480, 320};  // frames are many
  }
  Viewer& viewer_with(LoadedModel model, ViewerOptions options = {}) {
    options.load = [model](const LoadRequest&, const Progress&) { return model; };
    return viewer_with_tooth(std::move(options));
  }
  FlyState& fly() { return mode<FlyMode>().state(); }
  const FlightSpaces& spaces() { return *viewer().state().shown->flight; }
  /// Until the fade is over.
  void fade() {
    for (int i = 0; i < 6; ++i) frame(0.2);
  }
  void hold(char place, double seconds, double hertz = 60) {
    viewer().handle(KeyChanged{Key::other, true, {}, place});
    frames(static_cast<int>(seconds * hertz), 1 / hertz);
    viewer().handle(KeyChanged{Key::other, false, {}, place});
    frame(1 / hertz);
  }
  /// Every pixel covered, every nearest face a front.
  void expect_closed_in();
};

}  // namespace odontoscope::testing_support
