#include "recon/distance/marching_cubes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/parallel.h"

namespace odontoscope {
namespace {

constexpr std::string_view marching_stage = "marching cubes";

/// Four corners of a cell on one column, as bits of its case: (y, z) at bit 2 y + 4 z, for x = 0; shifted by one for x
/// = 1.
class CaseRow {
 public:
  CaseRow(const Grid& grid, const Field& field) : grid_(grid), field_(field), bits_(grid.columns) {}

  void read(std::size_t row, std::size_t layer) {
    const double* const low = &field_.values[grid_.index(0, row, layer)];
    const double *const next = low + grid_.columns, *const high = low + grid_.layer_size(),
                        *const high_next = high + grid_.columns;
    for (std::size_t i = 0; i < grid_.columns; ++i) {
      bits_[i] = static_cast<std::uint8_t>((low[i] < 0 ? 1 : 0) | (next[i] < 0 ? 1 << 2 : 0) |
                                           (high[i] < 0 ? 1 << 4 : 0) | (high_next[i] < 0 ? 1 << 6 : 0));
    }
  }
  CaseNumber at(std::size_t column) const { return static_cast<CaseNumber>(bits_[column] | bits_[column + 1] << 1); }

 private:
  const Grid& grid_;
  const Field& field_;
  std::vector<std::uint8_t> bits_;
};

/// Points come layer by layer: those on a layer's own edges, then those between it and the next.
struct Counts {
  std::size_t in_plane = 0, upright = 0, triangles = 0;
};

class Marcher {
 public:
  Marcher(const Grid& grid, const Field& field, CaseTable table, const Progress& progress)
      : grid_(grid), field_(field), cases_(cell_triangles(table)), progress_(progress), counts_(grid.layers.size()) {}

  MarchedSurface run() {
    constexpr double count_share = 0.3;
    for_each(grid_.layers.size(), marching_stage, Share{0, count_share}, progress_,
             [this](std::size_t k) { count(k); });
    number();
    for_each(grid_.layers.size(), marching_stage, Share{count_share, 1}, progress_, [this](std::size_t k) { fill(k); });
    return std::move(surface_);
  }

 private:
  bool inside(std::size_t index) const { return field_.values[index] < 0; }
  bool last(std::size_t layer) const { return layer + 1 == grid_.layers.size(); }

  /// Calls visit(edge, point index of its far end) for each crossed edge that starts on the layer along the given axes,
  /// in order.
  template <class Visit>
  void crossed_edges(std::size_t layer, int first_axis, int last_axis, Visit visit) const {
    const std::array<std::size_t, 3> step{1, grid_.columns, grid_.layer_size()};
    for (std::size_t row = 0; row < grid_.rows; ++row) {
      for (std::size_t column = 0; column < grid_.columns; ++column) {
        const std::size_t here = grid_.index(column, row, layer);
        for (int axis = first_axis; axis <= last_axis; ++axis) {
          if ((axis == 0 && column + 1 == grid_.columns) || (axis == 1 && row + 1 == grid_.rows)) continue;
          if (inside(here) == inside(here + step[axis])) continue;
          visit(GridEdge{{static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row),
                          static_cast<std::uint32_t>(layer)},
                         static_cast<std::uint8_t>(axis)},
                here, here + step[axis]);
        }
      }
    }
  }

  void count(std::size_t layer) {
    Counts& counts = counts_[layer];
    crossed_edges(layer, 0, 1, [&](const auto&...) { ++counts.in_plane; });
    if (last(layer)) return;
    crossed_edges(layer, 2, 2, [&](const auto&...) { ++counts.upright; });
    CaseRow row_of_cases(grid_, field_);
    for (std::size_t row = 0; row + 1 < grid_.rows; ++row) {
      row_of_cases.read(row, layer);
      for (std::size_t column = 0; column + 1 < grid_.columns; ++column)
        counts.triangles += cases_[row_of_cases.at(column)].count;
    }
  }

  /// Counts become the numbers of the first point or triangle of their kind.
  void number() {
    std::size_t points = 0, triangles = 0;
    for (Counts& counts : counts_) {
      const Counts here = counts;
      counts = {points, points + here.in_plane, triangles};
      points += here.in_plane + here.upright;
      triangles += here.triangles;
    }
    if (triangles > limits::triangles || points >= std::numeric_limits<PointIndex>::max()) {
      throw UsageError(
          fmt::format("the grid gives a surface of {} triangles, more than {}", triangles, limits::triangles),
          "Use a coarser grid");
    }
    surface_.mesh.points.resize(points);
    surface_.edge_of_point.resize(points);
    surface_.mesh.triangles.resize(triangles);
    surface_.cell_of_triangle.resize(triangles);
  }

  Point3 point_on(const GridEdge& edge, std::size_t from, std::size_t to) const {
    const double here = field_.values[from], there = field_.values[to];
    const double share = std::clamp(here / (here - there), 0.0, 1.0);
    std::array<std::size_t, 3> end{edge.from[0], edge.from[1], edge.from[2]};
    const Point3 a = grid_.point(end[0], end[1], end[2]);
    ++end[edge.axis];
    const Point3 b = grid_.point(end[0], end[1], end[2]);
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
  }

  /// Numbers of the points on one layer's edges: along x and y in its plane, or upright along z.
  struct PointNumbers {
    std::array<std::vector<PointIndex>, 3> along;
  };

  void number_edges(std::size_t layer, int first_axis, int last_axis, std::size_t first, bool place,
                    PointNumbers& numbers) {
    for (int axis = first_axis; axis <= last_axis; ++axis) numbers.along[axis].resize(grid_.layer_size());
    std::size_t next = first;
    crossed_edges(layer, first_axis, last_axis, [&](const GridEdge& edge, std::size_t from, std::size_t to) {
      numbers.along[edge.axis][from - layer * grid_.layer_size()] = static_cast<PointIndex>(next);
      if (place) {
        surface_.mesh.points[next] = point_on(edge, from, to);
        surface_.edge_of_point[next] = edge;
      }
      ++next;
    });
  }

  void fill(std::size_t layer) {
    PointNumbers lower, upper;
    number_edges(layer, 0, 1, counts_[layer].in_plane, true, lower);
    if (last(layer)) return;
    number_edges(layer, 2, 2, counts_[layer].upright, true, lower);
    number_edges(layer + 1, 0, 1, counts_[layer + 1].in_plane, false, upper);
    CaseRow row_of_cases(grid_, field_);
    std::size_t next = counts_[layer].triangles;
    for (std::size_t row = 0; row + 1 < grid_.rows; ++row) {
      row_of_cases.read(row, layer);
      for (std::size_t column = 0; column + 1 < grid_.columns; ++column) {
        const CellTriangles& cell = cases_[row_of_cases.at(column)];
        for (const auto& triangle : cell.triangles()) {
          for (int i = 0; i < 3; ++i) {
            surface_.mesh.triangles[next][i] = point_of(triangle[i], row * grid_.columns + column, lower, upper);
          }
          surface_.cell_of_triangle[next] = {static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row),
                                             static_cast<std::uint32_t>(layer)};
          ++next;
        }
      }
    }
  }

  PointIndex point_of(CellEdge edge, std::size_t place, const PointNumbers& lower, const PointNumbers& upper) const {
    const int corner = corners_of(edge)[0];
    const PointNumbers& numbers = (corner & 4) != 0 ? upper : lower;
    return numbers.along[edge / 4][place + ((corner & 1) != 0 ? 1 : 0) + ((corner & 2) != 0 ? grid_.columns : 0)];
  }

  const Grid& grid_;
  const Field& field_;
  const std::array<CellTriangles, 256>& cases_;
  const Progress& progress_;
  std::vector<Counts> counts_;
  MarchedSurface surface_;
};

void check_border(const Grid& grid, const Field& field) {
  if (field.values.size() != grid.size()) throw InternalError("a field and a grid do not belong together");
  const auto negative = [&](std::size_t column, std::size_t row, std::size_t layer) {
    return field.values[grid.index(column, row, layer)] < 0;
  };
  bool leaves = false;
  for (std::size_t layer = 0; layer < grid.layers.size(); ++layer) {
    const bool end = layer == 0 || layer + 1 == grid.layers.size();
    for (std::size_t row = 0; row < grid.rows; ++row) {
      const std::size_t step = end || row == 0 || row + 1 == grid.rows ? 1 : grid.columns - 1;
      for (std::size_t column = 0; column < grid.columns; column += step)
        leaves = leaves || negative(column, row, layer);
    }
  }
  if (leaves) throw InternalError("the surface leaves the grid");
}

}  // namespace

MarchedSurface march(const Grid& grid, const Field& field, CaseTable table, const Progress& progress) {
  check_border(grid, field);
  return Marcher(grid, field, table, progress).run();
}

CaseNumber case_at(const Grid& grid, const Field& field, const GridPlace& cell) {
  unsigned bits = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const std::size_t index =
        grid.index(cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2 & 1));
    bits |= static_cast<unsigned>(field.values[index] < 0) << corner;
  }
  return static_cast<CaseNumber>(bits);
}

}  // namespace odontoscope
