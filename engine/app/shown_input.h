#pragma once
// What a picture is made of: any file that has, or can be made into, surfaces.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/dt_options.h"
#include "engine/app/proven.h"
#include "engine/app/volume_options.h"
#include "engine/scene/deviation.h"
#include "engine/scene/model.h"
#include "engine/scene/overlay.h"
#include "engine/scene/value_grid.h"
#include "recon/radiograph/grey_anchors.h"

namespace odontoscope::app {

/// What a picture shows, and what its overlays are made from: contours and tetrahedra of whatever was reconstructed,
/// the faulty edges of any surface.
struct Shown {
  odontoscope::Model model;
  OverlaySource overlays;
  std::vector<NamedSurface> surfaces;       // that the model was made from
  std::shared_ptr<const ValueGrid> values;  // of the volume that it came from; null for any other input
  std::optional<GreyAnchors> greys;         // what they mean, if they are to be shown
  std::vector<IsoOf> isos;                  // and the values at which surfaces were taken
  bool only_voxels = false;                 // the surface is but the box of them

  using Proven = app::Proven;
  std::optional<Proven> proven;
  std::optional<std::size_t>
      slices;  // given ones that it was made from, here or by who wrote the mesh; empty: not known
};

/// A contour stack is reconstructed, and so is a volume if `words` say where its surface lies; GLB, STL, PLY and OBJ
/// are taken as they are, told by their content. With `words.voxels` a volume needs no surface: the model is then the
/// box of what is denser than air, called "volume". Empty `file`: the sample molar. Throws as the readers and the
/// engine do; UsageError for `dt` with a mesh. `check` is shown contours before a model is made of them, and may throw.
using StackCheck = std::function<void(const ContourStack&)>;
Shown shown_from(const std::string& file, const VolumeWords& words, const DtWords& dt, Session& session,
                 const StackCheck& check = {});

}  // namespace odontoscope::app
