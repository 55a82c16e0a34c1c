#pragma once
// What panels are put together from.

#include <string>
#include <vector>

#include "assets/theme.h"
#include "engine/figures/figure.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/input/contour_stack.h"
#include "recon/input/links.h"

namespace odontoscope::figures {

/// The paper's two methods are told apart by these colours wherever a shape is not a tooth.
inline constexpr Colour dt_colour = colour_of(assets::theme::figures::dt),
                        db_colour = colour_of(assets::theme::figures::db),
                        decimated_colour = colour_of(assets::theme::figures::decimated);
/// Tetrahedra that a figure is about, and those around them.
inline constexpr Colour marked_colour = colour_of(assets::theme::figures::marked),
                        other_colour = colour_of(assets::theme::figures::other);

/// What a panel shows before its scene is known.
struct Subject {
  std::vector<NamedSurface> surfaces;
  std::vector<Strokes> strokes = {};
  double crease_deg = default_crease_deg;
};

/// The subject from a named side or a direction, all of it in the picture, opaque, on the page's colour.
Panel panel(std::string caption, Subject subject, double aspect, NamedView view = NamedView::three_quarter);
Panel panel(std::string caption, Subject subject, double aspect, const glm::dvec3& towards_eye,
            const glm::dvec3& up = {0, 0, 1});

/// Every surface in one colour.
void paint(Panel& panel, const Colour& colour);
void set_opacity(Panel& panel, float opacity);
/// The same picture with the edges of the triangles.
Panel with_mesh(std::string caption, Panel panel);
/// Looks at a ball of this size instead of at everything.
void look_closer(Panel& panel, const glm::dvec3& at, double radius_mm);

Strokes contour_strokes(const ContourStack& stack);
/// All edges of the tetrahedra, each once.
Strokes edge_strokes(const TetraMesh& mesh);
/// Lines along these edges.
Strokes strokes(LineKind kind, const std::vector<Point3>& ends);

/// Each tetrahedron a closed surface of its own, shrunk towards its centre.
SurfaceMesh shrunk(const std::vector<Point3>& points, const std::vector<Tetrahedron>& tetrahedra, double shrink);

std::vector<NamedSurface> dt_surfaces(const ContourStack& stack, const std::vector<Link>& links = {});
/// The consistent table, so that what is seen is the field's doing and not the table's.
std::vector<NamedSurface> db_surfaces(const ContourStack& stack, std::size_t grid,
                                      const std::vector<double>& splits = {});

std::size_t triangles_of(const std::vector<NamedSurface>& surfaces);

}  // namespace odontoscope::figures
