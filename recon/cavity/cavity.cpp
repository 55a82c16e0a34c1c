#include "recon/cavity/cavity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "recon/cavity/limits.h"
#include "recon/cavity/pockets.h"
#include "recon/core/lower_case.h"

namespace odontoscope {
namespace {

std::vector<Cavity> closed_shells(const std::string& structure, const SurfaceMesh& surface,
                                  const SurfaceReport& report) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> number(report.shells.size(), none);
  std::vector<Cavity> found;
  for (std::size_t s = 0; s < report.shells.size(); ++s) {
    if (report.shells[s].kind != Shell::Kind::cavity) continue;
    number[s] = found.size();
    Cavity& cavity = found.emplace_back();
    cavity.structure = structure;
    cavity.volume = std::abs(report.shells[s].volume);
  }
  if (found.empty()) return found;
  constexpr PointIndex unmoved = std::numeric_limits<PointIndex>::max();
  // A vertex where two shells touch gets a place in each.
  std::vector<std::pair<std::size_t, PointIndex>> moved(surface.points.size(), {none, unmoved});
  for (std::size_t s = 0; s < found.size(); ++s) {
    SurfaceMesh& wall = found[s].wall;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      if (number[report.shell_of[t]] != s) continue;
      Triangle triangle = surface.triangles[t];
      for (PointIndex& vertex : triangle) {
        auto& [shell, place] = moved[vertex];
        if (shell != s) {
          shell = s;
          place = static_cast<PointIndex>(wall.points.size());
          wall.points.push_back(surface.points[vertex]);
        }
        vertex = place;
      }
      wall.triangles.push_back(triangle);
    }
  }
  return found;
}

std::tuple<double, double, double> lowest(const Cavity& cavity) {
  std::tuple<double, double, double> low{std::numeric_limits<double>::infinity(), 0, 0};
  for (const Point3& p : cavity.wall.points) low = std::min(low, {p.x, p.y, p.z});
  return low;
}

std::vector<Cavity> largest_first(std::vector<Cavity> cavities) {
  std::sort(cavities.begin(), cavities.end(), [](const Cavity& a, const Cavity& b) {
    return a.volume != b.volume ? a.volume > b.volume : lowest(a) < lowest(b);
  });
  std::erase_if(cavities, [least = cavities.empty() ? 0 : limits::cavity_speck * cavities.front().volume](
                              const Cavity& cavity) { return cavity.volume < least; });
  return cavities;
}

bool named_pulp(const std::string& name) { return lower_case(name).find("pulp") != std::string::npos; }

double largest_pulp_body(const std::vector<StructureSurface>& model, const std::vector<SurfaceReport>& reports) {
  double largest = 0;
  for (std::size_t s = 0; s < model.size(); ++s) {
    if (!named_pulp(model[s].structure)) continue;
    for (const Shell& shell : reports[s].shells)
      if (shell.kind == Shell::Kind::external) largest = std::max(largest, shell.volume);
  }
  return largest;
}

}  // namespace

std::vector<Cavity> cavities_of(const std::string& structure, const SurfaceMesh& surface, const SurfaceReport& report) {
  return largest_first(closed_shells(structure, surface, report));
}

std::vector<Cavity> cavities_of(const std::string& structure, const SurfaceMesh& surface) {
  return cavities_of(structure, surface, inspect(surface));
}

std::vector<Cavity> voids_filled_by(const std::string& structure, const SurfaceMesh& body) {
  SurfaceMesh turned = body;
  for (Triangle& t : turned.triangles) std::swap(t[1], t[2]);
  std::vector<Cavity> filled = cavities_of(structure, turned);
  for (Cavity& cavity : filled) cavity.body = true;
  return filled;
}

std::vector<Cavity> cavities_in(const std::vector<StructureSurface>& model) {
  std::vector<Cavity> all;
  const auto add = [&](std::vector<Cavity> some) { std::move(some.begin(), some.end(), std::back_inserter(all)); };
  std::vector<SurfaceReport> reports;
  for (const StructureSurface& part : model) {
    reports.push_back(inspect(*part.surface));
    add(cavities_of(part.structure, *part.surface, reports.back()));
  }
  double largest = 0;
  for (const Cavity& cavity : all) largest = std::max(largest, cavity.volume);
  for (std::size_t s = 0; s < model.size(); ++s) {
    std::vector<const SurfaceMesh*> others;
    for (std::size_t o = 0; o < model.size(); ++o)
      if (o != s) others.push_back(model[o].surface);
    std::vector<Cavity> pockets = cavity::pockets_of(model[s], reports[s], others);
    std::erase_if(pockets, [&](const Cavity& pocket) { return pocket.volume <= largest; });
    add(std::move(pockets));
  }
  // Beside a body of pulp a bubble in the material round it is no pulp.
  for (const Cavity& cavity : all) largest = std::max(largest, cavity.volume);
  if (all.empty() || largest < limits::cavity_speck * largest_pulp_body(model, reports)) {
    all.clear();
    for (const StructureSurface& part : model)
      if (named_pulp(part.structure)) add(voids_filled_by(part.structure, *part.surface));
  }
  return largest_first(std::move(all));
}

}  // namespace odontoscope
