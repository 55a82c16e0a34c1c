#include "recon/mesh/collapse_edges.h"

#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "recon/mesh/collapse_guard.h"

namespace odontoscope {
namespace {

namespace sms = CGAL::Surface_mesh_simplification;
using Vertex = HalfEdgeMesh::Vertex_index;
using Face = HalfEdgeMesh::Face_index;
using ExactPoint = ExactKernel::Point_3;
using FixedEdges = HalfEdgeMesh::Property_map<HalfEdgeMesh::Edge_index, bool>;
using Placement = sms::Constrained_placement<sms::LindstromTurk_placement<HalfEdgeMesh>, FixedEdges>;
using Refusal = CollapseRefusal;

constexpr std::string_view collapse_stage = "simplify";
/// A round is repeated if it took away more than one in so many edges.
constexpr std::size_t least_gain = 100;

/// All surfaces as one mesh. Points of each keep their order, and their numbers but for what `first_point` adds.
struct Together {
  HalfEdgeMesh mesh;
  std::vector<std::uint32_t> surface_of;  // each vertex
  std::vector<char> keep;
  std::vector<std::size_t> first_point;  // of each surface

  explicit Together(const std::vector<SurfaceToCollapse>& surfaces) {
    SurfaceMesh all;
    for (std::size_t n = 0; n < surfaces.size(); ++n) {
      const auto first = static_cast<PointIndex>(all.points.size());
      const SurfaceMesh& one = *surfaces[n].surface;
      first_point.push_back(first);
      all.points.insert(all.points.end(), one.points.begin(), one.points.end());
      for (const auto& [a, b, c] : one.triangles) all.triangles.push_back({a + first, b + first, c + first});
      keep.insert(keep.end(), surfaces[n].keep->begin(), surfaces[n].keep->end());
      surface_of.insert(surface_of.end(), one.points.size(), static_cast<std::uint32_t>(n));
    }
    mesh = to_half_edges(all);
  }
};

/// What a round may do beyond the optimal placement of its collapses.
struct Daring {
  bool elsewhere = false;  // try the middle and the ends of an edge, too
  CollapseStar::Turning turning = CollapseStar::Turning::refused;
};

/// What CGAL's copies of placement and visitor have in common.
struct Round {
  Together& all;
  FixedEdges fixed;
  CollapseGuard guard;
  Daring daring;
  const Progress& progress;
  std::size_t edges_at_the_end, edges_at_the_start, calls = 0;
  bool selected = false;  // CGAL asks for a placement to act upon, not to sort by
  std::optional<Refusal> refusal;
  std::size_t against_topology = 0, cutting = 0, misshapen = 0, collapsed = 0;

  void check_now_and_then() {
    constexpr std::size_t pause = 1000;
    if (++calls % pause == 0) progress.check();
  }

  template <class Profile>
  CollapseStar star_of(const Profile& profile) const {
    CollapseStar star{profile.v0(), profile.v1(), profile.p0(), profile.p1(), {}};
    const auto& triangles = profile.triangles();  // first those that vanish: two, as the surface is closed
    for (std::size_t n = 2; n < triangles.size(); ++n) {
      const auto& [before, moved, after] = triangles[n];
      star.triangles.push_back(
          {{before, moved, after}, {all.mesh.point(before), all.mesh.point(moved), all.mesh.point(after)}});
    }
    return star;
  }

  /// The first place that nothing speaks against; `refusal` says what spoke against the best.
  template <class Profile>
  boost::optional<ExactPoint> allowed(const Profile& profile, const boost::optional<ExactPoint>& best) {
    const CollapseStar star = star_of(profile);
    std::vector<ExactPoint> places;
    if (best) places.push_back(*best);
    const bool held = all.keep[profile.v0().idx()] || all.keep[profile.v1().idx()];
    if (daring.elsewhere && !held) {
      places.insert(places.end(), {CGAL::midpoint(profile.p0(), profile.p1()), profile.p0(), profile.p1()});
    }
    refusal = Refusal::far;
    for (std::size_t n = 0; n < places.size(); ++n) {
      const std::optional<Refusal> spoken = guard.refusal(star, places[n], daring.turning);
      if (!spoken) return places[n];
      if (n == 0) refusal = spoken;
    }
    return boost::none;
  }
};

struct GuardedPlacement {
  Placement best;
  Round* round;

  template <class Profile>
  boost::optional<ExactPoint> operator()(const Profile& profile) const {
    boost::optional<ExactPoint> place = best(profile);
    if (!place && round->daring.elsewhere) place = CGAL::midpoint(profile.p0(), profile.p1());
    return std::exchange(round->selected, false) ? round->allowed(profile, place) : place;
  }
};

class Watcher : public sms::Edge_collapse_visitor_base<HalfEdgeMesh> {
 public:
  explicit Watcher(Round& round) : round_(&round) {}

  void OnCollected(const Profile&, const boost::optional<FT>&) { round_->check_now_and_then(); }
  void OnSelected(const Profile&, const boost::optional<FT>& cost, size_type, size_type current) {
    Round& round = *round_;
    round.check_now_and_then();
    round.selected = cost.has_value();
    round.refusal.reset();
    constexpr std::size_t pause = 1000;
    if (round.calls % pause != 0) return;
    const double all = static_cast<double>(round.edges_at_the_start) - static_cast<double>(round.edges_at_the_end);
    const double done = static_cast<double>(round.edges_at_the_start) - static_cast<double>(current);
    round.progress.tell(collapse_stage, all > 0 ? std::clamp(done / all, 0.0, 1.0) : 1.0);
  }
  void OnStopConditionReached(const Profile&) { round_->selected = false; }
  void OnCollapsing(const Profile& profile, const boost::optional<ExactPoint>&) {
    round_->guard.vanished(round_->all.mesh.face(profile.v0_v1()));
    round_->guard.vanished(round_->all.mesh.face(profile.v1_v0()));
  }
  void OnCollapsed(const Profile&, const vertex_descriptor& vertex) {
    ++round_->collapsed;
    round_->guard.moved(vertex);
  }
  void OnNonCollapsable(const Profile&) {
    Round& round = *round_;
    const bool no_place_asked_for = std::exchange(round.selected, false);
    ++(no_place_asked_for ? round.against_topology : round.refusal == Refusal::cuts ? round.cutting : round.misshapen);
  }

 private:
  Round* round_;
};

std::vector<CollapsedSurface> parted(const Together& all, std::size_t count) {
  std::vector<CollapsedSurface> surfaces(count);
  std::vector<PointIndex> number(all.mesh.num_vertices(), 0);
  for (const Vertex v : all.mesh.vertices()) {
    if (all.mesh.is_isolated(v)) continue;
    const std::uint32_t n = all.surface_of[v.idx()];
    number[v.idx()] = static_cast<PointIndex>(surfaces[n].original.size());
    surfaces[n].original.push_back(static_cast<PointIndex>(v.idx() - all.first_point[n]));
    const ExactPoint& p = all.mesh.point(v);
    surfaces[n].surface.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const Face face : all.mesh.faces()) {
    const auto h = all.mesh.halfedge(face);
    const Vertex source = all.mesh.source(h), target = all.mesh.target(h), last = all.mesh.target(all.mesh.next(h));
    // From the source of the half-edge, so that an untouched triangle keeps its first vertex.
    surfaces[all.surface_of[source.idx()]].surface.triangles.push_back(
        {number[source.idx()], number[target.idx()], number[last.idx()]});
  }
  return surfaces;
}

}  // namespace

Collapse collapse_edges(const std::vector<SurfaceToCollapse>& surfaces, std::size_t triangles,
                        const Progress& progress) {
  Together all(surfaces);
  // A closed surface of n triangles has 3n/2 edges; the predicate stops once there are fewer than its number.
  const std::size_t edges = triangles / 2 * 3;
  Collapse result;
  const std::vector<Daring> rounds{
      {}, {.elsewhere = true}, {.elsewhere = true, .turning = CollapseStar::Turning::allowed}};
  for (std::size_t n = 0; n < rounds.size() && all.mesh.number_of_edges() > edges;) {
    FixedEdges fixed = all.mesh.add_property_map<HalfEdgeMesh::Edge_index, bool>("e:fixed", false).first;
    for (const auto edge : all.mesh.edges()) {
      fixed[edge] = all.keep[all.mesh.vertex(edge, 0).idx()] && all.keep[all.mesh.vertex(edge, 1).idx()];
    }
    const std::size_t at_the_start = all.mesh.number_of_edges();
    Round round{all,
                fixed,
                CollapseGuard(all.mesh, all.surface_of),
                rounds[n],
                progress,
                edges,
                at_the_start,
                0,
                false,
                {},
                0,
                0,
                0,
                0};
    sms::edge_collapse(all.mesh, sms::Count_stop_predicate<HalfEdgeMesh>(edges + 1),
                       CGAL::parameters::get_cost(sms::LindstromTurk_cost<HalfEdgeMesh>())
                           .get_placement(GuardedPlacement{Placement(fixed), &round})
                           .edge_is_constrained_map(fixed)
                           .visitor(Watcher(round)));
    result.against_topology = round.against_topology;
    result.cutting = round.cutting;
    result.misshapen = round.misshapen;
    // What went in the way may have gone since: again, as long as that is worth it.
    if (round.collapsed <= at_the_start / least_gain) ++n;
  }
  result.surfaces = parted(all, surfaces.size());
  return result;
}

}  // namespace odontoscope
