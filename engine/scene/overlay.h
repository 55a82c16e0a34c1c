#pragma once
// What lies over the picture besides surfaces: slice contours, faulty edges, the tetrahedra of one slab.
//
// An Overlay is geometry, as a Model is; what of it is shown stands in Scene::overlays. Coordinates are metres relative
// to the model's origin.

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "engine/scene/model.h"
#include "engine/scene/scene.h"
#include "recon/input/contour_stack.h"
#include "recon/mesh/meshes.h"

namespace odontoscope {

/// Told apart by lightness and hue in every kind of colour vision. `measure` is for the marks of whoever measures.
enum class LineKind { contour, boundary_edge, non_manifold_edge, misoriented_edge, measure };

/// Lines of one kind; one whose ends are equal is a round dot. Shown while its structure is; without a structure
/// always.
struct LineSet {
  LineKind kind = LineKind::contour;
  std::string structure;
  std::vector<glm::vec3> points;  // two a line
};

/// The tetrahedra of one structure in one slab, each shrunk towards its centre, as closed outward oriented surfaces.
struct SlabPart {
  ModelPart surface;  // its normals are flat
  std::size_t tetrahedra = 0;
};

struct Overlay {
  std::vector<LineSet> lines;
  std::vector<SlabPart> slab;
};

/// What overlays are made from; whatever is unknown is empty (a mesh file has neither contours nor tetrahedra).
struct OverlaySource {
  ContourStack contours;
  struct Solid {
    std::string structure;
    TetraMesh tetrahedra;
  };
  std::vector<Solid> solids;  // reconstructed from `contours`
  std::vector<LineSet> faulty_edges;

  /// Between neighbouring slices; 0 without tetrahedra.
  std::size_t slabs() const { return solids.empty() || contours.slices.empty() ? 0 : contours.slices.size() - 1; }
};

/// Edges with one triangle, with more than two, and with two that run through it the same way (see SurfaceReport);
/// kinds that a surface has none of are left out. Precondition: as make_model.
std::vector<LineSet> faulty_edges(const std::vector<NamedSurface>& surfaces, const Model& model);

/// The geometry that `choice` shows. A slab beyond the last is empty.
Overlay make_overlay(const OverlaySource& source, const OverlayChoice& choice, const Model& model);

}  // namespace odontoscope
