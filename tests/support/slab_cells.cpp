#include "tests/support/slab_cells.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "tests/support/joined.h"

namespace odontoscope::test {
namespace {

using Edge = std::array<PointIndex, 2>;
using Face = std::array<PointIndex, 3>;

template <std::size_t n>
std::array<PointIndex, n> in_order(std::array<PointIndex, n> cell) {
  std::sort(cell.begin(), cell.end());
  return cell;
}

std::array<Face, 4> faces_of(const Tetrahedron& t) {
  return {in_order<3>({t[0], t[1], t[2]}), in_order<3>({t[0], t[1], t[3]}), in_order<3>({t[0], t[2], t[3]}),
          in_order<3>({t[1], t[2], t[3]})};
}

std::array<Edge, 3> edges_of(const Face& f) { return {Edge{f[0], f[1]}, Edge{f[0], f[2]}, Edge{f[1], f[2]}}; }

/// A piece's face with one tetrahedron.
struct BoundaryFace {
  std::size_t piece;
  Face face;
};

class SlabCounter {
 public:
  SlabCounter(const TetraMesh& mesh, std::vector<Tetrahedron> tetrahedra, double low, double high)
      : mesh_(mesh), tetrahedra_(std::move(tetrahedra)), low_(low), high_(high) {}

  SlabCells count() {
    find_pieces();
    find_boundary();
    const long euler = euler_characteristic();
    result_.bubbles = long(boundary_components()) - long(result_.pieces);
    result_.handles = long(result_.pieces) + result_.bubbles - euler;
    judge_fans();
    find_walls();
    for (auto* list : {&result_.piece_at, &result_.wall_at}) {
      std::sort(list->begin(), list->end());
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    return result_;
  }

 private:
  SlabCells::Place place(PointIndex v) const { return {mesh_.points[v].x, mesh_.points[v].y, mesh_.points[v].z}; }
  bool in_plane(PointIndex v) const { return mesh_.points[v].z == low_ || mesh_.points[v].z == high_; }
  bool in_plane(const Face& f) const {
    const double z = mesh_.points[f[0]].z;
    return in_plane(f[0]) && mesh_.points[f[1]].z == z && mesh_.points[f[2]].z == z;
  }

  void find_pieces() {
    Joined joined(tetrahedra_.size());
    std::map<Face, std::size_t> first;
    for (std::size_t t = 0; t < tetrahedra_.size(); ++t)
      for (const Face& face : faces_of(tetrahedra_[t])) joined.join(t, first.emplace(face, t).first->second);
    piece_of_ = joined.classes(result_.pieces);
    std::map<PointIndex, std::size_t> piece_with;
    for (std::size_t t = 0; t < tetrahedra_.size(); ++t)
      for (PointIndex v : tetrahedra_[t])
        if (piece_with.emplace(v, piece_of_[t]).first->second != piece_of_[t]) result_.manifold = false;
  }

  void find_boundary() {
    std::map<std::pair<std::size_t, Face>, int> uses;
    for (std::size_t t = 0; t < tetrahedra_.size(); ++t)
      for (const Face& face : faces_of(tetrahedra_[t])) ++uses[{piece_of_[t], face}];
    for (const auto& [at, count] : uses) {
      if (count > 2) result_.manifold = false;
      if (count == 1) boundary_.push_back({at.first, at.second});
      if (!in_plane(at.second)) continue;
      for (PointIndex v : at.second) result_.piece_at.emplace_back(place(v), at.first);
    }
  }

  long euler_characteristic() const {
    std::set<std::pair<std::size_t, PointIndex>> vertices;
    std::set<std::pair<std::size_t, Edge>> edges;
    std::set<std::pair<std::size_t, Face>> faces;
    for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
      for (PointIndex v : tetrahedra_[t]) vertices.emplace(piece_of_[t], v);
      for (const Face& face : faces_of(tetrahedra_[t])) {
        faces.emplace(piece_of_[t], face);
        for (const Edge& edge : edges_of(face)) edges.emplace(piece_of_[t], edge);
      }
    }
    return long(vertices.size()) - long(edges.size()) + long(faces.size()) - long(tetrahedra_.size());
  }

  std::size_t boundary_components() {
    Joined joined(boundary_.size());
    std::map<std::pair<std::size_t, Edge>, std::vector<std::size_t>> at_edge;
    for (std::size_t f = 0; f < boundary_.size(); ++f)
      for (const Edge& edge : edges_of(boundary_[f].face)) at_edge[{boundary_[f].piece, edge}].push_back(f);
    for (const auto& [edge, faces] : at_edge) {
      if (faces.size() != 2) result_.manifold = false;
      for (std::size_t f : faces) joined.join(f, faces[0]);
    }
    std::size_t count = 0;
    joined.classes(count);
    return count;
  }

  /// Around each boundary vertex of a piece the faces must be one fan.
  void judge_fans() {
    Joined corners(3 * boundary_.size());
    std::map<std::tuple<std::size_t, PointIndex, PointIndex>, std::size_t>
        first;  // piece, vertex, other end of an edge
    for (std::size_t f = 0; f < boundary_.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          if (i != j)
            corners.join(
                3 * f + i,
                first.emplace(std::tuple(boundary_[f].piece, boundary_[f].face[i], boundary_[f].face[j]), 3 * f + i)
                    .first->second);
    std::map<std::pair<std::size_t, PointIndex>, std::size_t> fan;
    for (std::size_t f = 0; f < boundary_.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t here = corners.find(3 * f + i);
        if (fan.emplace(std::pair(boundary_[f].piece, boundary_[f].face[i]), here).first->second != here)
          result_.manifold = false;
      }
  }

  void find_walls() {
    std::vector<BoundaryFace> walls;
    for (const BoundaryFace& face : boundary_)
      if (!in_plane(face.face)) walls.push_back(face);
    Joined joined(walls.size());
    std::map<std::pair<std::size_t, Edge>, std::size_t> first;
    for (std::size_t w = 0; w < walls.size(); ++w)
      for (const Edge& edge : edges_of(walls[w].face))
        joined.join(w, first.emplace(std::pair(walls[w].piece, edge), w).first->second);
    std::size_t count = 0;
    const std::vector<std::size_t> wall_of = joined.classes(count);
    for (std::size_t w = 0; w < walls.size(); ++w)
      for (PointIndex v : walls[w].face)
        if (in_plane(v)) result_.wall_at.emplace_back(place(v), wall_of[w]);
  }

  const TetraMesh& mesh_;
  std::vector<Tetrahedron> tetrahedra_;
  double low_, high_;
  std::vector<std::size_t> piece_of_;
  std::vector<BoundaryFace> boundary_;
  SlabCells result_;
};

}  // namespace

std::vector<SlabCells> cells_by_slab(const TetraMesh& mesh, const ContourStack& sorted) {
  std::vector<double> heights;
  for (const Slice& slice : sorted.slices) heights.push_back(slice.z);
  std::vector<std::vector<Tetrahedron>> by_slab(heights.size() - 1);
  for (const Tetrahedron& t : mesh.tetrahedra) {
    double top = mesh.points[t[0]].z;
    for (PointIndex v : t) top = std::max(top, mesh.points[v].z);
    const auto upper = std::lower_bound(heights.begin() + 1, heights.end() - 1, top);
    by_slab[std::size_t(upper - heights.begin()) - 1].push_back(t);
  }
  std::vector<SlabCells> cells;
  for (std::size_t k = 0; k < by_slab.size(); ++k)
    cells.push_back(SlabCounter(mesh, std::move(by_slab[k]), heights[k], heights[k + 1]).count());
  return cells;
}

}  // namespace odontoscope::test
