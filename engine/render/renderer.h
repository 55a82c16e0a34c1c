#pragma once
// Draws a scene as seen by any number of eyes. The only state kept between frames are programs and buffers.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "engine/gpu/shader_library.h"
#include "engine/raycast/volume_pass.h"
#include "engine/render/background_pass.h"
#include "engine/render/cap_pass.h"
#include "engine/render/compose_pass.h"
#include "engine/render/depth_pass.h"
#include "engine/render/film_pass.h"
#include "engine/render/gpu_model.h"
#include "engine/render/hidden_pass.h"
#include "engine/render/line_pass.h"
#include "engine/render/occlusion_pass.h"
#include "engine/render/resolve_pass.h"
#include "engine/render/surface_pass.h"
#include "engine/scene/scene.h"

namespace odontoscope {

/// One eye and the part of the picture that shows what it sees.
struct Pane {
  View view;
  Target target;
  const GpuHidden* hidden = nullptr;  // of it; null: nothing. Background is shown there
};

struct RenderOptions {
  /// Samples a pixel along one axis: 1, 2 (4 samples), 3 (9), 4 (16).
  int side = 2;
  /// Rays of a volume: through every sample; or, where those around it saw alike, not (engine/raycast/volume_pass.h).
  /// As usual with 4 samples a pixel not, else through every one.
  enum class Rays { as_usual, every, few };
  Rays rays = Rays::as_usual;
};

/// Translucent surfaces that are drawn one behind the other at a pixel; the rest are left out. Seen from outside, a
/// tooth of three structures has six.
inline constexpr int most_layers = 16;

/// Samples in all. The buffers take 104 bytes for each, so that this many fill 5 GB; beyond, a driver that draws in
/// software would take the whole memory of the machine before it fails.
inline constexpr std::size_t most_samples = 48'000'000;

/// Throws GraphicsError "picture-too-large" if the driver or `most_samples` forbids such a picture.
void refuse_undrawable(const Gl& gl, PixelSize size, const RenderOptions& options);

class Renderer {
 public:
  /// The context of `gl` is current now and at every call, and outlives this.
  Renderer(const Gl& gl, const ShaderLibrary& shaders);

  /// Two panes are a headset, four a split screen. `overlay` null: none; `values` null: caps show the material;
  /// `volume` null: scene.volume shows surfaces, or instead of a radiograph the film of the model, if anything is known
  /// of its tissues. Throws GraphicsError as `refuse_undrawable` does.
  void draw(const GpuModel& model, const Scene& scene, std::span<const Pane> panes, const RenderOptions& options = {},
            const GpuOverlay* overlay = nullptr, const GpuValueGrid* values = nullptr, GpuVolume* volume = nullptr);

 private:
  /// What the passes draw one pane into.
  struct Buffers {
    Layer opaque, peeled[2];
    Framebuffer occlusion, picture;
    PixelSize size;
    GlObject any_drawn;
  };
  /// A pane that is being drawn.
  struct Work {
    FramePlan plan;
    const Pane* pane = nullptr;
    const Buffers* buffers = nullptr;
    const GpuVolume* volume = nullptr;  // null: it is not shown
    const VolumeLook* volume_look = nullptr;
    bool every_ray = false;
    const Layer* before = nullptr;  // of the translucent layers, the last one
    bool more = false;              // there may be another
    bool depth_kept = false;
  };
  static bool has_surfaces(const Work& work);
  const Buffers& buffers_for(PixelSize size, std::size_t number);
  /// Panes that are drawn in step: while the driver draws a layer of one, the next one's is prepared, and nobody waits
  /// for the answer whether there was any.
  void draw_in_step(std::span<Work> works, const Background& background);
  void begin(Work& work);
  /// What the volume has to show behind `before` (null: from the eye on) and before `layer` (null: before the opaque
  /// surfaces).
  void cast_between(const Work& work, const Layer* before, const Layer* layer);
  void keep_depth(Work& work, const Layer* first) const;
  /// The short way, for what needs no layers: opaque surfaces without ambient occlusion, one sample a pixel.
  /// Of the model, without a volume.
  void draw_film(const GpuModel& model, const Scene& scene, std::span<const Pane> panes, const RenderOptions& options);
  void draw_finished(const FramePlan& plan, const Background& background, const Pane& pane);
  void add_layer(const FramePlan& plan, const Buffers& buffers, const Layer& layer) const;

  const Gl* gl_;
  BackgroundPass background_;
  SurfacePass surfaces_;
  CapPass caps_;
  LinePass lines_;
  OcclusionPass occlusion_;
  ComposePass compose_;
  ResolvePass resolve_;
  DepthPass depth_;
  HiddenPass hidden_;
  VolumePass volume_;
  FilmPass film_;
  std::vector<std::unique_ptr<Buffers>> buffers_;
  Framebuffer finished_;
};

}  // namespace odontoscope
