#include "recon/radiograph/sum_through.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "recon/radiograph/film_vector.h"

namespace odontoscope {

using namespace radiograph;

namespace {

using Triple = std::array<double, 3>;

/// A ray in voxels: place + t * way, t in mm, for t from `begin` to `end`.
struct VoxelRay {
  Triple place{}, way{};
  double begin = 0, end = 0;

  double at(std::size_t axis, double t) const { return place[axis] + t * way[axis]; }
};

VoxelRay in_voxels(const Volume& volume, const FilmRay& ray) {
  const Triple origin{volume.origin.x, volume.origin.y, volume.origin.z}, end{ray.end.x, ray.end.y, ray.end.z},
      direction{ray.direction.x, ray.direction.y, ray.direction.z};
  VoxelRay found;
  found.begin = -ray.length;
  found.end = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    found.place[axis] = (end[axis] - origin[axis]) / volume.spacing[axis];
    found.way[axis] = direction[axis] / volume.spacing[axis];
    const double low = -0.5, high = static_cast<double>(volume.size[axis]) - 0.5;
    if (found.way[axis] == 0) {
      if (found.place[axis] < low || found.place[axis] >= high) found.end = -std::numeric_limits<double>::infinity();
      continue;
    }
    const double one = (low - found.place[axis]) / found.way[axis],
                 other = (high - found.place[axis]) / found.way[axis];
    found.begin = std::max(found.begin, std::min(one, other));
    found.end = std::min(found.end, std::max(one, other));
  }
  return found;
}

/// Eight voxels that interpolate a cell; beyond the outermost centres they repeat.
struct Cell {
  std::array<std::ptrdiff_t, 3> low{};
  std::array<double, 8> values{};

  void read(const Volume& volume) {
    std::array<std::array<std::size_t, 2>, 3> index{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto last = static_cast<std::ptrdiff_t>(volume.size[axis]) - 1;
      index[axis] = {static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(low[axis], 0, last)),
                     static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(low[axis] + 1, 0, last))};
    }
    for (std::size_t corner = 0; corner < 8; ++corner)
      values[corner] = static_cast<double>(
          volume.values[(index[2][corner >> 2] * volume.size[1] + index[1][corner >> 1 & 1]) * volume.size[0] +
                        index[0][corner & 1]]);
  }
  double value(const VoxelRay& ray, double t) const {
    Triple part{};
    for (std::size_t axis = 0; axis < 3; ++axis) part[axis] = ray.at(axis, t) - static_cast<double>(low[axis]);
    const auto between = [](double a, double b, double share) { return a + share * (b - a); };
    const double y0 = between(between(values[0], values[1], part[0]), between(values[2], values[3], part[0]), part[1]);
    const double y1 = between(between(values[4], values[5], part[0]), between(values[6], values[7], part[0]), part[1]);
    return between(y0, y1, part[2]);
  }
};

}  // namespace

double sum_along(const Volume& volume, double zero, const FilmRay& along) {
  const VoxelRay ray = in_voxels(volume, along);
  if (!(ray.begin < ray.end)) return 0;
  Cell cell;
  Triple next{};  // where the ray crosses into the next cell along each axis
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double least = -1, most = static_cast<double>(volume.size[axis]) - 1;
    const double low = std::clamp(std::floor(ray.at(axis, ray.begin)), least, most);
    cell.low[axis] = static_cast<std::ptrdiff_t>(low);
  }
  const auto crossing = [&](std::size_t axis) {
    if (ray.way[axis] == 0) return std::numeric_limits<double>::infinity();
    return (static_cast<double>(cell.low[axis] + (ray.way[axis] > 0 ? 1 : 0)) - ray.place[axis]) / ray.way[axis];
  };
  for (std::size_t axis = 0; axis < 3; ++axis) next[axis] = crossing(axis);
  double sum = 0, t = ray.begin;
  while (t < ray.end) {
    const std::size_t axis = static_cast<std::size_t>(std::min_element(next.begin(), next.end()) - next.begin());
    const double to = std::min(next[axis], ray.end);
    if (to > t) {
      cell.read(volume);
      sum += (to - t) / 6 * (cell.value(ray, t) + 4 * cell.value(ray, 0.5 * (t + to)) + cell.value(ray, to)) -
             zero * (to - t);
      t = to;
    }
    if (to >= ray.end) break;
    cell.low[axis] += ray.way[axis] > 0 ? 1 : -1;
    next[axis] = crossing(axis);
  }
  return sum;
}

FilmMap sum_through(const Volume& volume, double zero, const FilmView& view, const Progress& progress) {
  FilmMap map{view.columns, view.rows,
              std::vector<double>(static_cast<std::size_t>(view.columns) * static_cast<std::size_t>(view.rows))};
  tbb::parallel_for(0, view.rows, [&](int row) {
    if (progress.stop.stop_requested()) return;
    for (int column = 0; column < view.columns; ++column)
      map.at(column, row) = sum_along(volume, zero, ray_to(view, column, row));
  });
  progress.check();
  return map;
}

}  // namespace odontoscope
