#pragma once
// A person at the viewer, scripted: moves, clicks, types, waits, and looks at the pixels.

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/view/offscreen.h"
#include "engine/viewer/compare/compare_mode.h"
#include "engine/viewer/fly/fly_mode.h"
#include "engine/viewer/help/help_mode.h"
#include "engine/viewer/look/look_mode.h"
#include "engine/viewer/measure/measure_mode.h"
#include "engine/viewer/names/names_mode.h"
#include "engine/viewer/notes/notes_mode.h"
#include "engine/viewer/open/open_mode.h"
#include "engine/viewer/viewer.h"
#include "engine/viewer/volume/volume_mode.h"

namespace odontoscope::testing_support {

/// A tooth of three balls, so simple that a frame takes no time, as the viewer's loader would deliver it.
LoadedModel toy_tooth();

class ViewerTest : public ::testing::Test {
 protected:
  static constexpr PixelSize size{960, 640};

  void SetUp() override;
  /// Nothing may be left behind that the driver complained of.
  void TearDown() override;

  /// A fresh viewer over the loader; the model is not loaded yet.
  Viewer& make_viewer(ViewerOptions options = {});
  /// One that shows the toy tooth and has settled.
  Viewer& viewer_with_tooth(ViewerOptions options = {});

  void frame(double seconds = 1.0 / 60);
  void frames(int count, double seconds = 1.0 / 60);
  void wait_until_loaded();
  void move(double x, double y);
  void press(MouseButton button = MouseButton::left, Modifiers with = {});
  void release(MouseButton button = MouseButton::left);
  void click(double x, double y);
  void drag(double x, double y, double to_x, double to_y, MouseButton button = MouseButton::left, Modifiers with = {});
  void scroll(double x, double y, double notches);
  void type(char32_t character);
  void press_key(Key key, Modifiers with = {});

  /// As ImGui counts it, of a control with this label, inside the ids given.
  static unsigned control_id(const std::string& label, const std::vector<std::string>& inside = {},
                             const std::string& window = "panel");
  /// Near the right end of the control with this label, inside the ids given.
  glm::dvec2 control(const std::string& label, const std::vector<std::string>& inside = {},
                     const std::string& window = "panel");
  void click_control(const std::string& label, const std::vector<std::string>& inside = {},
                     const std::string& window = "panel");

  Image picture();
  /// Kept in the build's folder tests/ui/pictures, to be looked at.
  void keep_picture(const std::string& name);
  Viewer& viewer() { return *viewer_; }
  template <class M>
  M& mode() {
    return viewer_->mode<M>();
  }
  const Gl& gl() const { return context_->gl(); }
  bool first_run_ = false;  // with the strip of hints
  float scale_ = 1;
  PixelSize size_ = size;

 private:
  std::unique_ptr<GlContext> context_;
  Framebuffer pixels_;
  std::unique_ptr<Viewer> viewer_;
};

/// A folder of its own, gone afterwards.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace odontoscope::testing_support
