#pragma once
// Voids whose centre lines are known, as walls: marched from exact distances, wound as the wall of a cavity.

#include <functional>
#include <string>
#include <vector>

#include "recon/cavity/cavity.h"
#include "recon/core/geometry.h"

namespace odontoscope::test {

/// Distance to the void's wall, negative in the void. The box must hold the void with some room.
using Distance = std::function<double(const Point3&)>;
Cavity void_of(const Distance& distance, const Point3& low, const Point3& high, double grid);

/// All within `radius` of a polyline.
double tube_distance(const Point3& p, const std::vector<Point3>& axis, double radius);
double ball_distance(const Point3& p, const Point3& centre, double radius);

/// An arc in the plane y = 0 from (radius, 0, 0) through `angle` towards -z, as a fine polyline.
std::vector<Point3> arc(double radius, double angle);

Cavity straight_tube(double length, double radius);
Cavity bent_tube(double bend, double angle, double radius);
Cavity ring(double bend, double radius);
/// Three legs from the origin in the plane y = 0, 120 degrees apart, one of them up.
Cavity y_shape(double leg, double radius);

/// A round chamber about the origin with three straight canals down, each from its middle to one of `ends`.
struct ThreeCanals {
  double chamber = 1.8;
  std::vector<Point3> ends{{-3, 0.4, -9}, {2, 2, -8}, {2.2, -2, -7}};
  std::vector<double> radii{0.5, 0.45, 0.4};
};
Cavity three_canals(const ThreeCanals& shape = {});

/// A round chamber about the origin and one root below it, with canals of one width as Vertucci's types have them.
/// Canals that meet share the rest.
struct RootShape {
  std::string type;  // "I" to "VIII"
  std::vector<std::size_t> sections;
  std::vector<std::vector<Point3>> canals;  // axes, from the chamber's centre
  double chamber = 1.3, radius = 0.35;
};
/// Precondition: one of the eight types. `uneven`: second canals bulge farther out than first ones, so that no way is
/// as long as another.
RootShape root_of_type(const std::string& type, double uneven = 1.15);
Cavity void_of_root(const RootShape& shape);

}  // namespace odontoscope::test
