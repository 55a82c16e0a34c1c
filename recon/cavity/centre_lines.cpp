#include "recon/cavity/centre_lines.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <tuple>

#include "recon/cavity/branches.h"
#include "recon/cavity/canal_names.h"
#include "recon/cavity/centring.h"
#include "recon/cavity/forks.h"
#include "recon/cavity/limits.h"
#include "recon/cavity/orifice.h"
#include "recon/core/error.h"

namespace odontoscope {
namespace {

constexpr std::string_view centre_line_stage = "centre lines";

/// Which way the crown is: against the longest branch.
std::optional<Direction> towards_crown(const std::optional<Direction>& axis, const Point3& chamber,
                                       const std::vector<cavity::Branch>& branches) {
  if (!axis || branches.empty() || !(length(*axis) > 0)) return std::nullopt;
  const auto longest = std::max_element(branches.begin(), branches.end(),
                                        [](const auto& a, const auto& b) { return a.beyond < b.beyond; });
  const Direction unit = (1 / length(*axis)) * *axis;
  return dot(unit, longest->path.back() - chamber) > 0 ? -1.0 * unit : unit;
}

/// From its orifice to the wall at its end, against its mean width there.
bool shorter_than_wide(const CentreLine& line) {
  double sum = 0;
  for (std::size_t i = line.orifice; i < line.points.size(); ++i) sum += line.points[i].radius;
  const double mean_width = 2 * sum / static_cast<double>(line.points.size() - line.orifice);
  return line.length_to_wall() < mean_width;
}

/// Short branches that are canals, the longest first: the next may leave one of them.
void take_forks(CentreLines& lines, const WallTree& tree, const Direction& crown) {
  std::vector<CentreLine> left = std::move(lines.others);
  std::stable_sort(left.begin(), left.end(), [](const CentreLine& a, const CentreLine& b) {
    return a.points.back().along > b.points.back().along;
  });
  lines.others.clear();
  for (CentreLine& branch : left) {
    if (!cavity::is_fork(branch, lines.canals, tree, crown)) {
      lines.others.push_back(std::move(branch));
      continue;
    }
    const cavity::BranchShape shape = cavity::branch_shape(branch, lines.canals, tree);
    const CentreLine& parent = lines.canals[shape.parent];
    const Point3& orifice = parent.points[parent.orifice].at;  // they share their way to the chamber
    if (lines.has_chamber) {
      const auto nearer = [&](const CentrePoint& a, const CentrePoint& b) {
        return length(a.at - orifice) < length(b.at - orifice);
      };
      branch.orifice = static_cast<std::size_t>(
          std::min_element(branch.points.begin(), branch.points.begin() + static_cast<std::ptrdiff_t>(shape.leaves) + 1,
                           nearer) -
          branch.points.begin());
    }
    lines.canals.push_back(std::move(branch));
  }
}

void order(std::vector<CentreLine>& lines, const char* kind) {
  std::sort(lines.begin(), lines.end(), [](const CentreLine& a, const CentreLine& b) {
    const auto key = [](const CentreLine& line) {
      return std::tuple{-line.points.back().along, line.end.x, line.end.y, line.end.z};
    };
    return key(a) < key(b);
  });
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i].name = fmt::format("{} {}", kind, i + 1);
}

}  // namespace

double CentreLine::length_to_wall() const {
  const CentrePoint &first = points[std::min(orifice, points.size() - 1)], &last = points.back();
  return last.along - first.along + length(end - last.at) + (orifice == 0 ? length(first.at - start) : 0);
}

CentreLines centre_lines(const Cavity& cavity, const CentreLineOptions& options, const Progress& progress) {
  progress.tell(centre_line_stage, 0);
  const SurfaceReport report = inspect(cavity.wall);
  if (!report.closed_oriented_manifold() || report.shells.size() != 1)
    throw UsageError(
        fmt::format("the wall of the void in \"{}\" is not one closed, oriented manifold", cavity.structure));
  const WallTree tree(cavity.wall);
  const cavity::MedialGraph graph = cavity::medial_graph(cavity.wall, tree, progress);
  CentreLines lines;
  if (graph.nodes.empty()) return lines;  // a crack: no centre of a tetrahedron lies in it
  progress.tell(centre_line_stage, 0.5);
  const cavity::Branches found = cavity::find_branches(graph, cavity.wall, report.shells.front().genus, options.axis);
  lines.chamber = graph.nodes[found.root].at;
  lines.chamber_radius = tree.clearance(lines.chamber);
  lines.has_chamber = found.has_chamber;
  double longest = 0;
  for (const cavity::Branch& branch : found.branches) longest = std::max(longest, branch.beyond);
  const std::optional<Direction> crown = towards_crown(options.axis, lines.chamber, found.branches);
  // Each line by itself, whatever the number of threads.
  std::vector<CentreLine> centred(found.branches.size());
  std::atomic<std::size_t> done{0};
  tbb::parallel_for(std::size_t{0}, centred.size(), [&](std::size_t i) {
    progress.check();
    centred[i] = cavity::centred(found.branches[i].path, tree,
                                 found.through ? cavity::LineEnd::both_blind : cavity::LineEnd::blind);
    progress.tell(centre_line_stage, 0.5 + 0.5 * static_cast<double>(++done) / static_cast<double>(centred.size()));
  });
  for (std::size_t i = 0; i < centred.size(); ++i) {
    CentreLine& line = centred[i];
    const bool to_crown = crown && found.has_chamber && dot(*crown, line.end - lines.chamber) > 0;
    if (to_crown) {
      lines.horns.push_back(std::move(line));
    } else if (found.branches[i].beyond < limits::canal_share * longest) {
      lines.others.push_back(std::move(line));
    } else {
      if (found.has_chamber) line.orifice = cavity::orifice_of(line, lines.chamber_radius, tree);
      if (shorter_than_wide(line)) {
        line.orifice = 0;
        lines.others.push_back(std::move(line));
      } else {
        lines.canals.push_back(std::move(line));
      }
    }
  }
  if (crown) take_forks(lines, tree, *crown);
  std::vector<CentreLine> isthmuses;
  for (const std::vector<Point3>& way : found.isthmuses)
    isthmuses.push_back(cavity::centred(way, tree, cavity::LineEnd::joined));
  for (const std::vector<Point3>& loop : found.loops)
    lines.loops.push_back(cavity::centred(loop, tree, cavity::LineEnd::closed));
  order(lines.canals, "canal");
  order(lines.horns, "horn");
  order(lines.others, "branch");
  order(lines.loops, "loop");
  order(isthmuses, "isthmus");
  std::move(isthmuses.begin(), isthmuses.end(), std::back_inserter(lines.others));
  name_as_sample(lines);
  progress.tell(centre_line_stage, 1);
  return lines;
}

}  // namespace odontoscope
