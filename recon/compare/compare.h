#pragma once
// The paper's comparison on any contours: DT, DB, and DB decimated, side by side.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "recon/compare/contour_fit.h"
#include "recon/core/progress.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/input/validate.h"
#include "recon/mesh/surface_distance.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {

struct CompareOptions {
  ReconstructOptions dt;
  /// Decimation for the third column; to the most possible if it says nothing.
  DbOptions db;
  /// Samples of each distance that is measured, a structure.
  DistanceOptions distance;
};

/// Of one structure.
struct ComparedSurface {
  std::string structure;
  SurfaceMesh surface;
};

/// How many structures have the pieces, handles and bubbles that the contours and DT's links between them imply, of
/// those of which that is known (DT found every slab of them as implied). A DB surface that is not a closed oriented
/// manifold has none of the three.
struct ImpliedTopology {
  std::size_t as_implied = 0, known = 0;
};

/// A picture of a method's model, for pages. Filled in by whoever can draw.
struct MethodPicture {
  std::vector<std::uint8_t> png;
  std::string caption;
};

/// How much of the model one sees through, of all pixels well within the outline of the closed one, from cameras all
/// around. Measured by whoever can draw.
struct SeenThrough {
  std::size_t cameras = 0;
  double culled = 0, two_sided = 0;  // shares: back faces left out, both sides drawn
};

/// One column.
struct ComparedMethod {
  std::string name;                       // "DT", "DB", "DB decimated"
  std::string made_by;                    // how, in a few words
  std::vector<ComparedSurface> surfaces;  // in order of first appearance of the structure
  SurfaceReport report;                   // of all structures' surfaces as one mesh
  bool certified = false;
  std::string verdict;  // of DT: what its certificate says in a line; DB has none
  ImpliedTopology topology;
  ContourFit fit;                          // of all structures, means weighted by length of contours
  double seconds = 0;                      // contours in memory to inspected surface; the least of the runs
  std::optional<std::size_t> peak_memory;  // bytes above what was there before
  std::optional<SeenThrough> seen_through;
  std::vector<MethodPicture> pictures;
};

/// Between two columns, structure by structure; means weighted by area.
struct ComparedPair {
  std::size_t first = 0, second = 0;
  SurfaceDistance distance;
};

struct Comparison {
  std::string source;  // of the stack
  std::size_t slices = 0, contours = 0, points = 0;
  std::vector<ComparedMethod> methods;
  std::vector<ComparedPair> pairs;
  Grid grid;
  CaseTable cases = CaseTable::classic;
  FieldKind field = FieldKind::hybrid;
  int threads = 1, runs = 1;
};

/// Validates `stack` (InputError). A method is run again, up to three times, while it takes less than a second, and its
/// least time counts. Stages are those of the engines and of surface_distance. Runs in arenas of its own with
/// `options.dt.threads`. Throws what the engines do. Times and memory apart, the result depends on nothing but the
/// input.
Comparison compare(const ValidStack& stack, const CompareOptions& options, const Progress& progress = {});
/// Validates it first.
Comparison compare(const ContourStack& stack, const CompareOptions& options, const Progress& progress = {});

/// A line of the table: what is measured, and its value for each method in words.
struct ComparisonRow {
  std::string what;
  std::vector<std::string> values;
};
std::vector<ComparisonRow> comparison_rows(const Comparison& comparison);

}  // namespace odontoscope
