#pragma once
// Closed contours as plain polygons, in plain doubles: for places and distances that are told, never for what decides.

#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope::delaunay {

using Ring = std::vector<Point2>;

/// Positive if counter-clockwise.
double signed_area(const Ring& ring);

/// Of what it encloses; its first point if that is nothing.
Point2 centroid(const Ring& ring);

bool encloses(const Ring& ring, Point2 p);

/// 0 if what they enclose overlaps, else the distance of the two. Cost: the product of their sizes.
double gap_between(const Ring& a, const Ring& b);

}  // namespace odontoscope::delaunay
