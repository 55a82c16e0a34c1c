#pragma once
// Which closed ways through a void go round one of its handles?
//
// Of a closed surface of genus g there are 2g closed ways on it that all others are made up of (found by two spanning
// trees, one of vertices and one of triangles that does not cross the first; D. Eppstein, "Dynamic generators of
// topologically embedded graphs", 2003). A closed way through the void can be drawn together to a point if, and only
// if, it is linked with none of them (Alexander's duality). How often two closed ways are linked is counted where one
// passes over the other, seen from some direction: a sum over pieces, so that each piece of a way has its share.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "recon/mesh/meshes.h"
#include "recon/mesh/vector.h"

namespace odontoscope::cavity {

/// 2g closed ways along edges, as vertices, the first not repeated. Precondition: a closed, connected, oriented
/// manifold.
std::vector<std::vector<PointIndex>> loops_on_surface(const SurfaceMesh& surface);

class Linking {
 public:
  /// Precondition as above. Keeps what it needs.
  explicit Linking(const SurfaceMesh& wall);

  std::size_t loops() const { return loop_count_; }

  /// What the straight piece from a to b adds to the linking with each loop, all in one number: loop i counts times a
  /// fixed, odd number. The sum over a closed way is 0 if it is linked with none; that it is 0 otherwise takes a
  /// coincidence of one in 2^60. Modulo 2^64.
  std::uint64_t contribution(const Point3& a, const Point3& b) const;

  /// The same for a closed way (first point not repeated), loop by loop.
  std::vector<std::int64_t> linked(const std::vector<Point3>& closed_way) const;

 private:
  struct Edge {
    Point3 from, to;  // turned
    std::uint32_t loop;
  };
  /// Tells each crossing's loop and sign.
  template <class Tell>
  void crossings(const Point3& a, const Point3& b, Tell tell) const;
  std::size_t column(double x) const;
  std::size_t row(double y) const;

  std::size_t loop_count_ = 0;
  std::vector<Edge> edges_;
  // Seen from that direction: a grid of the edges' boxes.
  double low_x_ = 0, low_y_ = 0, cell_ = 1;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> first_;  // of each cell in
  std::vector<std::uint32_t> in_cell_;
};

}  // namespace odontoscope::cavity
