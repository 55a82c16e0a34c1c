#pragma once
// The walls that a flying eye must not leave through: closed surfaces in a tree of boxes, in double precision.
//
// Winding does not matter: a point is inside where an odd number of walls lies between it and far away. Lengths are the
// user's millimetres. Independent of what it was made from; may be read from any number of threads.

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "engine/scene/model.h"
#include "recon/mesh/surface_tree.h"

namespace odontoscope {

class Walls {
 public:
  Walls() = default;
  /// Preconditions: indices in range, coordinates finite. Triangles without area are walls like any other.
  explicit Walls(const SurfaceMesh& surface);
  explicit Walls(const std::vector<const SurfaceMesh*>& surfaces);

  bool empty() const { return tree_.empty(); }
  std::size_t size() const { return tree_.size(); }
  const Box& bounds() const { return bounds_; }

  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    glm::dvec3 point{0};
  };
  /// The wall's point nearest to `place`, if any is nearer than `most`; otherwise `distance` is infinite. About a
  /// microsecond.
  Nearest nearest(const glm::dvec3& place, double most = std::numeric_limits<double>::infinity()) const;

  /// How far one sees from `eye` along `direction` (unit length); infinite where no wall is. By floating point: an eye
  /// on a wall may or may not see it.
  double free_distance(const glm::dvec3& eye, const glm::dvec3& direction,
                       double most = std::numeric_limits<double>::infinity()) const;
  /// All distances at which the half line meets a wall, ascending; an edge that triangles share counts once.
  std::vector<double> meetings(const glm::dvec3& eye, const glm::dvec3& direction) const;

  enum class Side { inside, outside, on_wall };
  /// Exact: by the signs of determinants of the coordinates as they are given. `on_wall` also where all of sixteen
  /// sight lines happen to touch an edge, which takes coordinates made for it.
  Side locate(const glm::dvec3& place) const;

  /// Does the straight way touch a wall? Exact; where way and triangle lie in one plane, `true` if their boxes meet.
  bool crosses(const glm::dvec3& from, const glm::dvec3& to) const;

 private:
  /// Visits triangles whose boxes the segment may meet; `visit` returns false to end.
  template <class Visit>
  void along(const glm::dvec3& from, const glm::dvec3& to, Visit visit) const;

  SurfaceTree tree_;
  Box bounds_;
};

/// The middle of the largest ball that fits inside, as far as a search from a grid of about `places` places finds it;
/// none if no such place is inside.
struct LargestClearance {
  glm::dvec3 at{0};
  double clearance = 0;
};
std::optional<LargestClearance> place_of_largest_clearance(const Walls& walls, int places = 4096);

/// The direction of `count` over the sphere in which one sees farthest; unit length. Looking into a place without
/// walls: the first one.
glm::dvec3 longest_free_direction(const Walls& walls, const glm::dvec3& eye, int count = 600);

}  // namespace odontoscope
