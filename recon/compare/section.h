#pragma once
// A triangle surface cut by the planes of slices.

#include <vector>

#include "recon/core/geometry.h"
#include "recon/mesh/meshes.h"

namespace odontoscope {

struct SectionSegment {
  Point2 from, to;
};

/// The cut by one plane, as the surface is just below it and just above it; one segment a triangle, in order of the
/// triangles. They differ where the model begins, ends or has a flat piece in the plane. A side of a triangle that lies
/// in the plane is given as it is, without rounding. For any surface, closed or not: what is missing in the surface is
/// missing in the section.
struct PlaneSection {
  std::vector<SectionSegment> below, above;
};
std::vector<PlaneSection> sections(const SurfaceMesh& surface, const std::vector<double>& heights);

/// Without what one side alone has inside the other's material: where a model that goes on above ends flat below, the
/// plane cuts no boundary of it.
PlaneSection outline(const PlaneSection& section);

/// Is there material at this place of the plane, below it or above it? By the number of segments between the place and
/// far away, odd being inside, and the majority of seven directions, so that a crack hides at most some of them.
/// Orientation plays no part.
bool is_material(const PlaneSection& section, const Point2& place);

}  // namespace odontoscope
