#pragma once
// What a section of a surface by a plane tells: its outline, and where there is material.

#include "recon/mesh/plane_section.h"

namespace odontoscope {

/// Without what one side alone has inside the other's material: where a model that goes on above ends flat below, the
/// plane cuts no boundary of it.
PlaneSection outline(const PlaneSection& section);

/// Is there material at this place of the plane, below it or above it? By the number of segments between the place and
/// far away, odd being inside, and the majority of seven directions, so that a crack hides at most some of them.
/// Orientation plays no part.
bool is_material(const PlaneSection& section, const Point2& place);

}  // namespace odontoscope
