#include "recon/mesh/simplify_surface.h"

#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "recon/core/limits.h"
#include "recon/mesh/cgal_surface.h"
#include "recon/mesh/exact_predicates.h"
#include "recon/mesh/self_intersection.h"

namespace odontoscope {
namespace {

namespace sms = CGAL::Surface_mesh_simplification;
using Vertex = HalfEdgeMesh::Vertex_index;
using FixedEdges = HalfEdgeMesh::Property_map<HalfEdgeMesh::Edge_index, bool>;

constexpr std::string_view stage = "simplify";

/// Tells progress and stops on request.
class Watcher : public sms::Edge_collapse_visitor_base<HalfEdgeMesh> {
 public:
  Watcher(const Progress& progress, std::size_t edges_at_the_end)
      : progress_(&progress), edges_at_the_end_(edges_at_the_end) {}

  void OnCollected(const Profile&, const boost::optional<FT>&) { check_now_and_then(); }
  void OnSelected(const Profile&, const boost::optional<FT>&, size_type initial, size_type current) {
    if (!check_now_and_then()) return;
    const double all = static_cast<double>(initial) - static_cast<double>(edges_at_the_end_);
    const double done = static_cast<double>(initial) - static_cast<double>(current);
    progress_->tell(stage, all > 0 ? std::min(done / all, 1.0) : 1.0);
  }

 private:
  bool check_now_and_then() {
    constexpr std::size_t pause = 1000;
    if (++calls_ % pause != 0) return false;
    progress_->check();
    return true;
  }

  const Progress* progress_;
  std::size_t edges_at_the_end_, calls_ = 0;
};

/// The collapsed mesh, and for each of its points the number that it had in the original.
struct Collapsed {
  SurfaceMesh surface;
  std::vector<PointIndex> original;
};

Collapsed without_gaps(const HalfEdgeMesh& mesh) {
  Collapsed collapsed;
  std::vector<PointIndex> number(mesh.num_vertices(), 0);
  for (const Vertex v : mesh.vertices()) {
    if (mesh.is_isolated(v)) continue;
    number[v.idx()] = static_cast<PointIndex>(collapsed.original.size());
    collapsed.original.push_back(v.idx());
    const auto& p = mesh.point(v);
    collapsed.surface.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto face : mesh.faces()) {
    const auto h = mesh.halfedge(face);
    // From the source of the half-edge, so that an untouched triangle keeps its first vertex.
    collapsed.surface.triangles.push_back(
        {number[mesh.source(h).idx()], number[mesh.target(h).idx()], number[mesh.target(mesh.next(h)).idx()]});
  }
  return collapsed;
}

Collapsed collapse(const SurfaceMesh& surface, const std::vector<char>& keep, std::size_t triangles,
                   const Progress& progress) {
  HalfEdgeMesh mesh = to_half_edges(surface);
  FixedEdges fixed = mesh.add_property_map<HalfEdgeMesh::Edge_index, bool>("e:fixed", false).first;
  for (const auto edge : mesh.edges())
    fixed[edge] = keep[mesh.vertex(edge, 0).idx()] && keep[mesh.vertex(edge, 1).idx()];

  // A closed surface of n triangles has 3n/2 edges; the predicate stops once there are fewer than its number.
  const std::size_t edges = triangles / 2 * 3;
  using Placement = sms::Constrained_placement<sms::LindstromTurk_placement<HalfEdgeMesh>, FixedEdges>;
  sms::edge_collapse(mesh, sms::Count_stop_predicate<HalfEdgeMesh>(edges + 1),
                     CGAL::parameters::get_cost(sms::LindstromTurk_cost<HalfEdgeMesh>())
                         .get_placement(Placement(fixed))
                         .filter(sms::Bounded_normal_change_filter<>())
                         .edge_is_constrained_map(fixed)
                         .visitor(Watcher(progress, edges)));
  return without_gaps(mesh);
}

struct Box {
  Point3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
  Point3 high{-low.x, -low.y, -low.z};

  void add(const Point3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void grow() {
    const double by = limits::kept_margin * std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    low = {low.x - by, low.y - by, low.z - by};
    high = {high.x + by, high.y + by, high.z + by};
  }
  bool holds(const Point3& p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y && low.z <= p.z && p.z <= high.z;
  }
};

/// The shells of the full surface, and which one each vertex belongs to.
struct Shells {
  SurfaceReport report;
  std::vector<std::uint32_t> of_vertex;

  explicit Shells(const SurfaceMesh& surface) : report(inspect(surface)), of_vertex(surface.points.size(), 0) {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      for (const PointIndex v : surface.triangles[t]) of_vertex[v] = report.shell_of[t];
    }
  }
};

/// Shells of the original that the collapse gave another kind or genus (a speck whose volume rounding turned over).
std::vector<char> changed_shells(const Shells& full, const Collapsed& collapsed, const SurfaceReport& report) {
  std::vector<char> changed(full.report.shells.size(), 1);
  for (std::size_t t = 0; t < collapsed.surface.triangles.size(); ++t) {
    const std::uint32_t before = full.of_vertex[collapsed.original[collapsed.surface.triangles[t][0]]];
    const Shell &now = report.shells[report.shell_of[t]], &was = full.report.shells[before];
    changed[before] = now.kind != was.kind || now.genus != was.genus;
  }
  return changed;
}

/// What is wrong with a collapsed surface, and where.
struct Verdict {
  SurfaceReport report;
  std::size_t self_intersections = 0;
  std::vector<Box> places;
  std::vector<char> changed_shells;
  bool good() const {
    return places.empty() && std::find(changed_shells.begin(), changed_shells.end(), 1) == changed_shells.end();
  }
};

Verdict judge(const Shells& full, const Collapsed& collapsed) {
  const SurfaceMesh& mesh = collapsed.surface;
  Verdict verdict;
  verdict.report = inspect(mesh);
  verdict.changed_shells = changed_shells(full, collapsed, verdict.report);
  const auto box_of = [&](std::initializer_list<std::size_t> triangles) {
    Box box;
    for (const std::size_t t : triangles) {
      for (const PointIndex v : mesh.triangles[t]) box.add(mesh.points[v]);
    }
    box.grow();
    return box;
  };
  const auto pairs = self_intersections(mesh);
  verdict.self_intersections = pairs.size();
  for (const auto& [a, b] : pairs) verdict.places.push_back(box_of({a, b}));
  if (verdict.report.degenerate_triangles == 0) return verdict;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    if (collinear(mesh.points[a], mesh.points[b], mesh.points[c])) verdict.places.push_back(box_of({t}));
  }
  return verdict;
}

/// Marks what must stay as it is in the next round; returns whether that is more than before.
bool keep_more(const SurfaceMesh& surface, const Shells& full, const Verdict& verdict, std::vector<char>& keep) {
  bool more = false;
  for (std::size_t v = 0; v < keep.size(); ++v) {
    if (keep[v]) continue;
    const auto holds = [&](const Box& box) { return box.holds(surface.points[v]); };
    keep[v] =
        verdict.changed_shells[full.of_vertex[v]] || std::any_of(verdict.places.begin(), verdict.places.end(), holds);
    more = more || keep[v];
  }
  return more;
}

}  // namespace

SimplifiedSurface simplify(const SurfaceMesh& surface, const SimplifyOptions& options, const Progress& progress) {
  const Shells full(surface);
  if (!full.report.closed_oriented_manifold()) {
    throw UsageError("only a closed, oriented, manifold surface can be simplified");
  }
  SimplifiedSurface simplified;
  simplified.full_self_intersections = self_intersections(surface).size();
  if (options.triangles >= surface.triangles.size()) {
    simplified.surface = surface;
    simplified.report = full.report;
    simplified.self_intersections = simplified.full_self_intersections;
    return simplified;
  }

  std::vector<char> keep(surface.points.size(), 0);
  Collapsed collapsed;
  Verdict verdict;
  for (;;) {
    progress.tell(stage, 0);
    collapsed = collapse(surface, keep, options.triangles, progress);
    verdict = judge(full, collapsed);
    // Each round keeps more; once nothing can be added, what is wrong was so in the full surface.
    if (verdict.good() || !keep_more(surface, full, verdict, keep)) break;
    ++simplified.restarts;
  }
  if (!verdict.report.closed_oriented_manifold()) throw InternalError("simplifying broke a surface");
  simplified.surface = std::move(collapsed.surface);
  simplified.report = std::move(verdict.report);
  simplified.self_intersections = verdict.self_intersections;
  simplified.kept_vertices = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 1));
  const auto distance = surface_distance(simplified.surface, surface, options.distance, progress);
  if (!distance) throw InternalError("a manifold surface without area");
  simplified.distance = *distance;
  return simplified;
}

}  // namespace odontoscope
