#pragma once
// Scenes of one model as pictures, one after the other: from all around, along a tour, on a sheet.

#include <cstddef>
#include <optional>

#include "engine/app/command.h"
#include "engine/app/contact_sheet.h"
#include "engine/app/scene_words.h"
#include "engine/app/shown_input.h"
#include "engine/app/tour_film.h"
#include "engine/view/offscreen.h"

namespace odontoscope::app {

/// Draws one scene after the other, all of one model, and all with the overlays, volume and cap of the one that it was
/// made for. What is given outlives it; the context is current.
class Painter {
 public:
  Painter(const PictureOptions& picture, const Gl& gl, Renderer& renderer, const Shown& shown, const Scene& scene,
          Session& session);

  /// The `number`th of `count`. Throws Cancelled.
  Image draw(const Scene& scene, std::size_t number, std::size_t count);

 private:
  PictureOptions picture_;
  const Gl& gl_;
  Renderer& renderer_;
  const Shown& shown_;
  Session& session_;
  GpuModel gpu_model_;
  GpuOverlay overlay_;
  bool ct_;
  GpuValueGrid values_;
  std::optional<GpuVolume> volume_;
};

/// The camera led round the axis of the tooth, through its target: the `number`th of `count` places all around.
Camera turned(const Camera& camera, std::size_t number, std::size_t count);

/// When the `number`th of `count` pictures of a tour is taken, seconds: the first at its start, the last at its end.
double moment(const Film& film, std::size_t number, std::size_t count);

/// The tour as one picture, with words under each of its parts. Precondition: not too large (see refuse_too_large).
Image sheet_of(const Shown& shown, const Scene& scene, const Film& film, const SheetSize& size, Painter& painter);

/// UsageError for a cap where nothing is cut open.
void refuse_cap_without_section(const SceneWords& words, const Scene& scene);

}  // namespace odontoscope::app
