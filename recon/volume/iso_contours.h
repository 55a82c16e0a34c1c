#pragma once
// Iso-contours of a volume, slice by slice: marching squares with linear interpolation.
//
// **Material is where the value is at least the threshold**, a pixel equal to it included. On a grid edge between a
// material pixel and another the contour runs where linear interpolation meets the threshold, but never closer to
// either pixel's centre than limits::grid_vertex_margin of the edge: so a pixel equal to the threshold is passed at
// that distance instead of in its centre, where contours would touch. In a cell with two material pixels across the
// diagonal the asymptotic decider (Nielson and Hamann 1991) says whether they are one region: whether the bilinear
// surface's saddle is at least the threshold. Where material touches the image's border the contour runs half a pixel
// outside the outermost centres, which is where the image ends. Points lie on the volume's lattice (lattice.h), the
// nearest of it to where interpolation meets the threshold.
//
// All contours of a level are closed, simple and pairwise disjoint, for any volume. A higher threshold's region lies
// within that of a lower one; their contours may coincide along the image's border and near pixels where both were held
// off the centre.
//
// Not supported: bands of values (a level has no upper bound), interpolation across slices, smoothing.

#include "recon/volume/contour_levels.h"

namespace odontoscope {

struct IsoLevel {
  double threshold = 0;
  std::string structure = "tooth";
};

/// Throws InputError nothing-crosses-iso if no voxel, or every voxel, is material at a level, and what validate_volume
/// and trace_levels throw. UsageError for a threshold that is not finite.
TracedContours iso_contours(const Volume& volume, const std::vector<IsoLevel>& levels, const TraceOptions& options = {},
                            const Progress& progress = {});

/// The same levels as tracers, for a stack that mixes them with labels. `range` is that of the volume, which must
/// outlive them.
std::vector<LevelTracer> iso_tracers(const Volume& volume, ValueRange range, const std::vector<IsoLevel>& levels);

}  // namespace odontoscope
