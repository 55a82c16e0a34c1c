#include "recon/cavity/anatomy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string_view>
#include <utility>

#include "recon/cavity/dents.h"
#include "recon/cavity/plane_loops.h"
#include "recon/cavity/wall_tree.h"

namespace odontoscope {
namespace {

constexpr std::string_view stage = "measure";
constexpr double degrees = 57.29577951308232;
/// Heights at which a root's canals are counted.
constexpr std::size_t root_sections = 120;

MeasuredStructure measured(const StructureSurface& part, const SurfaceReport& report) {
  MeasuredStructure made{part.structure};
  for (const Shell& shell : report.shells) {
    made.volume += shell.kind == Shell::Kind::open ? 0 : shell.volume;
    made.area += shell.kind == Shell::Kind::external ? shell.area : 0;
  }
  return made;
}

/// The outer shells of the solid that the void lies in, without the lining of what opens to the outside.
struct Outside {
  SurfaceMesh surface;                  // empty: the solid is not there
  std::vector<Cavity::Mouth> mouths;    // where the lining ends
};

void add_outside(Outside& outside, const StructureSurface& part, const SurfaceReport& report, const std::vector<Cavity>& dents) {
  const auto base = static_cast<PointIndex>(outside.surface.points.size());
  outside.surface.points.insert(outside.surface.points.end(), part.surface->points.begin(), part.surface->points.end());
  const auto lines_a_dent = [&](std::uint32_t t) {
    return std::any_of(dents.begin(), dents.end(), [&](const Cavity& dent) { return std::binary_search(dent.cut_from.begin(), dent.cut_from.end(), t); });
  };
  for (std::uint32_t t = 0; t < part.surface->triangles.size(); ++t) {
    if (report.shells[report.shell_of[t]].kind != Shell::Kind::external || lines_a_dent(t)) continue;
    const Triangle& triangle = part.surface->triangles[t];
    outside.surface.triangles.push_back({base + triangle[0], base + triangle[1], base + triangle[2]});
  }
  for (const Cavity& dent : dents) outside.mouths.insert(outside.mouths.end(), dent.mouths.begin(), dent.mouths.end());
}

/// The void that a body of pulp fills lies in what is called dentine or tooth, where it may open to the outside.
Outside outside_of(const std::vector<StructureSurface>& model, const std::vector<SurfaceReport>& reports, const Cavity& cavity) {
  constexpr std::string_view cavity_suffix = " cavity";
  std::string solid = cavity.structure;
  if (solid.ends_with(cavity_suffix)) solid.resize(solid.size() - cavity_suffix.size());
  const auto has_word = [](const std::string& name, std::string_view word) { return name.find(word) != std::string::npos; };
  const bool pulp = has_word(solid, "pulp") || has_word(solid, "Pulp");
  Outside outside;
  for (std::size_t s = 0; s < model.size(); ++s) {
    const std::string& name = model[s].structure;
    if (pulp && (has_word(name, "dentin") || has_word(name, "tooth"))) add_outside(outside, model[s], reports[s], cavity::dents_of(model[s], reports[s], {}));
    if (pulp || (name != solid && name != solid + " external")) continue;
    add_outside(outside, model[s], reports[s], cavity.mouths.empty() ? std::vector<Cavity>{} : std::vector<Cavity>{cavity});
  }
  return outside;
}

double schneider(const CentreLine& line, double length_of_canal) {
  const CentrePoint& orifice = line.points[line.orifice];
  const auto third = std::find_if(line.points.begin() + static_cast<std::ptrdiff_t>(line.orifice), line.points.end(),
                                  [&](const CentrePoint& p) { return p.along >= orifice.along + length_of_canal / 3; });
  if (third == line.points.end()) return 0;
  const Direction way = third->at - orifice.at;
  const Direction axis = (1 / length(way)) * way;
  for (auto p = third; p != line.points.end(); ++p) {
    const Direction off = p->at - orifice.at;
    if (length(cross(axis, off)) <= 0.5 * p->radius) continue;
    const Direction apical = line.end - p->at;
    return degrees * std::atan2(length(cross(axis, apical)), dot(axis, apical));
  }
  return 0;
}

double smallest_bend(const CentreLine& line, double window) {
  double smallest = std::numeric_limits<double>::infinity();
  const std::size_t first = line.orifice, last = line.points.size() - 1;
  const double step = line.points[1].along - line.points[0].along;
  const std::size_t reach = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(window / step)));
  for (std::size_t i = first + reach; i + reach <= last; ++i) {
    const Direction a = line.points[i].at - line.points[i - reach].at, b = line.points[i + reach].at - line.points[i].at,
                    c = line.points[i + reach].at - line.points[i - reach].at;
    const double twice_area = length(cross(a, b));
    if (twice_area > 0) smallest = std::min(smallest, length(a) * length(b) * length(c) / (2 * twice_area));
  }
  return smallest;
}

MeasuredCanal measured(const CentreLine& line) {
  MeasuredCanal canal;
  canal.name = line.name;
  canal.orifice = line.points[line.orifice].at;
  canal.end = line.end;
  const CentrePoint& last = line.points.back();
  canal.length = last.along - line.points[line.orifice].along + length(line.end - last.at);
  double sum = 0;
  for (std::size_t i = line.orifice; i < line.points.size(); ++i) sum += line.points[i].radius;
  canal.mean_width = 2 * sum / static_cast<double>(line.points.size() - line.orifice);
  for (std::size_t i = line.orifice; i < line.points.size(); ++i) {
    const CentrePoint& p = line.points[i];
    // Blind ends are narrow, and a tube without a chamber has two.
    const bool near_end = length(line.end - p.at) < canal.mean_width || (line.orifice == 0 && length(line.points.front().at - p.at) < canal.mean_width);
    if (!near_end && (!canal.narrowest || 2 * p.radius < canal.narrowest->width)) canal.narrowest = MeasuredPlace{2 * p.radius, p.at};
  }
  canal.schneider_deg = schneider(line, canal.length);
  canal.smallest_bend = smallest_bend(line, canal.mean_width);
  return canal;
}

MeasuredPart measured(const CentreLines& lines, const CanalGraph& graph, const CanalPart& part) {
  const CentreLine& line = lines.canals[part.canals.front()];
  MeasuredPart made;
  made.length = line.points[part.last].along - line.points[part.first].along;
  // Between its last point and the node: the wall, or a place on another canal's line.
  made.length += length(graph.nodes[part.to] - line.points[part.last].at);
  if (part.from > 0) made.length += length(graph.nodes[part.from] - line.points[part.first].at);
  double sum = 0;
  for (std::size_t i = part.first; i <= part.last; ++i) sum += line.points[i].radius;
  made.mean_width = 2 * sum / static_cast<double>(part.last - part.first + 1);
  return made;
}

/// From each point of the void's wall that is nearest to a canal's line, below its orifice, to the outside.
void measure_walls(const Cavity& cavity, const CentreLines& lines, const Outside& outer, std::vector<MeasuredCanal>& canals, const Progress& progress) {
  const WallTree outside(outer.surface);
  for (const Point3& p : cavity.wall.points) {
    progress.check();
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t canal = canals.size();
    const auto look = [&](const CentreLine& line, std::size_t number) {
      for (std::size_t i = 0; i < line.points.size(); ++i) {
        const double far = length(p - line.points[i].at);
        if (far < nearest) {
          nearest = far;
          canal = number < canals.size() && i >= line.orifice ? number : canals.size();
        }
      }
    };
    for (std::size_t c = 0; c < lines.canals.size(); ++c) look(lines.canals[c], c);
    for (const CentreLine& line : lines.horns) look(line, canals.size());
    if (canal == canals.size()) continue;
    const auto beside = [&](const Cavity::Mouth& mouth) { return length(p - mouth.at) < std::sqrt(mouth.area / std::numbers::pi) + canals[canal].mean_width; };
    if (std::any_of(outer.mouths.begin(), outer.mouths.end(), beside)) continue;
    const double thick = outside.nearest(p).distance;
    std::optional<MeasuredPlace>& thinnest = canals[canal].thinnest_wall;
    if (!thinnest || thick < thinnest->width) thinnest = MeasuredPlace{thick, p};
  }
}

/// Where a canal's line passes this height last, on its way to the apex; nothing if it does not, below the orifice.
std::optional<Point2> passes(const CentreLine& line, double z) {
  for (std::size_t i = line.points.size() - 1; i > line.orifice; --i) {
    const Point3 &a = line.points[i - 1].at, &b = line.points[i].at;
    if ((a.z >= z) == (b.z >= z)) continue;
    const double share = (z - a.z) / (b.z - a.z);
    return Point2{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
  }
  return std::nullopt;
}

/// The number of the smallest loop round the place; as many as there are loops if none is.
std::size_t loop_round(const std::vector<cavity::Loop>& loops, const std::optional<Point2>& place) {
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (place && cavity::is_inside(loops[i], *place)) return i;
  return loops.size();
}

std::string vertucci_type(const std::vector<std::size_t>& sections) {
  constexpr std::array<const char*, 8> names = {"I", "II", "III", "IV", "V", "VI", "VII", "VIII"};
  const std::array<std::vector<std::size_t>, 8> types = {{{1}, {2, 1}, {1, 2, 1}, {2}, {1, 2}, {2, 1, 2}, {1, 2, 1, 2}, {3}}};
  const auto found = std::find(types.begin(), types.end(), sections);
  return found == types.end() ? "other" : names[static_cast<std::size_t>(found - types.begin())];
}

/// 1 where canals run down from their orifices, -1 where they run up: heights times this fall towards the apex.
double falling(double towards_end) { return towards_end > 0 ? -1 : 1; }

/// Counts from the lower orifice to the first blind end, in runs.
std::vector<std::size_t> counted_sections(const Cavity& cavity, const CentreLines& lines, const MeasuredRoot& root, const std::vector<MeasuredCanal>& canals) {
  double towards_end = 0;
  for (const std::size_t c : root.canals) towards_end += canals[c].end.z - canals[c].orifice.z;
  const double sign = falling(towards_end);
  double top = std::numeric_limits<double>::infinity(), bottom = -top, width = 0;
  for (const std::size_t c : root.canals) {
    const double orifice = sign * canals[c].orifice.z, end = sign * canals[c].end.z;
    top = std::min(top, std::max(orifice, end));
    bottom = std::max(bottom, std::min(orifice, end));
    width = std::max(width, canals[c].mean_width);
  }
  top -= 0.5 * width;
  bottom += 0.5 * width;
  std::vector<std::pair<std::size_t, std::size_t>> runs;   // count, heights
  for (std::size_t i = 0; i < root_sections && top > bottom; ++i) {
    const double z = sign * (top - (static_cast<double>(i) + 0.5) / root_sections * (top - bottom));
    const std::vector<cavity::Loop> loops = cavity::loops_at(cavity.wall, z);
    std::vector<std::size_t> seen;
    for (const std::size_t c : root.canals) seen.push_back(loop_round(loops, passes(lines.canals[c], z)));
    std::sort(seen.begin(), seen.end());
    const auto count = static_cast<std::size_t>(std::unique(seen.begin(), seen.end()) - seen.begin());
    if (runs.empty() || runs.back().first != count) runs.push_back({count, 0});
    ++runs.back().second;
  }
  std::vector<std::size_t> sections;
  for (const auto& [count, heights] : runs) {
    const double tall = (top - bottom) * static_cast<double>(heights) / root_sections;
    if (tall >= width && (sections.empty() || sections.back() != count)) sections.push_back(count);
  }
  if (sections.empty() && !runs.empty()) sections.push_back(runs.front().first);
  return sections;
}

/// Shorter branches that end, below an orifice, in the same outer contour as one of the root's canals.
std::size_t branches_beside(const CentreLines& lines, const SurfaceMesh& outside, const MeasuredRoot& root) {
  const auto beside = [&](const CentreLine& branch) {
    // A width before its end, for the canal beside it may end at about the same height.
    const auto before = std::find_if(branch.points.rbegin(), branch.points.rend(), [&](const CentrePoint& p) { return length(branch.end - p.at) > 2 * p.radius; });
    const Point3& at = before == branch.points.rend() ? branch.end : before->at;
    const std::vector<cavity::Loop> loops = cavity::loops_at(outside, at.z);
    const std::size_t own = loop_round(loops, Point2{at.x, at.y});
    return own < loops.size() && std::any_of(root.canals.begin(), root.canals.end(), [&](std::size_t c) { return loop_round(loops, passes(lines.canals[c], at.z)) == own; });
  };
  return static_cast<std::size_t>(std::count_if(lines.others.begin(), lines.others.end(), beside));
}

std::vector<MeasuredRoot> roots_of(const Cavity& cavity, const CentreLines& lines, const SurfaceMesh& outside, const std::vector<MeasuredCanal>& canals) {
  std::vector<std::size_t> root_of(canals.size());
  std::iota(root_of.begin(), root_of.end(), std::size_t{0});
  for (std::size_t a = 0; a < canals.size(); ++a) {
    for (std::size_t b = a + 1; b < canals.size(); ++b) {
      // Canals of one root end at about the same height; the middle of the apical half that both have.
      const double sign = falling(canals[a].end.z - canals[a].orifice.z + canals[b].end.z - canals[b].orifice.z);
      const double end = std::max(sign * canals[a].end.z, sign * canals[b].end.z), orifice = std::min(sign * canals[a].orifice.z, sign * canals[b].orifice.z);
      const double z = sign * (end + 0.25 * (orifice - end));
      const std::vector<cavity::Loop> loops = cavity::loops_at(outside, z);
      const std::size_t one = loop_round(loops, passes(lines.canals[a], z)), other = loop_round(loops, passes(lines.canals[b], z));
      if (one == other && one < loops.size()) std::replace(root_of.begin(), root_of.end(), root_of[b], root_of[a]);
    }
  }
  std::vector<MeasuredRoot> roots;
  for (std::size_t first = 0; first < canals.size(); ++first) {
    MeasuredRoot root;
    for (std::size_t c = 0; c < canals.size(); ++c)
      if (root_of[c] == first) root.canals.push_back(c);
    if (root.canals.empty()) continue;
    root.sections = counted_sections(cavity, lines, root, canals);
    root.vertucci = vertucci_type(root.sections);
    root.uncounted = branches_beside(lines, outside, root);
    roots.push_back(std::move(root));
  }
  return roots;
}

}  // namespace

Anatomy measure_anatomy(const std::vector<StructureSurface>& model, const Progress& progress) {
  Anatomy made;
  std::vector<SurfaceReport> reports;
  for (const StructureSurface& part : model) {
    reports.push_back(inspect(*part.surface));
    made.structures.push_back(measured(part, reports.back()));
  }
  const std::vector<Cavity> cavities = cavities_in(model);
  if (cavities.empty()) return made;
  const Cavity& cavity = cavities.front();
  const SurfaceReport wall = inspect(cavity.wall);
  made.cavity_of = cavity.structure;
  made.cavity_volume = cavity.volume;
  made.mouths = cavity.mouths;
  made.cavity_area = wall.shells.front().area;
  made.handles = wall.shells.front().genus;
  CentreLines lines = centre_lines(cavity, {}, progress);
  progress.tell(stage, 0);
  made.chamber_width = 2 * lines.chamber_radius;
  made.horns = lines.horns.size();
  made.other_branches = lines.others.size();
  for (const CentreLine& line : lines.canals) made.canals.push_back(measured(line));
  const Outside outside = outside_of(model, reports, cavity);
  if (!outside.surface.triangles.empty()) {
    measure_walls(cavity, lines, outside, made.canals, progress);
    progress.tell(stage, 0.5);
    made.roots = roots_of(cavity, lines, outside.surface, made.canals);
  }
  made.graph = canal_graph(lines);
  for (const CanalPart& part : made.graph.parts) made.parts.push_back(measured(lines, made.graph, part));
  made.lines = std::move(lines);
  progress.tell(stage, 1);
  return made;
}

}  // namespace odontoscope
