#pragma once
// Which part of a volume is shown beside a model of it, or instead of one.

#include <memory>
#include <string>

#include "engine/app/volume_options.h"
#include "engine/scene/scene.h"
#include "engine/scene/value_grid.h"
#include "recon/input/contour_stack.h"
#include "recon/mesh/meshes.h"
#include "recon/radiograph/grey_anchors.h"
#include "recon/volume/volume.h"

namespace odontoscope::app {

/// Of all contours, mm. Precondition: there are any.
Box bounds_of(const ContourStack& stack);

/// Of the voxels that are denser than half way from air to dentine, mm. Precondition: there are any.
Box bounds_of_dense(const Volume& volume, const GreyAnchors& greys);

/// Grey values are seen a little way beyond surfaces.
Box with_margin(const Box& bounds, const Volume& volume);

/// Closed and facing outwards.
SurfaceMesh box_surface(const Box& box);

/// A volume of which nothing but its voxels is wanted.
struct VoxelsAlone {
  GreyAnchors greys;
  Box dense;                                // see bounds_of_dense
  std::shared_ptr<const ValueGrid> values;  // of that, and a margin
};

/// Throws as grey_anchors does. Precondition: no label map, whose values are no grey.
VoxelsAlone voxels_alone(const Volume& volume, const ValueGridLimits& limits);

/// Reads, crops and tells it. UsageError for words that need a surface, and for a label map, whose values are no grey.
VoxelsAlone voxels_alone(const std::string& file, const VolumeWords& words, const ValueGridLimits& limits,
                         Session& session);

}  // namespace odontoscope::app
