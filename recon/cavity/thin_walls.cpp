#include "recon/cavity/thin_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>

#include "recon/cavity/limits.h"
#include "recon/cavity/pockets.h"
#include "recon/cavity/wall_tree.h"
#include "recon/core/lower_case.h"

namespace odontoscope::cavity {
namespace {

void add_outside(Outside& outside, const StructureSurface& part, const SurfaceReport& report,
                 const std::vector<Cavity>& pockets) {
  const auto base = static_cast<PointIndex>(outside.surface.points.size());
  outside.surface.points.insert(outside.surface.points.end(), part.surface->points.begin(), part.surface->points.end());
  const auto lines_a_pocket = [&](std::uint32_t t) {
    return std::any_of(pockets.begin(), pockets.end(), [&](const Cavity& pocket) {
      return std::binary_search(pocket.cut_from.begin(), pocket.cut_from.end(), t);
    });
  };
  for (std::uint32_t t = 0; t < part.surface->triangles.size(); ++t) {
    if (report.shells[report.shell_of[t]].kind != Shell::Kind::external || lines_a_pocket(t)) continue;
    const Triangle& triangle = part.surface->triangles[t];
    outside.surface.triangles.push_back({base + triangle[0], base + triangle[1], base + triangle[2]});
  }
  for (const Cavity& pocket : pockets)
    outside.mouths.insert(outside.mouths.end(), pocket.mouths.begin(), pocket.mouths.end());
}

}  // namespace

Outside outside_of(const std::vector<StructureSurface>& model, const std::vector<SurfaceReport>& reports,
                   const Cavity& cavity) {
  constexpr std::string_view cavity_suffix = " cavity";
  std::string solid = cavity.structure;
  if (solid.ends_with(cavity_suffix)) solid.resize(solid.size() - cavity_suffix.size());
  const auto has_word = [](const std::string& name, std::string_view word) {
    return lower_case(name).find(word) != std::string::npos;
  };
  const bool pulp = has_word(solid, "pulp");
  Outside outside;
  for (std::size_t s = 0; s < model.size(); ++s) {
    const std::string& name = model[s].structure;
    if (pulp && (has_word(name, "dentin") || has_word(name, "tooth")))
      add_outside(outside, model[s], reports[s], pockets_of(model[s], reports[s], {}));
    if (pulp || (name != solid && name != solid + " external")) continue;
    add_outside(outside, model[s], reports[s],
                cavity.mouths.empty() ? std::vector<Cavity>{} : std::vector<Cavity>{cavity});
  }
  return outside;
}

namespace {

/// Where the wall is the canal's alone: the chamber's flares into the orifice.
std::size_t below_rim(const CentreLine& line) {
  std::size_t below = line.orifice;
  const CentrePoint& orifice = line.points[line.orifice];
  while (line.orifice > 0 && below + 1 < line.points.size() &&
         line.points[below].along - orifice.along < limits::orifice_rim * orifice.ball)
    ++below;
  return below;
}

/// The canal, below its orifice, whose line is nearest; as many as there are canals if a chamber or a horn is nearer.
std::size_t canal_beside(const Point3& p, const CentreLines& lines) {
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t canal = lines.canals.size();
  const auto look = [&](const CentreLine& line, std::size_t number) {
    const std::size_t below = below_rim(line);
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const double far = length(p - line.points[i].at);
      if (far >= nearest) continue;
      nearest = far;
      canal = i >= below ? number : lines.canals.size();
    }
  };
  for (std::size_t c = 0; c < lines.canals.size(); ++c) look(lines.canals[c], c);
  for (const CentreLine& line : lines.horns) look(line, lines.canals.size());
  return canal;
}

double size_of(const SurfaceMesh& surface) {
  Point3 low = surface.points[surface.triangles.front()[0]], high = low;
  for (const Triangle& t : surface.triangles) {
    for (const PointIndex v : t) {
      const Point3& p = surface.points[v];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  return length(high - low);
}

/// A point of the void's wall beside a canal.
struct WallPoint {
  Point3 at;
  std::size_t canal;
  double thick;
};

/// Where wall and outside are one: those no farther apart than a canal is wide are one opening.
std::vector<Opening> openings_at(const std::vector<WallPoint>& touching, const std::vector<MeasuredCanal>& canals) {
  std::vector<Opening> found;
  for (const WallPoint& p : touching) {
    const auto own = std::find_if(found.begin(), found.end(), [&](const Opening& one) {
      return one.canal == p.canal && length(p.at - one.at) <= canals[p.canal].mean_width;
    });
    if (own == found.end())
      found.push_back({p.canal, p.at, 0});
    else
      own->reach = std::max(own->reach, length(p.at - own->at));
  }
  return found;
}

}  // namespace

std::vector<Opening> measure_walls(const Cavity& cavity, const CentreLines& lines, const Outside& outer,
                                   std::vector<MeasuredCanal>& canals, const Progress& progress) {
  const WallTree outside(outer.surface);
  const double touches = limits::opening * size_of(outer.surface);
  std::vector<WallPoint> points, touching;
  for (const Point3& p : cavity.wall.points) {
    progress.check();
    const std::size_t canal = canal_beside(p, lines);
    if (canal == canals.size()) continue;
    const auto beside = [&](const Cavity::Mouth& mouth) {
      return length(p - mouth.at) < std::sqrt(mouth.area / std::numbers::pi) + canals[canal].mean_width;
    };
    if (std::any_of(outer.mouths.begin(), outer.mouths.end(), beside)) continue;
    const WallPoint point{p, canal, outside.nearest(p).distance};
    (point.thick <= touches ? touching : points).push_back(point);
  }
  std::vector<Opening> openings = openings_at(touching, canals);
  for (const WallPoint& p : points) {
    const double width = canals[p.canal].mean_width;
    if (std::any_of(openings.begin(), openings.end(),
                    [&](const Opening& one) { return length(p.at - one.at) < one.reach + width; }))
      continue;
    std::optional<MeasuredPlace>& thinnest = canals[p.canal].thinnest_wall;
    if (!thinnest || p.thick < thinnest->width) thinnest = MeasuredPlace{p.thick, p.at};
  }
  return openings;
}

}  // namespace odontoscope::cavity
