#include "tests/navigate/cavities.h"

#include <filesystem>
#include <map>

#include "recon/delaunay/reconstruct.h"
#include "recon/mesh/append.h"
#include "recon/sample/sample_tooth.h"
#include "recon/volume/iso_contours.h"
#include "recon/volume/read_volume.h"

namespace odontoscope::test {

namespace {

SurfaceMesh part_of(const SurfaceMesh& surface, const std::vector<bool>& kept) {
  SurfaceMesh part;
  std::map<PointIndex, PointIndex> moved;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (!kept[t]) continue;
    Triangle triangle = surface.triangles[t];
    for (PointIndex& vertex : triangle) {
      const auto [place, fresh] = moved.try_emplace(vertex, static_cast<PointIndex>(part.points.size()));
      if (fresh) part.points.push_back(surface.points[vertex]);
      vertex = place->second;
    }
    part.triangles.push_back(triangle);
  }
  return part;
}

SurfaceMesh outside_of(const Reconstruction& made) {
  SurfaceMesh all;
  for (const Solid& solid : made.solids) {
    std::vector<bool> kept;
    for (const std::uint32_t shell : solid.report.shell_of)
      kept.push_back(solid.report.shells[shell].kind == Shell::Kind::external);
    append(part_of(solid.surface, kept), all);
  }
  return all;
}

const Reconstruction* ct_molar() {
  static const std::filesystem::path file = std::filesystem::path(ODONTOSCOPE_DATA) / "ct_molar" / "tooth.nrrd";
  if (std::string(ODONTOSCOPE_DATA).empty() || !std::filesystem::exists(file)) return nullptr;
  static const Reconstruction made =
      reconstruct(iso_contours(read_volume(file.string()), {{120, "tooth"}}, {.min_area = 4}).stack);
  return &made;
}

const Reconstruction& sample_molar() {
  static const Reconstruction made = reconstruct(sample_tooth(ToothKind::molar));
  return made;
}

}  // namespace

SurfaceMesh largest_cavity(const SurfaceMesh& surface, const SurfaceReport& report) {
  std::size_t best = report.shells.size();
  for (std::size_t s = 0; s < report.shells.size(); ++s)
    if (report.shells[s].kind == Shell::Kind::cavity &&
        (best == report.shells.size() || report.shells[s].volume < report.shells[best].volume))
      best = s;
  std::vector<bool> kept;
  for (const std::uint32_t shell : report.shell_of) kept.push_back(shell == best);
  return part_of(surface, kept);
}

const SurfaceMesh* ct_molar_pulp() {
  if (!ct_molar()) return nullptr;
  static const SurfaceMesh pulp = largest_cavity(ct_molar()->solids.at(0).surface, ct_molar()->solids.at(0).report);
  return &pulp;
}

const SurfaceMesh& sample_molar_pulp() {
  static const SurfaceMesh pulp = [] {
    for (const Solid& solid : sample_molar().solids)
      if (solid.structure == "dentine") return largest_cavity(solid.surface, solid.report);
    return SurfaceMesh{};
  }();
  return pulp;
}

const SurfaceMesh* ct_molar_outside() {
  if (!ct_molar()) return nullptr;
  static const SurfaceMesh outside = outside_of(*ct_molar());
  return &outside;
}

const SurfaceMesh& sample_molar_outside() {
  static const SurfaceMesh outside = outside_of(sample_molar());
  return outside;
}

}  // namespace odontoscope::test
