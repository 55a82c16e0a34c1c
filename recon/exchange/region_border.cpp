#include "recon/exchange/region_border.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "recon/core/polygon.h"
#include "recon/core/portable_math.h"

namespace odontoscope {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
struct FaceInfo {
  static constexpr int unknown = std::numeric_limits<int>::min();
  int winding = unknown;
};
using VertexBase = CGAL::Triangulation_vertex_base_2<Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Plain = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;
using Triangulation = CGAL::Constrained_triangulation_plus_2<Plain>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

Point2 place(Vertex v) { return {v->point().x(), v->point().y()}; }

/// Turns around what lies left of an edge (from, to), over what lies right of it.
using Turns = std::map<std::pair<Vertex, Vertex>, int>;

/// Every pair once, in the order of their handles.
void count_turn(Turns& turns, Vertex from, Vertex to, int times) {
  if (to < from)
    turns[{to, from}] -= times;
  else
    turns[{from, to}] += times;
}

int turn_of(const Turns& turns, Vertex from, Vertex to) {
  const bool reversed = to < from;
  const auto at = turns.find(reversed ? std::pair(to, from) : std::pair(from, to));
  if (at == turns.end()) return 0;
  return reversed ? -at->second : at->second;
}

/// Each edge once, as it is first given, in that order: handles are addresses, whose order differs from run to run.
struct GivenEdges {
  std::vector<std::pair<Vertex, Vertex>> ends;
  Turns turns;  // summed over all times that an edge is given
};

GivenEdges edges_between(Triangulation& triangulation, const std::vector<std::vector<Point2>>& polygons) {
  GivenEdges edges;
  for (const std::vector<Point2>& polygon : polygons) {
    std::vector<Vertex> corners;
    for (const Point2& p : polygon) {
      corners.push_back(
          triangulation.insert(Kernel::Point_2(p.x, p.y), corners.empty() ? Face() : corners.back()->face()));
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vertex from = corners[i], to = corners[(i + 1) % corners.size()];
      if (from == to) continue;
      const std::size_t known = edges.turns.size();
      count_turn(edges.turns, from, to, 1);
      if (edges.turns.size() > known) edges.ends.emplace_back(from, to);
    }
  }
  return edges;
}

Turns insert(Triangulation& triangulation, const std::vector<std::vector<Point2>>& polygons) {
  const GivenEdges given = edges_between(triangulation, polygons);
  std::vector<Triangulation::Constraint_id> constraints;
  for (const auto& [from, to] : given.ends) constraints.push_back(triangulation.insert_constraint(from, to));
  Turns turns;
  for (std::size_t e = 0; e < constraints.size(); ++e) {
    // The pieces that later crossings have cut the edge into, in one direction or the other.
    const std::vector<Vertex> pieces(triangulation.vertices_in_constraint_begin(constraints[e]),
                                     triangulation.vertices_in_constraint_end(constraints[e]));
    const int times = turn_of(given.turns, pieces.front(), pieces.back());
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) count_turn(turns, pieces[i], pieces[i + 1], times);
  }
  return turns;
}

void spread_winding(Triangulation& triangulation, const Turns& turns) {
  std::vector<Face> open{triangulation.infinite_face()};
  open.front()->info().winding = 0;
  while (!open.empty()) {
    const Face face = open.back();
    open.pop_back();
    for (int i = 0; i < 3; ++i) {
      const Face beyond = face->neighbor(i);
      if (beyond->info().winding != FaceInfo::unknown) continue;
      // `face` lies left of the edge from its next corner to the one after.
      const int turn = turn_of(turns, face->vertex(Triangulation::ccw(i)), face->vertex(Triangulation::cw(i)));
      beyond->info().winding = face->info().winding - turn;
      open.push_back(beyond);
    }
  }
}

bool is_inside(Face face, Inside rule) {
  const int winding = face->info().winding;
  return rule == Inside::odd ? winding % 2 != 0 : winding > 0;
}

/// A border with material on its left, corner by corner.
using Loop = std::vector<Vertex>;

std::vector<Loop> loops_of(const Triangulation& triangulation, Inside rule) {
  std::map<std::pair<Vertex, Vertex>, bool> taken;
  std::vector<Loop> loops;
  for (const Face start_face : triangulation.finite_face_handles()) {
    if (!is_inside(start_face, rule)) continue;
    for (int start = 0; start < 3; ++start) {
      Face face = start_face;
      int i = start;  // the border runs from ccw(i) to cw(i) of the face
      if (is_inside(face->neighbor(i), rule)) continue;
      Loop loop;
      for (;;) {
        const Vertex from = face->vertex(Triangulation::ccw(i)), to = face->vertex(Triangulation::cw(i));
        if (taken[{from, to}]) break;
        taken[{from, to}] = true;
        loop.push_back(from);
        // Turn round `to` through the material, to its other side.
        i = Triangulation::ccw(i);
        while (is_inside(face->neighbor(i), rule)) {
          const Face beyond = face->neighbor(i);
          i = Triangulation::cw(beyond->index(to));
          face = beyond;
        }
      }
      if (!loop.empty()) loops.push_back(std::move(loop));
    }
  }
  return loops;
}

/// Between the border that arrives at `v` and the one that leaves, through the material.
double angle_at(const Point2& before, const Point2& v, const Point2& after) {
  constexpr double turn = 6.283185307179586;
  const double angle = portable::atan2(before.y - v.y, before.x - v.x) - portable::atan2(after.y - v.y, after.x - v.x);
  return angle <= 0 ? angle + turn : angle;
}

/// Where borders meet in a point, all corners but the widest are cut off.
std::vector<std::vector<Point2>> parted(const std::vector<Loop>& loops) {
  struct Visit {
    std::size_t loop, at;
    double angle;
  };
  constexpr double cut = 1.0 / 64;
  std::map<Vertex, std::vector<Visit>> visits;
  const auto neighbours = [&](std::size_t l, std::size_t i) {
    const Loop& loop = loops[l];
    return std::pair(place(loop[(i + loop.size() - 1) % loop.size()]), place(loop[(i + 1) % loop.size()]));
  };
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (std::size_t i = 0; i < loops[l].size(); ++i) {
      const auto [before, after] = neighbours(l, i);
      visits[loops[l][i]].push_back({l, i, angle_at(before, place(loops[l][i]), after)});
    }
  }
  std::vector<std::vector<bool>> is_cut(loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l) is_cut[l].resize(loops[l].size(), false);
  for (auto& [vertex, all] : visits) {
    const auto widest =
        std::max_element(all.begin(), all.end(), [](const Visit& a, const Visit& b) { return a.angle < b.angle; });
    for (auto visit = all.begin(); visit != all.end(); ++visit) {
      if (visit != widest) is_cut[visit->loop][visit->at] = true;
    }
  }
  std::vector<std::vector<Point2>> polygons;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    std::vector<Point2> polygon;
    for (std::size_t i = 0; i < loops[l].size(); ++i) {
      const Point2 v = place(loops[l][i]);
      if (!is_cut[l][i]) {
        polygon.push_back(v);
        continue;
      }
      const auto [before, after] = neighbours(l, i);
      polygon.push_back({v.x + cut * (before.x - v.x), v.y + cut * (before.y - v.y)});
      polygon.push_back({v.x + cut * (after.x - v.x), v.y + cut * (after.y - v.y)});
    }
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

double square_around(const std::vector<std::vector<Point2>>& polygons) {
  double low_x = std::numeric_limits<double>::max(), low_y = low_x, high_x = -low_x, high_y = -low_x;
  for (const std::vector<Point2>& polygon : polygons) {
    for (const Point2& p : polygon) {
      low_x = std::min(low_x, p.x);
      high_x = std::max(high_x, p.x);
      low_y = std::min(low_y, p.y);
      high_y = std::max(high_y, p.y);
    }
  }
  const double side = std::max(high_x - low_x, high_y - low_y);
  return side * side;
}

/// Handles are addresses and differ from run to run; the result must not.
void put_in_order(std::vector<std::vector<Point2>>& polygons) {
  const auto before = [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  for (std::vector<Point2>& polygon : polygons) {
    std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end(), before), polygon.end());
  }
  std::sort(polygons.begin(), polygons.end(), [&](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), before);
  });
}

}  // namespace

std::vector<std::vector<Point2>> region_border(const std::vector<std::vector<Point2>>& polygons,
                                               const RepairOptions& options) {
  Triangulation triangulation;
  const Turns turns = insert(triangulation, polygons);
  if (triangulation.dimension() < 2) return {};
  spread_winding(triangulation, turns);
  std::vector<std::vector<Point2>> border = parted(loops_of(triangulation, options.inside));
  const double smallest = options.smallest_share * square_around(polygons);
  std::erase_if(border, [&](const auto& polygon) { return std::abs(signed_area(polygon)) <= smallest; });
  put_in_order(border);
  return border;
}

}  // namespace odontoscope
