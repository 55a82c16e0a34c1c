#include "recon/distance/defects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "recon/core/error.h"
#include "recon/core/parallel.h"
#include "recon/mesh/half_edges.h"

namespace odontoscope {
namespace {

struct Face {
  GridPlace at;  // its lowest corner
  int axis;      // of its normal
};

/// The one face that has both edges.
Face common_face(const GridEdge& a, const GridEdge& b) {
  Face face{a.from, 0};
  for (int i = 0; i < 3; ++i) face.at[i] = std::min(a.from[i], b.from[i]);
  if (a.axis != b.axis) {
    face.axis = 3 - a.axis - b.axis;
    return face;
  }
  for (int i = 0; i < 3; ++i) {
    if (i != a.axis && a.from[i] == b.from[i]) face.axis = i;
  }
  return face;
}

Point3 middle(const Point3& a, const Point3& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}; }

Defect defect_at(const Grid& grid, const Field& field, const SurfaceMesh& mesh, const Face& face, DefectKind kind,
                 PointIndex a, PointIndex b) {
  Defect defect{.kind = kind,
                .from = std::min(a, b),
                .to = std::max(a, b),
                .at = {},
                .axis = face.axis,
                .first = face.at,
                .second = face.at};
  if (defect.first[face.axis] == 0) throw InternalError("a defect on the border of the grid");
  --defect.first[face.axis];
  defect.at = middle(mesh.points[defect.from], mesh.points[defect.to]);
  defect.first_case = case_at(grid, field, defect.first);
  defect.second_case = case_at(grid, field, defect.second);
  defect.ambiguous_face = is_ambiguous(defect.second_case, static_cast<CellFace>(2 * face.axis));
  return defect;
}

void sort(std::vector<Defect>& defects) {
  std::sort(defects.begin(), defects.end(), [](const Defect& a, const Defect& b) {
    return std::tie(a.from, a.to, a.kind) < std::tie(b.from, b.to, b.kind);
  });
}

// --- from the table --------------------------------------------------------------------------------------------------

/// The point on a grid edge, found in the sorted list of the surface's.
class PointFinder {
 public:
  explicit PointFinder(const MarchedSurface& surface) : edges_(surface.edge_of_point) {}

  PointIndex operator()(const GridEdge& edge) const {
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), edge,
                                        [](const GridEdge& a, const GridEdge& b) { return order(a) < order(b); });
    if (found == edges_.end() || *found != edge)
      throw InternalError("a table uses an edge that the surface does not cross");
    return static_cast<PointIndex>(found - edges_.begin());
  }

 private:
  /// Points of a layer's own edges come before those on its upright ones.
  static std::tuple<std::uint32_t, bool, std::uint32_t, std::uint32_t, std::uint8_t> order(const GridEdge& e) {
    return {e.from[2], e.axis == 2, e.from[1], e.from[0], e.axis};
  }
  const std::vector<GridEdge>& edges_;
};

/// Every meeting of two cases, for each axis, that leaves a defect.
class Meetings {
 public:
  explicit Meetings(CaseTable table) : all_(std::size_t{3} << 16) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int first = 0; first < 256; ++first) {
        for (int second = 0; second < 256; ++second) {
          if (!share_corners(first, second, axis)) continue;
          all_[place(first, second, axis)] =
              meeting(table, static_cast<CaseNumber>(first), static_cast<CaseNumber>(second), axis);
        }
      }
    }
  }
  const FaceMeeting& operator()(CaseNumber first, CaseNumber second, int axis) const {
    return all_[place(first, second, axis)];
  }

 private:
  static std::size_t place(int first, int second, int axis) {
    return static_cast<std::size_t>(axis << 16 | first << 8 | second);
  }
  static bool share_corners(int first, int second, int axis) {
    for (int corner = 0; corner < 8; ++corner) {
      if ((corner >> axis & 1) == 0 && (second >> corner & 1) != (first >> (corner | 1 << axis) & 1)) return false;
    }
    return true;
  }
  std::vector<FaceMeeting> all_;
};

GridEdge edge_of_face(const Face& face, std::uint8_t place) {
  const CellEdge edge = edges_of(static_cast<CellFace>(2 * face.axis))[place];
  const int corner = corners_of(edge)[0];
  GridEdge result{face.at, static_cast<std::uint8_t>(edge / 4)};
  for (int axis = 0; axis < 3; ++axis) result.from[axis] += static_cast<std::uint32_t>(corner >> axis & 1);
  return result;
}

}  // namespace

const char* name(DefectKind kind) {
  switch (kind) {
    case DefectKind::crack:
      return "crack";
    case DefectKind::misoriented:
      return "misoriented";
    case DefectKind::nonmanifold:
      return "non-manifold";
  }
  return "";
}

std::vector<Defect> defects_of(const Grid& grid, const Field& field, const MarchedSurface& surface) {
  const SurfaceMesh& mesh = surface.mesh;
  const EdgeMates edges = edge_mates(mesh);
  std::vector<Defect> defects;
  for (HalfEdge h = 0; h < edges.mate.size(); ++h) {
    const HalfEdge mate = edges.mate[h];
    const PointIndex a = start(mesh, h), b = end(mesh, h);
    const bool crowded = mate == EdgeMates::many;
    const bool misoriented = mate < EdgeMates::no_edge && mate > h && start(mesh, mate) == a;
    if (mate != EdgeMates::none && !crowded && !misoriented) continue;
    const DefectKind kind = crowded       ? DefectKind::nonmanifold
                            : misoriented ? DefectKind::misoriented
                                          : DefectKind::crack;
    const Face face = common_face(surface.edge_of_point[a], surface.edge_of_point[b]);
    defects.push_back(defect_at(grid, field, mesh, face, kind, a, b));
  }
  sort(defects);
  defects.erase(std::unique(defects.begin(), defects.end()), defects.end());  // a crowded edge is met several times
  return defects;
}

std::vector<Defect> predicted_defects(const Grid& grid, const Field& field, CaseTable table,
                                      const MarchedSurface& surface, const Progress& progress) {
  const Meetings meetings(table);
  const PointFinder point(surface);
  std::vector<std::vector<Defect>> by_layer(grid.layers.size() - 1);
  for_each(by_layer.size(), "predict defects", {}, progress, [&](std::size_t layer) {
    for (std::uint32_t row = 0; row + 1 < grid.rows; ++row) {
      for (std::uint32_t column = 0; column + 1 < grid.columns; ++column) {
        const GridPlace cell{column, row, static_cast<std::uint32_t>(layer)};
        const CaseNumber second = case_at(grid, field, cell);
        if (second == 0 || second == 255) continue;
        for (int axis = 0; axis < 3; ++axis) {
          if (cell[axis] == 0) continue;
          GridPlace before = cell;
          --before[axis];
          const FaceMeeting& met = meetings(case_at(grid, field, before), second, axis);
          const Face face{cell, axis};
          const auto add = [&](const FaceSegment& s, DefectKind kind) {
            by_layer[layer].push_back(defect_at(grid, field, surface.mesh, face, kind,
                                                point(edge_of_face(face, s.from)), point(edge_of_face(face, s.to))));
          };
          for (const FaceSegment& s : met.unmatched) add(s, DefectKind::crack);
          for (const FaceSegment& s : met.misoriented) add(s, DefectKind::misoriented);
        }
      }
    }
  });
  std::vector<Defect> defects;
  for (const auto& layer : by_layer) defects.insert(defects.end(), layer.begin(), layer.end());
  sort(defects);
  return defects;
}

std::string in_words(const Defect& defect, CaseTable table) {
  const auto& cells = cell_triangles(table);
  const auto cell = [&](const GridPlace& at, CaseNumber number) {
    const CellTriangles& known = cells[number];
    return fmt::format("cell ({}, {}, {}), case {} ({}base case {})", at[0], at[1], at[2], number,
                       known.complement ? "complement of " : "", known.base);
  };
  std::string where =
      fmt::format("Table {}: {} and {} share a face across {}", name(table), cell(defect.first, defect.first_case),
                  cell(defect.second, defect.second_case), "xyz"[defect.axis]);
  switch (defect.kind) {
    case DefectKind::crack:
      return where +
             ". Two of its corners, across a diagonal, are inside; one cell keeps these two apart, the other the two "
             "that are outside, so this edge has a triangle on one side only: a crack.";
    case DefectKind::misoriented:
      return where +
             ". One case is the complement of its base case, and its triangles were not turned over: the two "
             "triangles at this edge face opposite sides, and one is invisible once back faces are culled.";
    case DefectKind::nonmanifold:
      return where + ". More than two triangles meet in this edge.";
  }
  return where;
}

}  // namespace odontoscope
