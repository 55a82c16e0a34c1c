#pragma once
// Places where a surface is broken, to be led to one after the other.

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/measure/pick.h"
#include "engine/scene/camera.h"
#include "recon/distance/defects.h"
#include "recon/distance/field.h"
#include "recon/distance/grid.h"

namespace odontoscope {

/// All defects of one face between two cells, since they have one reason; or one edge of a decimated surface.
struct ComparisonArtefact {
  std::string structure;
  DefectKind kind = DefectKind::crack;
  glm::dvec3 at{0};             // mm
  glm::dvec3 outward{0, 0, 1};  // from the material to the void, unit length, roughly
  /// As marching cubes left it; without, decimation moved it and no two cells answer for it any more.
  std::optional<Defect> reason;
};

/// One a face, by kind (cracks, non-manifold, misoriented). The place is the middle of the face's defects.
std::vector<ComparisonArtefact> artefacts_of(const std::string& structure, const Grid& grid, const Field& field,
                                             const std::vector<Defect>& defects);

/// One an edge, of any mesh.
std::vector<ComparisonArtefact> artefacts_of(const std::string& structure, const SurfaceMesh& mesh);

/// Cracks first, non-manifold edges next, misoriented ones last; these in such an order that one and the next lie far
/// apart.
std::vector<ComparisonArtefact> in_telling_order(std::vector<ComparisonArtefact> artefacts);

/// Of eight places around the artefact, as camera_at() shows it, how many lie on the surface that it is in: few at an
/// edge, or in a canal of a few cells.
std::size_t wall_around(const ComparisonArtefact& artefact, double spacing_mm, const Pickable& pickable,
                        const Scene& scene);

/// In order, but that cracks with more of a wall around them come before those with less. Only so many are looked at
/// (the first 100), and the others follow.
std::vector<ComparisonArtefact> cracks_on_walls_first(std::vector<ComparisonArtefact> artefacts, double spacing_mm,
                                                      const Pickable& pickable, Scene scene);

/// For a person: what is broken, where and why. With a reason it names the table, the two cells and their cases.
std::string in_words(const ComparisonArtefact& artefact, CaseTable table);

/// Looks at the artefact along the surface's normal, near enough to tell the triangles (`spacing_mm`) apart; from aside
/// where the model itself stands in the way, and from nearer where that does not help (in a canal). `start` gives
/// projection and angle of view.
Camera camera_at(const ComparisonArtefact& artefact, double spacing_mm, const Camera& start, const Pickable& pickable,
                 const Scene& scene);

}  // namespace odontoscope
