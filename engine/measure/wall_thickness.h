#pragma once
// How thick is the wall here?

#include <glm/vec3.hpp>
#include <optional>

#include "engine/measure/pick.h"

namespace odontoscope {

/// Two answers, since no one definition serves: the first is what a calliper at right angles to the surface would tell,
/// the second what fits inside; they agree on a plate and on a ball.
struct WallThickness {
  /// From the point straight into the material to the next surface of the same solid. Straight is against the smoothed
  /// normal, which is that of the curved surface that the triangles stand for; creases stay sharp (default_crease_deg).
  double along_normal_mm = 0;
  glm::dvec3 opposite_mm{0};  // where that is
  /// Diameter of the largest ball inside the solid that has its centre between the point and `opposite_mm`. Never more
  /// than along_normal_mm; much less where the wall is a wedge or the far side is slanted. (The ball that touches the
  /// surface in the point itself would be tiny beside every ridge of a triangulated surface.)
  double largest_ball_mm = 0;
  glm::dvec3 ball_centre_mm{0};
};

/// At the hit of a triangle, of the solid that the triangle bounds; hidden surfaces count, sections do not. Nothing on
/// a cap, where the normal meets no further surface (the solid is not closed), or where the triangle has no area. The
/// ball is found to within a thousandth of along_normal_mm. A few hundredths of a millisecond to a millisecond.
std::optional<WallThickness> wall_thickness(const Pickable& pickable, const Hit& hit);

/// Straight line between two points, mm.
double distance_between_mm(const Hit& a, const Hit& b);

}  // namespace odontoscope
