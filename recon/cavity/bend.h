#pragma once
// How narrowly does a line bend?

#include <functional>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/mesh/vector.h"

namespace odontoscope::cavity {

struct Bend {
  double radius = 0;       // of the circle; infinite: the line is straight
  double uncertainty = 0;  // of the radius, from how well the circle fits; 0 if straight
};

/// The smallest radius among circles that fit a stretch of the line as well as it is known, each stretch as long as can
/// be: a noisy line has sharp bends everywhere over a short way, so that radii over a window of fixed length tell of
/// the noise. How well it is known is taken from the line itself: what short stretches, `width` times
/// limits::bend_stretch long, are off their circles. A stretch whose bow is not more than limits::bend_bow times that
/// is straight. Circles by G. Taubin, "Estimation of planar curves, surfaces and nonplanar space curves defined by
/// implicit equations", 1991, in the plane of the stretch. `line`: points about evenly apart. Precondition: width > 0.
/// `loose` (optional): how far the line may lie off at a place, to a side (unit), because it would be as central there:
/// where a canal is flat, nothing tells where along its section the line belongs. A stretch that bends that way is
/// known no better than that.
using Looseness = std::function<double(const Point3& at, const Direction& side)>;
Bend smallest_bend(const std::vector<Point3>& line, double width, const Looseness& loose = {});

}  // namespace odontoscope::cavity
