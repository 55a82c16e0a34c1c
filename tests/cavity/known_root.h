#pragma once
// Roots whose canals are known, since they are formulas: what the anatomy tells of their slices can be held against
// them.
//
// A ball of a chamber about the origin and one root below it, in a block with round ends; canals are round tubes of
// evenly changing width about lines in or near the plane y = 0. All of it may be stretched across that plane (oval
// canals: lines, lengths and widest balls stay as they are), and is then spun about z and tilted.

#include <optional>
#include <string>
#include <vector>

#include "recon/cavity/cavity.h"
#include "recon/core/geometry.h"
#include "recon/input/contour_stack.h"

namespace odontoscope::test {

struct KnownCanal {
  std::vector<Point3> axis;                   // from the chamber's centre to the middle of its round end
  double radius_above = 0, radius_below = 0;  // at the chamber's centre, at the end
  double aside = 1;  // so many times as wide in the plane y = 0, at least 1: oval, with the long side where it bends to
};

/// A round tube that ends somewhere in the block.
struct SideCanal {
  Point3 from, end;
  double radius = 0;
};

/// A plate in the plane y = 0.
struct Wing {
  double thick = 0, left = 0, right = 0, low = 0, high = 0;  // x, z
};

/// A section like a C about the z axis, open to -x, all the way down: one thickness, with rounded rims.
struct Gutter {
  double radius = 0, thick = 0, half_angle_deg = 0, low = 0;
};

struct KnownRoot {
  std::string kind = {};  // "type II", "arc 8 mm"
  std::string vertucci = {};
  std::vector<std::size_t> sections = {};
  std::vector<KnownCanal> canals = {};
  std::vector<SideCanal> accessory = {};
  std::optional<Wing> wing = {};
  std::optional<Gutter> gutter = {};
  std::string isthmus = {};         // Hsu and Kim's type of the wing; empty: none
  std::optional<double> bend = {};  // radius, infinite if straight; nothing: not known
  bool alone = false;               // each canal by itself from orifice to end: sections and widths are known all along
  double chamber = 1.3, oval = 1;   // radius; stretch along y
  double block = 3;                 // radius
  double block_low = -13.5, block_high = 1;  // the middles of its round ends, z
  double spin_deg = 0, tilt_deg = 0;
};

/// The dentine, on planes so far apart: the block without the void.
ContourStack slices_of(const KnownRoot& root, double spacing);
/// The void's wall without any slices, marched on a grid.
Cavity void_of(const KnownRoot& root, double grid);
/// From the root's own axes to those of the slices.
Point3 as_it_lies(const KnownRoot& root, const Point3& own);

/// Of one canal, by formula. Lengths along its axis.
struct KnownFigures {
  Point3 orifice, end;  // as it lies
  double length = 0;    // from where it leaves the chamber's ball to the wall at its end, or to the block's outside
  double narrowest = 0, mean_width = 0, schneider_deg = 0, thinnest_wall = 0;
  std::vector<double> apical_width, apical_area;  // at 1, 2, 3, 4 mm
  std::vector<double> third_volume, third_area;
};
KnownFigures figures_of(const KnownRoot& root, const KnownCanal& canal);

}  // namespace odontoscope::test
