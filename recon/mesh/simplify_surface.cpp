#include "recon/mesh/simplify_surface.h"

#include <algorithm>
#include <vector>

#include "recon/core/limits.h"
#include "recon/mesh/collapse_edges.h"
#include "recon/mesh/exact_predicates.h"
#include "recon/mesh/moving_box_tree.h"
#include "recon/mesh/self_intersection.h"

namespace odontoscope {
namespace {

constexpr std::string_view simplify_stage = "simplify";

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
std::vector<char> changed_shells(const Shells& full, const CollapsedSurface& collapsed, const SurfaceReport& report) {
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
  std::vector<MovingBox> places;
  std::vector<char> changed_shells;
  bool good() const {
    return places.empty() && std::find(changed_shells.begin(), changed_shells.end(), 1) == changed_shells.end();
  }
};

Verdict judge(const Shells& full, const CollapsedSurface& collapsed) {
  const SurfaceMesh& mesh = collapsed.surface;
  Verdict verdict;
  verdict.report = inspect(mesh);
  verdict.changed_shells = changed_shells(full, collapsed, verdict.report);
  const auto box_of = [&](std::initializer_list<std::size_t> triangles) {
    MovingBox box;
    for (const std::size_t t : triangles) {
      for (const PointIndex v : mesh.triangles[t]) box.add(mesh.points[v]);
    }
    box.grow(limits::kept_margin * box.longest());
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
    const auto holds = [&](const MovingBox& box) { return box.holds(surface.points[v]); };
    keep[v] =
        verdict.changed_shells[full.of_vertex[v]] || std::any_of(verdict.places.begin(), verdict.places.end(), holds);
    more = more || keep[v];
  }
  return more;
}

/// One surface on its way: what it was, what must stay, what it has become.
struct Work {
  const SurfaceMesh* surface;
  Shells full;
  std::size_t full_self_intersections;
  std::vector<char> keep;
  CollapsedSurface collapsed;
  Verdict verdict;

  explicit Work(const SurfaceMesh& mesh)
      : surface(&mesh),
        full(mesh),
        full_self_intersections(self_intersections(mesh).size()),
        keep(mesh.points.size(), 0) {
    if (!full.report.closed_oriented_manifold()) {
      throw UsageError("only a closed, oriented, manifold surface can be simplified");
    }
  }
  bool touched() const { return collapsed.surface.triangles.size() < surface->triangles.size(); }
};

/// Judges what was collapsed; returns whether it is good, or as good as the full surface was. Marks what to keep if
/// not.
bool accepted(std::vector<Work>& works) {
  bool good = true;
  for (Work& work : works) {
    if (!work.touched()) continue;
    work.verdict = judge(work.full, work.collapsed);
    // Each round keeps more; once nothing can be added, what is wrong was so in the full surface.
    if (!work.verdict.good() && keep_more(*work.surface, work.full, work.verdict, work.keep)) good = false;
  }
  return good;
}

SimplifiedSurface finished(Work& work, const DistanceOptions& options, const Progress& progress) {
  SimplifiedSurface simplified;
  simplified.full_self_intersections = work.full_self_intersections;
  simplified.kept_vertices = static_cast<std::size_t>(std::count(work.keep.begin(), work.keep.end(), 1));
  if (!work.touched()) {
    simplified.surface = *work.surface;
    simplified.report = std::move(work.full.report);
    simplified.self_intersections = work.full_self_intersections;
    return simplified;
  }
  if (!work.verdict.report.closed_oriented_manifold()) throw InternalError("simplifying broke a surface");
  simplified.surface = std::move(work.collapsed.surface);
  simplified.report = std::move(work.verdict.report);
  simplified.self_intersections = work.verdict.self_intersections;
  const auto distance = surface_distance(simplified.surface, *work.surface, options, progress);
  if (!distance) throw InternalError("a manifold surface without area");
  simplified.distance = *distance;
  return simplified;
}

}  // namespace

SimplifiedSurfaces simplify(const std::vector<const SurfaceMesh*>& surfaces, const SimplifyOptions& options,
                            const Progress& progress) {
  std::vector<Work> works;
  std::vector<SurfaceToCollapse> given;
  for (const SurfaceMesh* surface : surfaces) works.emplace_back(*surface);
  for (const Work& work : works) given.push_back({work.surface, &work.keep});
  SimplifiedSurfaces simplified;
  for (;;) {
    progress.tell(simplify_stage, 0);
    Collapse collapse = collapse_edges(given, options.triangles, progress);
    for (std::size_t n = 0; n < works.size(); ++n) works[n].collapsed = std::move(collapse.surfaces[n]);
    simplified.obstacles = {collapse.against_topology, collapse.cutting, collapse.misshapen};
    if (accepted(works)) break;
    ++simplified.restarts;
  }
  for (Work& work : works) {
    simplified.surfaces.push_back(finished(work, options.distance, progress));
    simplified.triangles += simplified.surfaces.back().surface.triangles.size();
  }
  simplified.reached = simplified.triangles <= options.triangles;
  if (simplified.reached) simplified.obstacles = {};
  return simplified;
}

SimplifiedSurface simplify(const SurfaceMesh& surface, const SimplifyOptions& options, const Progress& progress) {
  return std::move(simplify(std::vector{&surface}, options, progress).surfaces[0]);
}

}  // namespace odontoscope
