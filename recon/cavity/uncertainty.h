#pragma once
// How far may a figure be off, because the tooth was cut into slices? Bounds by geometry, not by statistics: noise of the scan and what was drawn wrongly come on top.

#include "recon/cavity/anatomy.h"

namespace odontoscope::cavity {

/// The distance of slices that a wall was made from: the median gap between the heights of its vertices. Of a wall whose vertices lie at heights of their own (a
/// marched one) the median length of its edges.
double slice_spacing_of(const SurfaceMesh& wall);

/// With slices h apart and contour sides e long, on a canal of width w:
/// - ends lie within a slice: a length is known to h;
/// - a width changes by dw/ds between slices, walls that lean by t from the slices' normal z are cut short by h sin^2 t, and a polygon in a circle is too
///   narrow by e^2 / 2w: a width is known to h/2 (|dw/ds| + sin^2 t) + e^2 / 2w, the mean one to the mean of that;
/// - angles to two such widths across a third of the length; bends to how well the circle fits; walls to a width of the canal;
/// - volumes and areas to what length and width make of them; sections near the apex to what a shift by h adds.
CanalUncertainty uncertainty_of(const MeasuredCanal& canal, const CanalShape& shape, const CentreLine& line, const SurfaceMesh& wall, double spacing);

}  // namespace odontoscope::cavity
