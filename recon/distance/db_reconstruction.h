#pragma once
// The DB engine as a whole: contours to surfaces by a distance field and marching cubes, with the artefacts that the
// method makes.
//
// After section 3.1 of "Qualitative analysis of two reconstruction techniques and their application in dentistry"
// (Journal of Electronic Imaging 9(4), 2000), where DB stands for distance-based. It is there to be compared with the
// DT engine (recon/delaunay); docs/distance.md tells what is to be seen. Its stages are free functions, so that a
// caller with sliders runs again only what changed: make_grid, sample_field, march, decimate, inspect.
//
// Unlike DT it knows no correspondence, no tetrahedra and no certificate of sections: a result is certified if every
// surface, as it is, was found to be a closed oriented manifold, and that alone.
//
// The same input gives the same bytes, on any number of threads.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/distance/decimate.h"
#include "recon/distance/defects.h"
#include "recon/distance/field.h"
#include "recon/distance/grid.h"
#include "recon/distance/marching_cubes.h"
#include "recon/input/validate.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {

struct DbOptions {
  GridOptions grid;
  FieldOptions field;
  CaseTable cases = CaseTable::classic;
  /// Nothing: no decimation. Its `triangles` are for all structures together, shared out in proportion; 0 as
  /// `largest_error` stands for limits::decimation_error of a grid spacing.
  std::optional<DecimateOptions> decimation;
  int threads = 0;  // 0: as many as the machine has
};

/// One structure's surface.
struct DbSurface {
  std::string structure;
  SurfaceMesh surface;                     // decimated if asked for
  SurfaceReport report;                    // of `surface`; its shells carry structure names
  SurfaceReport before;                    // of the surface as marched: the same report if it was not decimated
  std::optional<double> decimation_error;  // mm, as the library measures it
};

struct DbStageTime {
  std::string stage;
  double seconds = 0;
};

struct DbReconstruction {
  std::vector<DbSurface> surfaces;  // in order of first appearance of the structure
  Grid grid;
  std::size_t slices = 0, contours = 0, points = 0;  // of the input
  std::vector<DbStageTime> seconds;
  int threads = 1;
  bool certified = false;  // every surface is a closed oriented manifold
};

/// Validates `stack` (InputError), samples and marches every structure independently on one common grid. Throws
/// UsageError (see make_grid, march) and Cancelled.
DbReconstruction reconstruct_by_distance(const ValidStack& stack, const DbOptions& options = {},
                                         const Progress& progress = {});
/// Validates it first.
DbReconstruction reconstruct_by_distance(const ContourStack& stack, const DbOptions& options = {},
                                         const Progress& progress = {});

}  // namespace odontoscope
