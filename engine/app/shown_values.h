#pragma once
// Which part of a volume is shown beside a model of it, or instead of one.

#include "engine/scene/scene.h"
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

/// UsageError where nothing but voxels is wanted of a label map, whose values are no grey.
void refuse_labels_as_greys(const Volume& volume, const std::string& file);

}  // namespace odontoscope::app
