#pragma once
// Slices made ready: contours refined until each of their edges is Gabriel (its diametral circle holds no point), then
// triangulated, with the regions found.
//
// With Gabriel edges the Voronoi cell of a contour point meets no contour but its own two edges; that is what lets the
// slab walk decide "inside a region?" exactly, with one orientation test. Points are added on contours only, and
// rounded, so off the input edge by at most the last digits of a coordinate.
//
// Where a gap is so narrow that no double is near enough to where a Gabriel edge would have to end (needles, contours
// that all but touch), the slice's edges are only made Delaunay. All that is proven of a model holds then, too; but
// which regions lie over each other may be misjudged beside such a gap, by about its width, and so may a link that
// hangs on it.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/delaunay/planar.h"
#include "recon/input/contour_stack.h"

namespace odontoscope::delaunay {

/// Points and triangles sorted by region, so that a few regions of many are found without a look at all.
struct RegionLists {
  std::vector<std::uint32_t> first_point;  // of region r: points[first_point[r]] to points[first_point[r + 1]], ...
  std::vector<SlicePoint> points;          // ... ascending
  std::vector<std::uint32_t> first_triangle;
  std::vector<TriangleIndex> triangles;   // the same
  Table<SlicePoint, std::uint32_t> rank;  // of each point: its place in Planar::insertion_order
};

struct ConformedSlice {
  double z = 0;
  Planar planar;  // of all contours of one structure
  RegionLists by_region;
  std::vector<std::size_t> contour_number;   // of each contour kept here: its number in the slice's list
  std::vector<SlicePoint> first_point;       // points of contour c: [first_point[c], first_point[c+1])
  std::vector<std::uint32_t> outer_contour;  // of each region: its outer contour, counted here
  std::size_t steiner_points = 0;
  bool conforming = true;  // false: from `constrained`

  std::size_t regions() const { return outer_contour.size(); }
};

/// Preconditions: `slice` is validated and ordered (outer contours counter-clockwise, holes clockwise).
/// Throws InputError too-close where contours run nearer to each other than double precision can hold apart, or so
/// near, in so many places, that even the refinement to Delaunay edges passes limits::steiner_factor. `number` and
/// `source` name the slice in messages.
ConformedSlice conform(const Slice& slice, const std::string& structure, std::size_t number, const std::string& source,
                       const Progress& progress);

/// The slice as it is given, where `conform` refuses: its constrained Delaunay triangulation, without a point added.
/// Its slabs can only be blocks (block.h). Preconditions as for conform. Does not fail for a valid slice.
ConformedSlice constrained(const Slice& slice, const std::string& structure, std::size_t number,
                           const std::string& source, const Progress& progress);

/// The triangulation of the chosen regions' points alone; edges stay Gabriel or Delaunay, and the regions' own
/// triangles are the same as in `slice`. `chosen`: ascending. Regions keep their numbers. Takes no longer for being a
/// part of something large.
Planar part_of(const ConformedSlice& slice, const std::vector<std::uint32_t>& chosen);

}  // namespace odontoscope::delaunay
