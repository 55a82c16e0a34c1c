#pragma once
// How far may a figure be off, because the tooth was cut into slices? Bounds by geometry, not by statistics: noise of
// the scan and what was drawn wrongly come on top.

#include <vector>

#include "recon/cavity/anatomy.h"

namespace odontoscope::cavity {

/// The distance of slices that a wall was made from: the median gap between the heights of its vertices. Of a wall
/// whose vertices lie at heights of their own (a marched one) the median length of its edges.
double slice_spacing_of(const SurfaceMesh& wall);

/// What slices and contours leave open.
struct SliceKnowledge {
  double spacing = 0;  // of slices
  double outer_side =
      0;  // nineteen in twenty of the edges that the tooth's outside has in planes of constant z are shorter
  double chamber = 0;  // its radius
  std::vector<Cavity::Mouth> mouths = {};
};
SliceKnowledge slice_knowledge(const SurfaceMesh& outside, double spacing, double chamber_radius,
                               const std::vector<Cavity::Mouth>& mouths);

/// With slices h apart and contour sides up to e long (nineteen in twenty of those about the canal), on a canal of
/// width w:
/// - an end lies within a slice, an orifice on a point of the line: a length is known to h and the distance of points;
/// one that ends in a mouth also to the mouth's width, for
///   a canal that comes out obliquely is told to the last plane of constant z that material lies all round it in;
/// - a width changes by dw/ds between slices, walls that lean by t from the slices' normal z are cut short by h sin^2
/// t, a polygon in a circle is too
///   narrow by e^2 / 2w, and the widest ball is found to limits::ball_fineness: a width is known to h/2 (|dw/ds| +
///   sin^2 t) + e^2 / 2w and that, the mean one to the mean of it, the narrowest one besides to how far it stands out
///   from those within a width of it;
/// - Schneider's angle to what it changes by where the orifice or the line lies so far off, and to two such widths
/// across a third of the length;
/// - bends to how well the circle fits; walls to a width of the canal and to how far the tooth's polygon lies inside
/// its round;
/// - volumes and areas to what length and width make of them, the coronal area also to the chamber's wall about the
/// orifice; sections near the apex to what a shift by h adds.
CanalUncertainty uncertainty_of(const MeasuredCanal& canal, const CanalShape& shape, const CentreLine& line,
                                const SurfaceMesh& wall, const SliceKnowledge& known);

}  // namespace odontoscope::cavity
