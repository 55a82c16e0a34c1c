#pragma once
// What the modes of a viewer share: what is shown, how it is seen, where the hand is, and how to get from one view to
// another.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/navigate/transition.h"
#include "engine/viewer/model_picture.h"
#include "engine/viewer/modes.h"
#include "engine/viewer/pointing.h"
#include "engine/viewer/viewer_options.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

/// Views on their way to another.
struct CameraMotion {
  std::optional<Transition> camera;
  std::optional<LookTransition> looks;
};

/// Dark, for what is better not seen: a way through a wall, another scene at once.
class Fade {
 public:
  /// Fades to dark, does it, and fades in again. What comes while it is dark waits for no second fade.
  void darken_then(std::function<void()> at_dark);
  void advance(double seconds);
  void stop() { *this = {}; }
  bool on() const { return running_; }
  /// It is not dark yet.
  bool darkening() const { return running_ && at_dark_; }
  /// 1 hides everything.
  double dark() const { return dark_; }

 private:
  bool running_ = false;
  double seconds_ = 0, dark_ = 0;
  std::function<void()> at_dark_;
};

/// The part of the picture that the panel leaves, and the views in it, as last drawn.
struct Layout {
  std::vector<ViewPane> panes;
  Area viewport;   // all of them together
  PixelSize size;  // of the whole picture
  float scale = 1;
};

/// STEM-001.ENDING, the first that there is not yet; nothing is ever overwritten.
class FileNames {
 public:
  explicit FileNames(std::filesystem::path folder) : folder_(std::move(folder)) {}
  void move_to(std::filesystem::path folder) { folder_ = std::move(folder); }
  const std::filesystem::path& folder() const { return folder_; }
  /// Throws FileError if there are too many.
  std::filesystem::path next(const std::string& stem, const std::string& ending);

 private:
  std::filesystem::path folder_;                 // empty: the current one
  std::set<std::filesystem::path> names_given_;  // to files that may not be there yet
};

class Workspace {
 public:
  /// The context of `gl` is current now and at every call, and outlives this.
  Workspace(const Gl& gl, const ShaderLibrary& shaders, ViewerOptions options);

  const Gl& gl;
  const ShaderLibrary shaders;
  const ViewerOptions options;
  ViewerState state;
  Interface interface;
  ModelPicture picture;
  CameraMotion motion;
  Fade fade;
  Layout layout;
  Pointing pointing;
  FileNames files;
  double now = 0;            // seconds that the viewer has run
  int frames_to_settle = 3;  // panels need a frame or two to follow an event
  const Modes modes;         // last: they use all others

  void notice(std::string words, NoticeKind kind = NoticeKind::told, double seconds = Notice{}.seconds_left);
  /// Begins to load; the model that is shown stays until the new one is ready.
  void open(LoadRequest request);
  /// In place of what was shown before.
  void show(std::shared_ptr<const LoadedModel> shown);

  // Pictures to be saved, by the settings for them; Viewer::picture tells more. Precondition: a model is shown.
  Scene scene_of_picture() const;
  PictureOptions options_of_picture(const Scene& scene) const;
  Image image();

  // Cameras.
  void go_to(const Camera& camera, double seconds = transition_seconds);
  /// At once, within reach of the model.
  void set_camera(const Camera& camera);
  void jump_to(const Camera& camera);
  /// Where it is, or is on its way to.
  Camera camera_goal() const { return motion.camera ? motion.camera->goal() : state.scene.camera; }
  /// At once what a lesson's looks were on their way to.
  void settle_looks();

  // Places in the picture.
  const ViewPane* pane_at(double x, double y) const;
  const ViewPane& front() const { return layout.panes.front(); }
  const Model& model_of(const ViewPane& pane) const;
  const Pickable& pickable_of(const ViewPane& pane) const;
  std::optional<Hit> hit_at(const ViewPane& pane, double x, double y) const;
  /// The surface under a pixel, or the plane through the camera's target.
  glm::dvec3 anchor_at(const ViewPane& pane, double x, double y) const;
};

}  // namespace odontoscope
