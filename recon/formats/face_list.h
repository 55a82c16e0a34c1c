#pragma once
// Faces of any number of corners, as files list them, cut into triangles. For the .cpp files of this room only.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "recon/mesh/half_edges.h"
#include "recon/mesh/meshes.h"

namespace odontoscope {

/// Collects faces. Triangles come out as they came in, in the order of the faces; a polygon gets as many places among
/// them as it will have triangles, which `cut_into` fills once all corners are known.
class FaceList {
 public:
  /// Corners in order, counter-clockwise seen from outside. Of more than three, those that repeat their neighbour are
  /// dropped. A face of fewer than three corners bounds nothing and is left out.
  void add(const std::vector<PointIndex>& corners);
  /// A strip of triangles: each but the first two corners makes one with the two before it, turned every other time.
  /// Those that name a corner twice only lead on and are left out.
  void add_strip(const std::vector<PointIndex>& corners);

  /// What they will be, polygons cut.
  std::size_t triangles() const { return triangles_.size(); }
  bool empty() const { return triangles_.empty(); }
  /// The largest corner named; 0 without faces.
  PointIndex largest_corner() const { return largest_corner_; }

  /// Makes them the triangles of `mesh`. Polygons are cut along diagonals between their own corners, so a surface that
  /// was closed and oriented stays so; cut_polygon.h says along which. Once only. Precondition: all corners are points
  /// of `mesh`.
  void cut_into(SurfaceMesh& mesh);

  /// What `cut_into` and `add` have to say, a line each; none if all faces were triangles.
  std::vector<std::string> remarks() const;

 private:
  struct Polygon {
    std::size_t first_triangle = 0, first_corner = 0;
    std::uint32_t corners = 0;
  };
  std::vector<Point3> places_of(const Polygon& polygon, const SurfaceMesh& mesh) const;
  void fill(const Polygon& polygon, const std::vector<std::array<std::uint32_t, 3>>& triangles,
            SurfaceMesh& mesh) const;
  const Polygon* parted_by(HalfEdge h, const SurfaceMesh& mesh) const;
  /// Two faces on the same four corners would be cut along the same diagonal, which then had four triangles.
  void turn_crowded_diagonals(SurfaceMesh& mesh) const;

  std::vector<Triangle> triangles_;
  std::vector<Polygon> polygons_;
  std::vector<PointIndex> corners_;
  PointIndex largest_corner_ = 0;
  std::size_t without_area_ = 0, bent_ = 0, fans_ = 0;
  double farthest_off_ = 0;
};

}  // namespace odontoscope
