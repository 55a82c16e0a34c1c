#pragma once
// Named, awkward stacks of contours. Each says in its comment what makes it awkward and, where it is not obvious, what
// the solid must be. Units are millimetres; slices are `spacing` apart from z = 0 upwards; nothing here is random.

#include <cstddef>
#include <vector>

#include "recon/input/contour_stack.h"

namespace odontoscope::test {

inline constexpr double spacing = 0.5;
inline constexpr int round_points = 64;

using Ring = std::vector<Point2>;

// --- single contours, counter-clockwise ------------------------------------------------------------------------------
/// Regular polygon; nearly cocircular points, as exact predicates must tell apart.
Ring regular_polygon(int corners, double radius, Point2 centre = {}, double first_angle = 0);
Ring circle(double radius, Point2 centre = {});
Ring ellipse(double half_x, double half_y, Point2 centre = {});
Ring rectangle(Point2 low, Point2 high);
/// The square [low, low + side]^2 with a point at every lattice place along its border: full of exactly cocircular
/// points.
Ring lattice_square(int low_x, int low_y, int side);
/// A ring of the given thickness that is open over +-half_mouth (radians) about the +x direction.
Ring c_shape(double outer, double inner, double half_mouth);
/// 2 * spikes points, alternately on the two radii.
Ring star(int spikes, double tip, double notch, double first_angle = 0);
/// A back with `teeth` thin prongs along +y.
Ring comb(int teeth, double length, double thickness);

// --- putting them together -------------------------------------------------------------------------------------------
ContourStack stack_of(const std::vector<std::vector<Ring>>& slices);
ContourStack moved(ContourStack stack, Point2 by);
ContourStack scaled(ContourStack stack, double factor);
/// About the z axis, by radians: coordinates that were round no longer are.
ContourStack turned(ContourStack stack, double angle);

// --- stacks ----------------------------------------------------------------------------------------------------------
/// Two equal discs, one moved by `radii` radii.
ContourStack shifted_circles(double radii);
/// A tube: the hole must run through.
ContourStack annulus_over_shifted_annulus();
/// A cup: the hole closes just beyond its own slice.
ContourStack annulus_over_disc();
/// One canal that forks in two.
ContourStack annulus_over_disc_with_two_holes();
ContourStack one_over(int count);
/// Long ellipses along x below and along y above: four crossings round one window.
ContourStack two_over_two_crosswise();
/// A round canal that drifts by half its radius a slice, through four slices.
ContourStack drifting_canal();
/// The same square lattice ring twice: every point of one cell cospherical with those above.
ContourStack identical_lattice_squares();
ContourStack lattice_square_over_shifted(int by_x, int by_y);
ContourStack polygon_over_turned_polygon(int corners);
/// A contour with an empty slice on both sides.
ContourStack alone_in_the_middle();
/// A contour in the first slice only.
ContourStack alone_at_the_end();
/// A column through three slices, and beside it a contour in the middle slice only.
ContourStack alone_beside_a_column();
/// A column of two slices, an empty one, a column of two.
ContourStack empty_slice_between();
/// Four concentric circles in each of three slices: a tube in a tube.
ContourStack islands_nested_four_deep();
/// The island stands in the mouth of a C and must not grow onto it.
ContourStack c_with_island();
/// Disc, annulus, C, annulus, disc: what looks like a closed hole in two slices opens through the mouth.
ContourStack hole_that_opens_outside();
/// Two roots, then a ring, then a disc: the ring's hole opens downwards between the roots.
ContourStack hole_between_roots();
ContourStack star_over_turned_star();
ContourStack comb_over_mirrored_comb();
/// Slivers, a thousandth as wide as long, crossing.
ContourStack crossing_slivers();
/// A triangle with a triangular hole: every external edge is a contour edge, so no edge betrays that the hole is void.
ContourStack triangle_with_triangular_hole();
/// A hole of three points with solid material in the next slice.
ContourStack triangular_hole_under_disc();
/// An outer triangle with a hole of three points, alone under an empty slice: a plate with a hole.
ContourStack triangular_ring_alone();
/// Two regions side by side, `gap` apart, their points not opposite each other.
ContourStack close_neighbours(double gap);
/// Enamel's margin: a thin ring that begins on one side only, over a thin C. Its free part must not lean over to the
/// C's ends.
ContourStack ring_over_crescent();
/// A thin ring between two Cs that are open on opposite sides and overlap nowhere: each part of it hangs free on one
/// side.
ContourStack ring_between_crescents();
/// A thin C with nothing below or above it but a stub: both its arms are free on both sides, so that one must stay.
ContourStack crescent_between_stubs();
/// A square whose border has a bump and a notch, each `size` wide and high.
ContourStack tiny_features(double size);

/// Every stack above in its default form, with a name for messages.
struct NamedStack {
  const char* name;
  ContourStack stack;
};
std::vector<NamedStack> all_shapes();

}  // namespace odontoscope::test
