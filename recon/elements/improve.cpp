#include "recon/elements/improve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "recon/delaunay/face_table.h"
#include "recon/elements/end_heights.h"
#include "recon/elements/limits.h"
#include "recon/mesh/corners.h"
#include "recon/mesh/exact_predicates.h"

namespace odontoscope::elements {
namespace {

/// Of a tetrahedron: the least sine of its dihedral angles, negative if it is turned inside out. Small for angles near
/// 0 and near 180 degrees.
double least_sine(const std::array<Point3, 4>& p) {
  std::array<Direction, 4> normals;  // outwards, twice the area long
  for (std::size_t i = 0; i < 4; ++i)
    normals[i] = normal_of({p[outward_face[i][0]], p[outward_face[i][1]], p[outward_face[i][2]]});
  double least = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double lengths = length(normals[i]) * length(normals[j]);
      if (!(lengths > 0)) return -1;
      least = std::min(least, length(cross(normals[i], normals[j])) / lengths);
    }
  }
  const bool positive = dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) > 0;
  return positive ? least : -least;
}

class Improver {
 public:
  Improver(LabelledComplex& complex, const InterfaceShape& exact, const Progress& progress)
      : mesh_(complex.mesh),
        interfaces_(complex.interfaces),
        exact_(exact),
        progress_(progress),
        around_(mesh_.points.size()),
        faces_(mesh_.points.size()),
        kind_(mesh_.points.size(), Kind::inside) {
    for (std::uint32_t t = 0; t < mesh_.tetrahedra.size(); ++t)
      for (const PointIndex v : mesh_.tetrahedra[t]) around_[v].push_back(t);
    for (std::uint32_t f = 0; f < interfaces_.size(); ++f)
      for (const PointIndex v : interfaces_[f].triangle) faces_[v].push_back(f);
    tell_kinds();
  }

  void run() {
    for (int pass = 0; pass < limits::improving_passes; ++pass) {
      std::vector<std::pair<double, std::uint32_t>> bad;
      for (std::uint32_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
        if (mesh_.labels[t] == void_label) continue;
        if (const double sine = sine_of(t); sine < limits::bad_sine) bad.emplace_back(sine, t);
      }
      std::sort(bad.begin(), bad.end());
      bool moved = false;
      for (const auto& [sine, t] : bad) {
        progress_.check();
        if (sine_of(t) >= limits::bad_sine) continue;
        for (const PointIndex v : mesh_.tetrahedra[t]) moved = better(v) || moved;
      }
      if (!moved) break;
    }
  }

 private:
  enum class Kind { inside, surface, fixed };

  void tell_kinds() {
    const InterfaceWeb web(mesh_.points, interfaces_);
    const std::vector<double> heights = end_heights(web);
    for (PointIndex v = 0; v < mesh_.points.size(); ++v) {
      if (faces_[v].empty()) continue;
      const bool flat =
          std::any_of(faces_[v].begin(), faces_[v].end(), [&](std::uint32_t f) { return is_level(web, f, heights); });
      kind_[v] =
          flat || InterfaceWeb::stratum(web.ring(v)) != InterfaceWeb::Stratum::surface ? Kind::fixed : Kind::surface;
    }
    delaunay::each_outer_face(mesh_.tetrahedra, [&](const Triangle& face) {
      for (const PointIndex v : face) kind_[v] = Kind::fixed;
    });
  }

  std::array<Point3, 4> corners(std::uint32_t t, PointIndex moved, const Point3& at) const {
    std::array<Point3, 4> p;
    for (std::size_t i = 0; i < 4; ++i)
      p[i] = mesh_.tetrahedra[t][i] == moved ? at : mesh_.points[mesh_.tetrahedra[t][i]];
    return p;
  }
  double sine_of(std::uint32_t t) const {
    const auto& tet = mesh_.tetrahedra[t];
    return least_sine(corners(t, tet[0], mesh_.points[tet[0]]));
  }

  /// Of the elements round a vertex, were it at `at`. Not more than `enough` is asked for: it may end early below that.
  double worst(PointIndex v, const Point3& at, double enough) const {
    double least = 1;
    for (const std::uint32_t t : around_[v]) {
      if (mesh_.labels[t] == void_label) continue;
      least = std::min(least, least_sine(corners(t, v, at)));
      if (least <= enough) return least;
    }
    return least;
  }

  /// Exact.
  bool all_positive(PointIndex v, const Point3& at) const {
    return std::all_of(around_[v].begin(), around_[v].end(), [&](std::uint32_t t) {
      const auto p = corners(t, v, at);
      return orientation(p[0], p[1], p[2], p[3]) > 0;
    });
  }

  double mean_edge(PointIndex v) const {
    double sum = 0;
    std::size_t count = 0;
    for (const std::uint32_t t : around_[v]) {
      if (mesh_.labels[t] == void_label) continue;
      for (const PointIndex w : mesh_.tetrahedra[t])
        if (w != v) sum += length(mesh_.points[w] - mesh_.points[v]), ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : 0;
  }

  /// Tries places around, nearer and nearer, and takes each that makes the worst element of the vertex better.
  bool better(PointIndex v) {
    if (kind_[v] == Kind::fixed) return false;
    static constexpr double d = 0.57735026918962576;  // 1 / sqrt(3)
    static constexpr Direction ways[] = {{1, 0, 0},  {-1, 0, 0},  {0, 1, 0},   {0, -1, 0},  {0, 0, 1},
                                         {0, 0, -1}, {d, d, d},   {d, d, -d},  {d, -d, d},  {d, -d, -d},
                                         {-d, d, d}, {-d, d, -d}, {-d, -d, d}, {-d, -d, -d}};
    const double edge = mean_edge(v);
    double best = worst(v, mesh_.points[v], -1);
    bool moved = false;
    for (double step = limits::first_step; step >= limits::last_step; step /= 2) {
      std::optional<Point3> place;
      for (const Direction& way : ways) {
        const std::optional<Point3> at = placed(v, step * edge * way);
        if (!at) continue;
        const double sine = worst(v, *at, best);
        if (sine <= best || !all_positive(v, *at) || (kind_[v] == Kind::surface && !keeps_surface(v, *at, edge)))
          continue;
        best = sine;
        place = at;
      }
      if (!place) continue;
      mesh_.points[v] = *place;
      moved = true;
    }
    return moved;
  }

  std::optional<Point3> placed(PointIndex v, const Direction& shift) const {
    const Point3& own = mesh_.points[v];
    const Point3 at{own.x + shift.x, own.y + shift.y, own.z + shift.z};
    if (kind_[v] == Kind::inside) return at;
    const InterfaceTriangle& face = interfaces_[faces_[v][0]];
    const LabelPair sides{face.inner, face.outer};
    // It keeps its distance to the exact surface, which is there for the volume.
    const Point3 from = exact_.on_faces(sides, own).at, to = exact_.on_faces(sides, at).at;
    const Direction off = own - from;
    return Point3{to.x + off.x, to.y + off.y, to.z + off.z};
  }

  bool keeps_surface(PointIndex v, const Point3& at, double edge) const {
    return std::all_of(faces_[v].begin(), faces_[v].end(), [&](std::uint32_t f) {
      const InterfaceTriangle& face = interfaces_[f];
      Corners was, is;
      for (std::size_t i = 0; i < 3; ++i) {
        was[i] = mesh_.points[face.triangle[i]];
        is[i] = face.triangle[i] == v ? at : was[i];
      }
      const Direction before = normal_of(was), now = normal_of(is);
      if (!(dot(before, now) > limits::turned_cosine * length(before) * length(now))) return false;
      return exact_.on_faces({face.inner, face.outer}, middle_of(is)).distance <= limits::astray * edge;
    });
  }

  TetraMesh& mesh_;
  const std::vector<InterfaceTriangle>& interfaces_;
  const InterfaceShape& exact_;
  const Progress& progress_;
  std::vector<std::vector<std::uint32_t>> around_, faces_;  // tetrahedra and interface triangles of each vertex
  std::vector<Kind> kind_;
};

}  // namespace

void improve(LabelledComplex& complex, const InterfaceShape& exact, const Progress& progress) {
  Improver(complex, exact, progress).run();
}

}  // namespace odontoscope::elements
