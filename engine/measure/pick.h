#pragma once
// What lies under a pixel? Answers as the picture does: hidden structures, culled back faces and what the section cut
// away are looked through, the section's cap is hit. Not supported: whether a translucent surface is too faint to be
// meant; see PickOptions.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "engine/measure/triangle_tree.h"
#include "engine/scene/scene.h"

namespace odontoscope {

/// In the user's coordinates.
struct Ray {
  glm::dvec3 origin_mm{0};
  glm::dvec3 direction{0, 0, -1};  // unit length
};

/// The line of view_direction through a place of the picture, counted in pixels from its upper left corner (the middle
/// of the first pixel is at 0.5, 0.5). Precondition: the camera passes `validate`, both sides of `size` are positive.
Ray ray_through(const Camera& camera, const glm::dvec2& pixel, const glm::dvec2& size);

struct PickOptions {
  /// Surfaces less opaque than this are looked through; those with no opacity at all always are.
  float least_opacity = 0;
};

struct Hit {
  std::string structure;
  std::size_t part = 0;                 // of the model
  std::optional<std::size_t> triangle;  // of the part; empty on the section's cap
  glm::dvec3 point_mm{0};
  glm::dvec3 normal{0};    // towards the eye, unit length; the triangle's own plane, not smoothed
  double distance_mm = 0;  // from the ray's origin
  bool front = true;       // false only if back faces are shown
};

/// What pick needs besides the scene. Made off the frame thread; see TriangleTree.
struct Pickable {
  explicit Pickable(const Model& model, const Progress& progress = {});

  struct Part {
    std::string structure, solid;
    double box_volume = 0;  // the cap of the smallest solid lies on top
  };
  TriangleTree tree;
  std::vector<Part> parts;  // the model's
  glm::dvec3 origin_mm{0};
};

/// The nearest visible point along the ray.
std::optional<Hit> pick(const Pickable& pickable, const Scene& scene, const Ray& ray, const PickOptions& options = {});

}  // namespace odontoscope
