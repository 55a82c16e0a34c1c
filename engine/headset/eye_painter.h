#pragma once
// Draws what both eyes see of a visit, with the renderer of every other picture.

#include <functional>
#include <memory>
#include <optional>

#include "engine/gpu/program.h"
#include "engine/headset/headset.h"
#include "engine/headset/visit.h"
#include "engine/headset/volume_pace.h"
#include "engine/render/renderer.h"

namespace odontoscope {

struct EyeQuality {
  /// Each costs much more than it does on a screen: two eyes, ninety times a second.
  int side = 1;
  bool occlusion = false;
  /// Seconds from a picture to the next, where the headset does not say.
  double beat = 1.0 / 90;
  Background background{Background::Kind::plain, colour_of(0x5b6771), colour_of(0x5b6771)};
};

class EyePainter {
 public:
  /// Uploads the model. The context of `gl` is current now and at every call, and outlives this. `values`: those of the
  /// volume that it came from, uploaded when a scene shows them first; null: there are none. Throws GraphicsError.
  EyePainter(const Gl& gl, const ShaderLibrary& shaders, const Model& model, const EyeQuality& quality = {},
             std::shared_ptr<const ValueGrid> values = nullptr);

  /// Another model of the same volume from now on.
  void take(const Model& model);

  /// Draws more over the picture of an eye: after its edges were darkened, since what stands in the room holds the
  /// eyes. Not while all is dark.
  using Over = std::function<void(const EyeView&, const Target&)>;
  /// Into the targets, one an eye. What both eyes see alike (scene, hands) is made once. `hidden`: what the lenses
  /// hide, one an eye or none at all. A volume is cast as finely as the headset's beat (seconds; 0: the quality's)
  /// leaves time for. Returns what the depths mean that are left in targets that keep them.
  Depths draw(const Visit& visit, const HeadsetInput& input, const VisitWorld& world, std::span<const EyeView> eyes,
              std::span<const Target> targets, const Over& over = {}, std::span<const HiddenCorners* const> hidden = {},
              double beat = 0);

  /// How coarse rays are now; 1: as on the desktop.
  double coarseness() const { return pace_.coarseness(); }

  /// Fills the target with the middle of an eye's picture.
  static void mirror(const Gl& gl, const Target& eye, const Target& target);

 private:
  /// The hands' rays, and how large the tooth is.
  void show_marks(const Visit& visit, const HeadsetInput& input, const VisitWorld& world);
  const GpuHidden* masked(std::size_t eye, const HiddenCorners& corners);
  /// Null unless the scene shows it, there is one, and the driver has room.
  GpuVolume* volume_of(const Scene& scene);
  void ease(const Visit& visit, const FieldOfView& field, const Target& target) const;

  const Gl* gl_;
  EyeQuality quality_;
  Renderer renderer_;
  GpuModel model_;
  std::shared_ptr<const ValueGrid> values_;
  std::optional<GpuValueGrid> gpu_values_;  // in this order: the volume casts through the values
  std::optional<GpuVolume> volume_;
  VolumePace pace_;
  glm::vec3 low_, high_;  // the model's own box
  GpuOverlay marks_;
  /// Of an eye, as last uploaded.
  struct Mask {
    HiddenCorners corners;
    GpuHidden gpu;
  };
  std::vector<Mask> masks_;
  Program ease_;
  GlObject no_vertices_;
};

}  // namespace odontoscope
