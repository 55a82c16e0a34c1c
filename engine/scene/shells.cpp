#include "engine/scene/shells.h"

#include <limits>
#include <utility>

namespace odontoscope {
namespace {

/// The shells of one kind, on their own points.
SurfaceMesh shells_of(const SurfaceMesh& surface, const SurfaceReport& report, Shell::Kind kind) {
  SurfaceMesh part;
  constexpr PointIndex none = std::numeric_limits<PointIndex>::max();
  std::vector<PointIndex> moved(surface.points.size(), none);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (report.shells[report.shell_of[t]].kind != kind) continue;
    Triangle triangle = surface.triangles[t];
    for (PointIndex& vertex : triangle) {
      if (moved[vertex] == none) {
        moved[vertex] = static_cast<PointIndex>(part.points.size());
        part.points.push_back(surface.points[vertex]);
      }
      vertex = moved[vertex];
    }
    part.triangles.push_back(triangle);
  }
  return part;
}

}  // namespace

void add_shells(const std::string& structure, const SurfaceMesh& surface, const SurfaceReport& report,
                std::vector<NamedSurface>& to) {
  to.push_back({structure, shells_of(surface, report, Shell::Kind::external), structure});
  SurfaceMesh cavities = shells_of(surface, report, Shell::Kind::cavity);
  if (!cavities.triangles.empty()) to.push_back({structure + " cavity", std::move(cavities), structure, true});
}

}  // namespace odontoscope
