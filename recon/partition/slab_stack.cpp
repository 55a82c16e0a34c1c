#include "recon/partition/slab_stack.h"

#include "recon/core/error.h"

namespace odontoscope::partition {

SlabStack stacked(std::span<const PartitionSlice* const> slices, std::span<const PartitionSlab* const> slabs) {
  std::uint64_t points = 0;
  std::size_t tetrahedra = 0;
  for (const PartitionSlice* slice : slices) points += slice->planar.points.size();
  for (const PartitionSlab* slab : slabs) {
    points += slab->added.size();
    tetrahedra += slab->tetrahedra.size();
  }
  if (points >= delaunay::none) throw InternalError("more points than 32-bit numbers can count");
  SlabStack stack;
  TetraMesh& mesh = stack.mesh;
  mesh.points.reserve(points);
  mesh.tetrahedra.reserve(tetrahedra);
  mesh.labels.reserve(tetrahedra);
  for (const PartitionSlice* slice : slices) {
    stack.points.push_back(static_cast<std::uint32_t>(mesh.points.size()));
    for (const Point2 p : slice->planar.points) mesh.points.push_back({p.x, p.y, slice->z});
  }
  stack.points.push_back(static_cast<std::uint32_t>(mesh.points.size()));
  for (std::size_t k = 0; k < slabs.size(); ++k) {
    const std::uint32_t first = stack.points[k], in_slices = stack.points[k + 2] - first;
    const auto first_added = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), slabs[k]->added.begin(), slabs[k]->added.end());
    stack.tetrahedra.push_back(mesh.tetrahedra.size());
    for (Tetrahedron tet : slabs[k]->tetrahedra) {
      for (std::uint32_t& v : tet) v = v < in_slices ? first + v : first_added + (v - in_slices);
      mesh.tetrahedra.push_back(tet);
    }
    mesh.labels.insert(mesh.labels.end(), slabs[k]->labels.begin(), slabs[k]->labels.end());
  }
  stack.tetrahedra.push_back(mesh.tetrahedra.size());
  return stack;
}

}  // namespace odontoscope::partition
