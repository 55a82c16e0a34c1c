#pragma once
// Contour edges split until each is an edge of the Delaunay triangulation of the slice's points.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/delaunay/constrained.h"
#include "recon/input/contour_stack.h"

namespace odontoscope::delaunay {

/// Contours as points in one array, each with its follower.
struct Rings {
  Table<SlicePoint, Point2> points;
  std::vector<SlicePoint> first_point{SlicePoint(0)};

  Table<SlicePoint, SlicePoint> next() const {
    Table<SlicePoint, SlicePoint> follower(points.size());
    for (std::size_t c = 0; c + 1 < first_point.size(); ++c)
      for (const SlicePoint p : Indices(first_point[c], first_point[c + 1]))
        follower[p] = p + 1 < first_point[c + 1] ? SlicePoint(p + 1) : first_point[c];
    return follower;
  }
};

/// What is asked of each contour edge. Delaunay is less: of the two triangles beside the edge neither has the other's
/// corner in its circumcircle. It can be had wherever two numbers lie in a gap, while Gabriel edges along a gap must
/// end opposite each other to within its width squared over their length, which for needles is below the last place.
/// Constrained asks for nothing: no edge is split.
enum class Fineness { gabriel, delaunay, constrained };

struct Refinement {
  Rings& rings;
  Cdt& cdt;
  std::vector<SlicePoint>& order;
};

/// Refines `rings`, the contours of `slice` of one structure, and leaves their triangulation in `cdt`, points numbered
/// as in `rings`, and the order in which they were inserted. Throws InputError too-close (conform.h). `number` and
/// `source` name the slice in messages.
void refine(Fineness fineness, const Slice& slice, std::size_t number, const std::string& source,
            const Progress& progress, const Refinement& refinement);

}  // namespace odontoscope::delaunay
