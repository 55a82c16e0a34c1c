#include "recon/partition/certify_partition.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "recon/core/error.h"
#include "recon/delaunay/predicates.h"
#include "recon/partition/dual_labels.h"

namespace odontoscope::partition {
namespace {

using delaunay::SlicePoint;
using delaunay::TriangleIndex;

[[noreturn]] void broken(const std::string& what) { throw InternalError("certificate of the partition: " + what); }

/// Marks what a slab's tetrahedra have in one of its slices.
class InPlane {
 public:
  InPlane(const PartitionSlice& slice, std::uint32_t first, std::size_t number)
      : slice_(slice), first_(first), number_(number), met_(slice.planar.triangles.size(), false) {
    for (const TriangleIndex t : slice.planar.triangles.indices()) {
      auto v = slice.planar.triangles[t].v;
      std::sort(v.begin(), v.end());
      triangle_of_[v] = t;
    }
  }

  /// `points`: in the numbering of the whole.
  void meet(const std::vector<std::uint32_t>& points, Label label) {
    std::vector<SlicePoint> corners;
    for (const std::uint32_t p : points) corners.emplace_back(p - first_);
    if (corners.size() == 1 && !at_point(corners[0], label))
      broken(fmt::format("a point of slice {} is touched by what is no face there", number_));
    if (corners.size() == 2 && !sides_of(slice_, corners[0], corners[1]).has(label))
      broken(fmt::format("an edge of slice {} is touched by what is no face there", number_));
    if (corners.size() < 3) return;
    std::array<SlicePoint, 3> v{corners[0], corners[1], corners[2]};
    std::sort(v.begin(), v.end());
    const auto found = triangle_of_.find(v);
    if (found == triangle_of_.end() || slice_.label(found->second) != label)
      broken(fmt::format("slice {} is filled with another label", number_));
    if (met_[found->second]) broken(fmt::format("a triangle of slice {} is met twice from one side", number_));
    met_[found->second] = true;
  }

  void finish() const {
    for (const TriangleIndex t : met_.indices())
      if (slice_.label(t) != void_label && !met_[t]) broken(fmt::format("a face of slice {} is not filled", number_));
  }

 private:
  bool at_point(SlicePoint p, Label label) const {
    for (const delaunay::SpokeIndex s : slice_.planar.spokes_of(p))
      if (slice_.label(slice_.planar.spokes[s].triangle) == label) return true;
    return false;
  }

  const PartitionSlice& slice_;
  std::uint32_t first_;
  std::size_t number_;
  Table<TriangleIndex, bool> met_;
  std::map<std::array<SlicePoint, 3>, TriangleIndex> triangle_of_;
};

}  // namespace

void certify_slab(std::span<const PartitionSlice* const> slices, const ComplexRanges& ranges, const TetraMesh& mesh,
                  std::size_t k) {
  InPlane floor(*slices[k], ranges.points[k], k), ceiling(*slices[k + 1], ranges.points[k + 1], k + 1);
  std::vector<std::uint32_t> in_floor, in_ceiling;
  for (std::size_t t = ranges.tetrahedra[k]; t < ranges.tetrahedra[k + 1]; ++t) {
    const Tetrahedron& tet = mesh.tetrahedra[t];
    if (delaunay::orientation(mesh.points[tet[0]], mesh.points[tet[1]], mesh.points[tet[2]], mesh.points[tet[3]]) <= 0)
      broken(fmt::format("a tetrahedron between slices {} and {} is not positive", k, k + 1));
    in_floor.clear();
    in_ceiling.clear();
    for (const std::uint32_t v : tet) {
      const double z = mesh.points[v].z;
      if (!(z >= slices[k]->z && z <= slices[k + 1]->z))
        broken(fmt::format("a point leaves the slab above slice {}", k));
      if (z == slices[k]->z) in_floor.push_back(v);
      if (z == slices[k + 1]->z) in_ceiling.push_back(v);
    }
    if (!in_floor.empty()) floor.meet(in_floor, mesh.labels[t]);
    if (!in_ceiling.empty()) ceiling.meet(in_ceiling, mesh.labels[t]);
  }
  floor.finish();
  ceiling.finish();
}

}  // namespace odontoscope::partition
