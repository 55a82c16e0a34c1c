#include "recon/cavity/forks.h"

#include <algorithm>
#include <limits>

#include "recon/cavity/limits.h"

namespace odontoscope::cavity {
namespace {

std::size_t nearest_point(const Point3& p, const CentreLine& line) {
  const auto nearer = [&](const CentrePoint& a, const CentrePoint& b) { return length(a.at - p) < length(b.at - p); };
  return static_cast<std::size_t>(std::min_element(line.points.begin(), line.points.end(), nearer) -
                                  line.points.begin());
}

/// The straight way between the two leaves the void.
bool material_between(const Point3& a, const Point3& b, const WallTree& tree) {
  constexpr int parts = 12;
  for (int i = 1; i < parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    if (tree.clearance({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)}) < 0)
      return true;
  }
  return false;
}

/// Beyond the canal's ball, with material above and below along the canal: what leaves sideways is straight in sight,
/// but a fin goes on up or down.
bool leaves_sideways(const Point3& p, const CentreLine& canal, const WallTree& tree) {
  constexpr double beyond = 2.5;  // of its balls: more than a slanting tube is wide
  const std::size_t i = nearest_point(p, canal);
  if (length(p - canal.points[i].at) < canal.points[i].ball) return false;
  const Direction along =
      canal.points[std::min(i + 1, canal.points.size() - 1)].at - canal.points[i > 0 ? i - 1 : 0].at;
  const double step = beyond * std::max(tree.clearance(p), 0.0) / std::max(length(along), 1e-12);
  return tree.clearance({p.x + step * along.x, p.y + step * along.y, p.z + step * along.z}) < 0 &&
         tree.clearance({p.x - step * along.x, p.y - step * along.y, p.z - step * along.z}) < 0;
}

}  // namespace

BranchShape branch_shape(const CentreLine& branch, const std::vector<CentreLine>& canals, const WallTree& tree,
                         Apart apart) {
  BranchShape shape;
  shape.leaves = branch.points.size();
  const auto lies_apart = [&](const Point3& p) {
    return std::all_of(canals.begin(), canals.end(), [&](const CentreLine& canal) {
      return material_between(p, canal.points[nearest_point(p, canal)].at, tree) ||
             (apart == Apart::or_sideways && leaves_sideways(p, canal, tree));
    });
  };
  while (shape.leaves > 0 && lies_apart(branch.points[shape.leaves - 1].at)) --shape.leaves;
  if (shape.leaves == branch.points.size()) return shape;
  double nearest = std::numeric_limits<double>::infinity(), sum = 0;
  const CentrePoint& first = branch.points[shape.leaves];
  for (std::size_t c = 0; c < canals.size(); ++c) {
    const double far = length(canals[c].points[nearest_point(first.at, canals[c])].at - first.at);
    if (far >= nearest) continue;
    nearest = far;
    shape.parent = c;
  }
  shape.length = branch.points.back().along - first.along + length(branch.end - branch.points.back().at);
  for (std::size_t i = shape.leaves; i < branch.points.size(); ++i) sum += branch.points[i].ball;
  shape.mean_width = 2 * sum / static_cast<double>(branch.points.size() - shape.leaves);
  return shape;
}

bool is_fork(const CentreLine& branch, const std::vector<CentreLine>& canals, const WallTree& tree,
             const Direction& crown) {
  if (canals.empty()) return false;
  const BranchShape shape = branch_shape(branch, canals, tree);
  if (shape.leaves == branch.points.size() || shape.length < limits::fork_length * shape.mean_width) return false;
  const CentrePoint& first = branch.points[shape.leaves];
  const CentreLine& parent = canals[shape.parent];
  const double parent_width = 2 * parent.points[nearest_point(first.at, parent)].ball;
  const Direction way = branch.end - first.at;
  constexpr double apical = 0.5;  // cosine of 60 degrees
  return shape.mean_width >= limits::fork_width * parent_width && dot(way, crown) < -apical * length(way);
}

}  // namespace odontoscope::cavity
