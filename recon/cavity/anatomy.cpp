#include "recon/cavity/anatomy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "recon/cavity/canal_measures.h"
#include "recon/cavity/forks.h"
#include "recon/cavity/roots.h"
#include "recon/cavity/thin_walls.h"
#include "recon/cavity/uncertainty.h"
#include "recon/cavity/wall_tree.h"

namespace odontoscope {
namespace {

constexpr std::string_view measure_stage = "measure";

MeasuredStructure measured(const StructureSurface& part, const SurfaceReport& report) {
  MeasuredStructure made{part.structure};
  for (const Shell& shell : report.shells) {
    made.volume += shell.kind == Shell::Kind::open ? 0 : shell.volume;
    made.area += shell.kind == Shell::Kind::external ? shell.area : 0;
  }
  return made;
}

/// Of a hollow that opens to the outside all closed voids are loose.
LoosePieces loose_pieces(const std::vector<StructureSurface>& model, const std::vector<SurfaceReport>& reports,
                         const Cavity& hollow) {
  LoosePieces loose;
  const Shell::Kind kind = hollow.body ? Shell::Kind::external : Shell::Kind::cavity;
  std::vector<double> volumes;
  for (std::size_t s = 0; s < model.size(); ++s)
    for (const Shell& shell : reports[s].shells)
      if (model[s].structure == hollow.structure && shell.kind == kind) volumes.push_back(std::abs(shell.volume));
  std::sort(volumes.begin(), volumes.end());
  if (hollow.mouths.empty() && !volumes.empty()) volumes.pop_back();
  loose.count = volumes.size();
  for (const double volume : volumes) loose.volume += volume;
  if (!volumes.empty()) loose.largest = volumes.back();
  return loose;
}

MeasuredPart measured(const CentreLines& lines, const CanalGraph& graph, const CanalPart& part) {
  const CentreLine& line = lines.canals[part.canals.front()];
  MeasuredPart made;
  made.length = line.points[part.last].along - line.points[part.first].along;
  // Between its last point and the node: the wall, or a place on another canal's line.
  made.length += length(graph.nodes[part.to] - line.points[part.last].at);
  if (part.from > 0 || !lines.has_chamber) made.length += length(graph.nodes[part.from] - line.points[part.first].at);
  double sum = 0;
  for (std::size_t i = part.first; i <= part.last; ++i) sum += line.points[i].ball;
  made.mean_width = 2 * sum / static_cast<double>(part.last - part.first + 1);
  return made;
}

std::vector<AccessoryCanal> accessory_canals(const Cavity& hollow, const CentreLines& lines) {
  std::vector<AccessoryCanal> found;
  if (lines.canals.empty() || lines.others.empty()) return found;
  const WallTree tree(hollow.wall);
  for (const CentreLine& branch : lines.others) {
    const cavity::BranchShape shape = cavity::branch_shape(branch, lines.canals, tree, cavity::Apart::or_sideways);
    if (shape.leaves == branch.points.size() || shape.length < shape.mean_width) continue;
    const CentrePoint& from = branch.points[shape.leaves];
    const CentreLine& parent = lines.canals[shape.parent];
    const auto nearer = [&](const CentrePoint& a, const CentrePoint& b) {
      return length(a.at - from.at) < length(b.at - from.at);
    };
    const CentrePoint& beside = *std::min_element(parent.points.begin(), parent.points.end(), nearer);
    const double below = beside.along - parent.points[parent.orifice].along;
    if (below < 0) continue;  // of the chamber
    const auto third = static_cast<std::size_t>(3 * below / parent.length_to_wall());
    found.push_back({branch.name, shape.parent, std::min<std::size_t>(third, 2), from.at, branch.end, shape.length,
                     shape.mean_width});
  }
  return found;
}

/// Of the slices that the model was made from; told from the wall where their number is not known.
double spacing_of(const std::vector<StructureSurface>& model, const SurfaceMesh& wall,
                  std::optional<std::size_t> slices) {
  if (!slices || *slices < 2) return cavity::slice_spacing_of(wall);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const StructureSurface& part : model)
    for (const Triangle& t : part.surface->triangles)
      for (const PointIndex v : t) {
        low = std::min(low, part.surface->points[v].z);
        high = std::max(high, part.surface->points[v].z);
      }
  return (high - low) / static_cast<double>(*slices - 1);
}

/// Sections are cut by planes of constant z: an oblique tooth is set upright for them.
std::vector<MeasuredRoot> roots_along(const ToothAxis& axis, const Cavity& hollow, const CentreLines& lines,
                                      const SurfaceMesh& outside, const std::vector<MeasuredCanal>& canals) {
  if (!axis.own) return cavity::roots_of(hollow, lines, outside, canals);
  const Upright upright(axis.along);
  Cavity turned = hollow;
  turned.wall = upright.turned(hollow.wall);
  std::vector<MeasuredCanal> measures = canals;
  for (MeasuredCanal& canal : measures) {
    canal.orifice = upright.turned(canal.orifice);
    canal.end = upright.turned(canal.end);
  }
  return cavity::roots_of(turned, upright.turned(lines), upright.turned(outside), measures);
}

}  // namespace

Anatomy measure_anatomy(const std::vector<StructureSurface>& model, const Progress& progress,
                        std::optional<std::size_t> slices) {
  Anatomy made;
  std::vector<SurfaceReport> reports;
  for (const StructureSurface& part : model) {
    reports.push_back(inspect(*part.surface));
    made.structures.push_back(measured(part, reports.back()));
  }
  const std::vector<Cavity> cavities = cavities_in(model);
  if (cavities.empty()) return made;
  const Cavity& hollow = cavities.front();
  const SurfaceReport wall = inspect(hollow.wall);
  made.cavity_of = hollow.structure;
  made.cavity_volume = hollow.volume;
  made.mouths = hollow.mouths;
  made.cavity_area = wall.shells.front().area;
  made.loose = loose_pieces(model, reports, hollow);
  made.axis = tooth_axis(model);
  CentreLines lines = centre_lines(hollow, {made.axis.along}, progress);
  progress.tell(measure_stage, 0);
  made.chamber_width = 2 * lines.chamber_radius;
  made.horns = lines.horns.size();
  made.other_branches = lines.others.size();
  made.handles = lines.loops.size();
  const auto genus = static_cast<std::size_t>(wall.shells.front().genus);
  made.narrow_handles = genus - std::min(made.handles, genus);
  made.slice_spacing = spacing_of(model, hollow.wall, slices);
  const WallTree tree(hollow.wall);
  for (const CentreLine& line : lines.canals)
    made.canals.push_back(cavity::measured_canal(line, hollow.wall, tree, made.slice_spacing));
  made.shapes = canal_shapes(hollow, lines, progress);
  made.accessory_canals = accessory_canals(hollow, lines);
  const cavity::Outside outside = cavity::outside_of(model, reports, hollow);
  if (!outside.surface.triangles.empty()) {
    made.openings = cavity::measure_walls(hollow, lines, outside, made.canals, progress);
    progress.tell(measure_stage, 0.5);
    made.roots = roots_along(made.axis, hollow, lines, outside.surface, made.canals);
  }
  const cavity::SliceKnowledge known =
      cavity::slice_knowledge(outside.surface, made.slice_spacing, lines.chamber_radius, hollow.mouths);
  for (std::size_t c = 0; c < made.canals.size(); ++c)
    made.uncertainties.push_back(
        cavity::uncertainty_of(made.canals[c], made.shapes[c], lines.canals[c], hollow.wall, known));
  made.graph = canal_graph(lines);
  for (const CanalPart& part : made.graph.parts) made.parts.push_back(measured(lines, made.graph, part));
  made.lines = std::move(lines);
  progress.tell(measure_stage, 1);
  return made;
}

}  // namespace odontoscope
