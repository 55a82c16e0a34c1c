#include "recon/partition/solve_between.h"

#include <cstdlib>
#include <optional>

#include "recon/core/limits.h"
#include "recon/delaunay/face_table.h"
#include "recon/delaunay/topology.h"

namespace odontoscope::partition {
namespace {

SolvedBetween solved_through(const BetweenTask& task, const Interpolation& how, const Progress& progress) {
  SolvedBetween solved;
  if (how.slices > 0)
    for (const InterpolatedBorders& one : task.interpolator->between(task.slab, how))
      solved.slices.push_back(planar_partition(one.borders, one.z, progress));
  std::vector<const PartitionSlice*> slices{&task.lower};
  for (const PartitionSlice& slice : solved.slices) slices.push_back(&slice);
  slices.push_back(&task.upper);
  for (std::size_t i = 0; i + 1 < slices.size(); ++i)
    solved.slabs.push_back(solve_partition_slab(*slices[i], *slices[i + 1], task.materials, task.place, progress));
  std::vector<const PartitionSlab*> slabs;
  for (const PartitionSlab& slab : solved.slabs) slabs.push_back(&slab);
  const SlabStack stack = stacked(slices, slabs);
  for (std::size_t s = 0; s < task.materials.structures.size(); ++s) {
    const LabelledPart part = part_of(stack.mesh, 0, stack.mesh.tetrahedra.size(), static_cast<Label>(s + 1));
    solved.found.push_back(delaunay::counted_topology_of_pinched(part.tetrahedra, part.boundary));
  }
  return solved;
}

long apart(const std::vector<Topology>& a, const std::vector<Topology>& b) {
  long off = 0;
  for (std::size_t s = 0; s < a.size(); ++s)
    off += std::labs(a[s].pieces - b[s].pieces) + std::labs(a[s].handles - b[s].handles) +
           std::labs(a[s].bubbles - b[s].bubbles);
  return off;
}

/// Keeps the first of the attempts that gives what is implied, else the one that comes nearest.
void attempt(const BetweenTask& task, const std::vector<Interpolation>& attempts, std::optional<SolvedBetween>& best,
             const Progress& progress) {
  for (const Interpolation& how : attempts) {
    if (best && (best->off == 0 || (how.late && best->off > odontoscope::limits::mendable))) break;
    SolvedBetween solved = solved_through(task, how, progress);
    solved.off = apart(solved.found, task.implied);
    if (!best || solved.off < best->off) best = std::move(solved);
  }
}

}  // namespace

LabelledPart part_of(const TetraMesh& mesh, std::size_t first, std::size_t end, Label label) {
  LabelledPart part;
  for (std::size_t t = first; t < end; ++t)
    if (mesh.labels[t] == label) part.tetrahedra.push_back(mesh.tetrahedra[t]);
  delaunay::each_outer_face(part.tetrahedra, [&](const Triangle& face) { part.boundary.push_back(face); });
  return part;
}

SolvedBetween solve_between(const BetweenTask& task, const Progress& progress) {
  const bool alone = !task.interpolator || (task.lower.empty() && task.upper.empty());
  std::optional<SolvedBetween> best;
  attempt(task, alone ? std::vector<Interpolation>{{}} : task.interpolator->attempts(task.slab), best, progress);
  return std::move(*best);
}

void improve_between(const BetweenTask& task, SolvedBetween& solved, const Progress& progress) {
  std::optional<SolvedBetween> best = std::move(solved);
  attempt(task, task.interpolator->own_attempts(task.slab), best, progress);
  solved = std::move(*best);
}

}  // namespace odontoscope::partition
