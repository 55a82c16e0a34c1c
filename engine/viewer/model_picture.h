#pragma once
// The picture of the model, which is kept as long as nothing in it changes, and what it takes in the graphics
// processor's memory.

#include <memory>
#include <optional>
#include <vector>

#include "engine/picture/image.h"
#include "engine/render/renderer.h"
#include "engine/view/offscreen.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

struct OtherModel;
class Workspace;

class ModelPicture {
 public:
  ModelPicture(const Gl& gl, const ShaderLibrary& shaders);

  /// Another model.
  void take(const Model& model);
  /// The same, in other colours.
  void retake(const Model& model) { model_ = upload(gl_, model); }
  /// All of the workspace's panes, into the target; without a model, the ground.
  void draw(Workspace& at, PixelSize size, const Target& target);
  /// A fine picture is still to come.
  bool refining(const Workspace& at) const;
  /// The model in another scene, by itself.
  void draw_inset(const Scene& scene, const Pane& eye, int side) { renderer_.draw(model_, scene, {&eye, 1}, {side}); }
  /// For a file. Throws GraphicsError.
  Image image(ViewerState& state, const Scene& scene, const PictureOptions& options);

 private:
  /// What the kept picture shows; if nothing differs it is shown again.
  struct Drawn {
    std::shared_ptr<const LoadedModel> shown;
    Scene scene;
    std::vector<ViewPane> panes;
    std::size_t other = 0;  // OtherModel::version
    PixelSize size;
    int side = 0;
    bool operator==(const Drawn&) const = default;
  };
  /// How fast this machine is.
  struct Pace {
    double fine_picture_seconds = 0.5;  // about what one takes; a slow machine's guess until one was drawn
    double still_since = 0;
  };

  int side_for(const Workspace& at, PixelSize size, bool changed);
  void make_overlays(const ViewerState& state);
  /// What the cap shows, in the graphics processor's memory; null: the material.
  const GpuValueGrid* cap_values(ViewerState& state);
  /// The grey values as a volume to cast rays through; null: they are not shown.
  GpuVolume* volume(ViewerState& state);
  /// Both of these: false, and told, where there is no room for them.
  bool upload_values(ViewerState& state);
  void draw_pane(Workspace& at, const ViewPane& pane, PixelSize size, int side);

  const Gl& gl_;
  Renderer renderer_;
  GpuModel model_;
  GpuOverlay overlay_;
  OverlayChoice overlays_made_;
  std::optional<GpuValueGrid> values_;  // once they are shown
  std::optional<GpuVolume> volume_;     // of them
  Framebuffer picture_, other_half_;    // the second: of a split view
  Drawn drawn_;
  Pace pace_;
};

}  // namespace odontoscope
