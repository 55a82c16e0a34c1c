#include "recon/elements/elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "recon/core/error.h"
#include "recon/elements/fill.h"
#include "recon/elements/improve.h"
#include "recon/elements/limits.h"
#include "recon/elements/remesh_interfaces.h"
#include "recon/mesh/complex_parts.h"
#include "recon/mesh/extent.h"
#include "recon/mesh/surface_report.h"
#include "recon/mesh/vector.h"
#include "recon/partition/interfaces.h"

namespace odontoscope::elements {
namespace {

/// Points and faces of the interfaces alone.
LabelledComplex bounds_of(const LabelledComplex& complex) {
  LabelledComplex bounds{complex.structures, {complex.mesh.points, {}, {}}, complex.interfaces};
  drop_unused(bounds);
  return bounds;
}

LabelledComplex remeshed(const LabelledComplex& bounds, double size, const Progress& progress) {
  InterfaceWeb web(bounds.mesh.points, bounds.interfaces);
  remesh_interfaces(web, size, progress);
  LabelledComplex made{bounds.structures, {web.points(), {}, {}}, {}};
  for (std::uint32_t f = 0; f < web.faces().size(); ++f)
    if (web.alive(f)) made.interfaces.push_back(web.faces()[f]);
  drop_unused(made);
  return made;
}

using KindOfShell = std::pair<Shell::Kind, long>;  // and genus

std::vector<KindOfShell> kinds_of(const SurfaceReport& report) {
  std::vector<KindOfShell> kinds;
  for (const Shell& shell : report.shells) kinds.emplace_back(shell.kind, shell.genus);
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

/// Of each material, and of all together.
bool same_topology(const LabelledComplex& before, const LabelledComplex& now) {
  const auto last = static_cast<Label>(before.structures.size());
  for (Label l = 0; l <= last; ++l) {
    const SurfaceReport was = inspect(surface_of(before, l)), is = inspect(surface_of(now, l));
    if (!is.closed_oriented_manifold() || kinds_of(was) != kinds_of(is)) return false;
  }
  return true;
}

using Face = std::tuple<Triangle, Label, Label>;

/// Ascending, each begun at its lowest number.
std::vector<Face> sorted_faces(const std::vector<InterfaceTriangle>& interfaces) {
  std::vector<Face> faces;
  for (const InterfaceTriangle& face : interfaces) {
    Triangle t = face.triangle;
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    faces.emplace_back(t, face.inner, face.outer);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// From the arrays alone. With positive tetrahedra that share faces side by side, and closed surfaces that do not cut
/// each other, nothing overlaps.
void certify(const LabelledComplex& made, const LabelledComplex& bounds) {
  if (inspect(made.mesh).non_positive > 0) throw InternalError("an element is flat or turned inside out");
  if (sorted_faces(partition::interfaces_of(made.mesh)) != sorted_faces(bounds.interfaces))
    throw InternalError("elements do not end at the interfaces");
}

double volume_of(const LabelledComplex& complex, Label label) {
  double sum = 0;
  const auto& points = complex.mesh.points;
  for (std::size_t t = 0; t < complex.mesh.tetrahedra.size(); ++t) {
    if (complex.mesh.labels[t] != label) continue;
    const auto& [a, b, c, d] = complex.mesh.tetrahedra[t];
    sum += dot(cross(points[b] - points[a], points[c] - points[a]), points[d] - points[a]) / 6;
  }
  return sum;
}

std::vector<MaterialElements> measured(const LabelledComplex& made, const LabelledComplex& exact,
                                       const Progress& progress) {
  std::vector<MaterialElements> materials;
  const auto last = static_cast<Label>(made.structures.size());
  for (Label l = 1; l <= last; ++l) {
    const TetraMesh tetrahedra = tetrahedra_of(made, l);
    if (tetrahedra.tetrahedra.empty()) continue;
    const auto distance =
        surface_distance(surface_of(made, l), surface_of(exact, l), {limits::distance_samples}, progress);
    materials.push_back(
        {made.structures[l - 1], inspect(tetrahedra), volume_of(exact, l), distance.value_or(SurfaceDistance{})});
  }
  return materials;
}

/// Of a regular tetrahedron with such edges, and a bit.
double largest_volume(double size) { return limits::volume_margin * size * size * size / (6 * std::sqrt(2.0)); }

}  // namespace

Elements make_elements(const LabelledComplex& exact, double size, const Progress& progress) {
  if (!can_fill())
    throw UsageError("--elements needs TetGen, and this program was built without it",
                     "Install libtet1.5-dev and build again");
  const LabelledComplex bounds = bounds_of(exact);
  const InterfaceShape shape(InterfaceWeb(bounds.mesh.points, bounds.interfaces));
  const double asked = size;
  for (int attempt = 0; attempt < limits::sizes; ++attempt, size /= 2) {
    const LabelledComplex coarse = remeshed(bounds, size, progress);
    if (!same_topology(bounds, coarse)) continue;
    progress.tell("fill", 0);
    std::optional<LabelledComplex> filled = fill(coarse, largest_volume(size), progress);
    if (!filled) continue;
    improve(*filled, shape, progress);
    drop_void(*filled);
    certify(*filled, coarse);
    std::vector<MaterialElements> materials = measured(*filled, exact, progress);
    return {std::move(*filled), size, std::move(materials)};
  }
  throw InputError("no-elements", {},
                   fmt::format("no elements of {:.3g} mm, nor of a half or a quarter of that, came to an end", asked),
                   "Try --elements with another size, or leave it out: the exact tetrahedra are certified, if thin");
}

double suggested_size(const LabelledComplex& exact) {
  const double whole = diagonal_of(bounds_of(exact).mesh.points);
  double smallest = whole;
  const auto last = static_cast<Label>(exact.structures.size());
  for (Label l = 1; l <= last; ++l) {
    const SurfaceMesh surface = surface_of(exact, l);
    if (!surface.points.empty()) smallest = std::min(smallest, diagonal_of(surface.points));
  }
  return std::clamp(smallest / limits::sizes_in_smallest, whole / limits::most_sizes, whole / limits::fewest_sizes);
}

}  // namespace odontoscope::elements
