#pragma once
// A model's triangles in a tree of boxes, so that rays and nearest points are found in microseconds.
//
// Made from a Model and independent of it afterwards: build it on another thread while frames go on, then only read it,
// from any number of threads. Lengths are metres relative to the model's origin, as in ModelPart, in double.

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "engine/scene/model.h"
#include "recon/core/progress.h"
#include "recon/mesh/box_tree.h"

namespace odontoscope {

struct TreeRay {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0, 0, -1};  // unit length
  double from = 0;                 // crossings nearer than this do not count
  double to = std::numeric_limits<double>::infinity();
};

/// Where a ray passes through a triangle.
struct Crossing {
  std::uint32_t part = 0, triangle = 0;  // as in Model::parts and ModelPart::indices / 3
  double distance = 0;
  bool front = true;  // the ray meets the side from which the triangle is counter-clockwise
};

struct NearestPoint {
  std::uint32_t part = 0, triangle = 0;
  glm::dvec3 point{0};
  double distance = 0;
};

class TriangleTree {
 public:
  TriangleTree() = default;
  /// Throws Cancelled. Stage "prepare picking". About 0.1 s for 100,000 triangles.
  explicit TriangleTree(const Model& model, const Progress& progress = {});

  /// The nearest crossing that `counts`, if any. A ray through an edge or a vertex that several triangles share never
  /// slips between them (Woop, Benthin, Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013).
  std::optional<Crossing> nearest(const TreeRay& ray, const std::function<bool(const Crossing&)>& counts) const;

  /// Calls `visit` for all crossings, in no particular order. A closed surface is passed as often in as out, also
  /// through its edges and vertices.
  void each(const TreeRay& ray, const std::function<void(const Crossing&)>& visit) const;

  /// The point of the triangles of those parts for which `counts` is true that lies nearest to `place`, if any is
  /// nearer than `most`.
  std::optional<NearestPoint> nearest_point(const glm::dvec3& place,
                                            const std::function<bool(std::uint32_t part)>& counts,
                                            double most = std::numeric_limits<double>::infinity()) const;

  /// Unit normal by winding; zero for a triangle without area.
  glm::dvec3 normal(std::uint32_t part, std::uint32_t triangle) const;

  /// The normal that the point is lit by: between those of the corners (see ModelPart), unit length. `place` lies on
  /// the triangle. Zero for a triangle without area.
  glm::dvec3 smooth_normal(std::uint32_t part, std::uint32_t triangle, const glm::dvec3& place) const;

 private:
  struct Corners {
    std::array<glm::vec3, 3> at, normals;
    std::uint32_t part, triangle;
  };
  /// Visits crossings in the order of the tree; `visit` returns how far the search still goes.
  /// Whether a ray that passes through an edge or a corner crosses the triangle.
  enum class Edges { count, pass };
  template <class Visit>
  void walk(const TreeRay& ray, Edges edges, Visit visit) const;

  BoxTree<glm::vec3> tree_;
  std::vector<Corners> triangles_;                    // leaf by leaf
  std::vector<std::vector<std::uint32_t>> place_of_;  // in triangles_, by part and triangle
};

}  // namespace odontoscope
