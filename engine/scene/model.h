#pragma once
// The geometry that a scene shows, as the graphics processor wants it: float, metres, relative to an origin of its own.
//
// This is the one place where millimetres become metres. `origin_mm` keeps float exact enough however far from zero the
// user's coordinates lie; cameras and section planes stay in the user's millimetres and are shifted by the same origin.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "recon/mesh/meshes.h"

namespace odontoscope {

inline constexpr double metres_per_mm = 0.001;
/// Edges sharper than this stay sharp. Molar fissures are round at the resolution of a scan; the rim of a flat cap is
/// not.
inline constexpr double default_crease_deg = 50;

struct NamedSurface {
  std::string structure;
  SurfaceMesh surface;
  /// The solid whose boundary it is part of; empty: it bounds one by itself. Cavities name the solid that they lie in,
  /// since only together do they say where material is.
  std::string solid = {};
  /// Wound as a cavity's wall is: towards the void.
  bool cavity = false;
};

/// A structure's triangles, counter-clockwise seen from outside the material. A vertex on a crease appears once per
/// side.
struct ModelPart {
  std::string structure;
  std::string solid;  // see NamedSurface; never empty
  bool cavity = false;
  double attenuation = 0;  // of X-rays at usual_kv by what a solid of this name is made of, 1/mm; 0: nobody knows. See
                           // recon/radiograph/tissue.h
  std::vector<glm::vec3> positions;        // metres, relative to the model's origin
  std::vector<glm::vec3> normals;          // unit length, one a position
  std::vector<std::uint32_t> indices;      // three a triangle, in the order of the surface's triangles
  std::vector<float> depths_mm = {};       // below the orifice of the canal that it walls, one a position; none: nobody
                                           // asked. See navigate/wall_depth.h
  std::vector<float> thicknesses_mm = {};  // of the wall, to its outside, one a position; none: nobody asked, or it is
                                           // no wall. See navigate/thickness_colours.h
  std::vector<glm::vec2> deviations =
      {};  // mm from the data's own surface, and their slope there, one a position; none: nobody asked. See deviation.h
};
/// In place of a distance where no surface of the data's is near.
inline constexpr float no_deviation = 1e9f;
/// Of a place that no canal passes.
inline constexpr float above_orifice = -1;

/// Of walls that tell how thick they are: lines are so much of a step of depth apart, and from `thickest_steps` lines
/// on walls have their own colour.
inline constexpr double thickness_line = 0.2;
inline constexpr double thickest_steps = 15;

struct Box {
  glm::dvec3 low{0}, high{0};
  glm::dvec3 centre() const { return 0.5 * (low + high); }
};

struct Model {
  std::vector<ModelPart> parts;
  glm::dvec3 origin_mm{0};
  Box bounds_mm;             // of all parts, in the user's coordinates
  double depth_step_mm = 1;  // from ring to ring of walls that tell their depth
  double thickness_step_mm() const { return thickness_line * depth_step_mm; }
  double radius_mm = 1;  // of the ball around bounds_mm's centre that holds everything; never 0
};

/// Precondition: indices in range, coordinates finite. Throws InputError "nothing-to-show" if no surface has a
/// triangle.
Model make_model(const std::vector<NamedSurface>& surfaces, double crease_deg = default_crease_deg);

}  // namespace odontoscope
