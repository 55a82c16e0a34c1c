#pragma once
// The tetrahedra of a slab while it is being solved: the triangulation's, with raised points, and the thickened
// triangles below (above) these. Inner part of partition_slab.h.
//
// Points: those of the lower slice, those of the upper, then of each of them a place for its raised copy, whether there
// is one or not.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "recon/core/index_groups.h"
#include "recon/delaunay/prism.h"
#include "recon/delaunay/slab.h"
#include "recon/partition/planar_partition.h"
#include "recon/partition/vertex_link.h"

namespace odontoscope::partition {

using delaunay::SlabPoint;
using delaunay::TetIndex;
/// The tetrahedra, in their order, then the thickened triangles.
using CellIndex = Index<struct CellKind>;

class SlabComplex {
 public:
  using Corners = std::array<SlabPoint, 4>;

  /// `tetrahedra`: of both slices' triangulations, or none. All labels are void at first.
  SlabComplex(const PartitionSlice& lower, const PartitionSlice& upper, delaunay::SlabTetrahedra tetrahedra);

  const delaunay::SlabTetrahedra& tetrahedra() const { return tets_; }
  /// Points that are no copies.
  Indices<SlabPoint> on_slices() const { return {SlabPoint(0), SlabPoint(on_slices_)}; }
  bool is_copy(SlabPoint v) const { return v >= on_slices_; }
  SlabPoint copy_of(SlabPoint p) const { return SlabPoint(p + on_slices_); }
  SlabPoint original_of(SlabPoint copy) const { return SlabPoint(copy - on_slices_); }
  /// Of points that are no copies.
  const delaunay::SlabNumbers& numbers() const { return numbers_; }
  const PartitionSlice& slice_of(SlabPoint p) const { return numbers_.is_lower(p) ? lower_ : upper_; }

  const Table<SlabPoint, bool>& raised() const { return raised_; }
  bool any_raised() const { return any_raised_; }
  Label label(TetIndex t) const { return labels_[t]; }

  /// How far p is raised if it is, over the slab's height; less than usual is as usual.
  void set_share(SlabPoint p, double share);
  /// Returns false if it was raised already.
  bool raise(SlabPoint p);
  /// Where a tetrahedron is not positive any more, corners that were raised farther than usual are lowered, and where
  /// only some corners in one slice are raised, the others are raised too. To be called after raising. Returns the
  /// tetrahedra at all points raised since the last call, ascending.
  std::vector<TetIndex> keep_positive();
  /// Returns false if it had that label.
  bool relabel(TetIndex t, Label label);

  /// Brings `cells` and stars up to date.
  void build();

  const Table<CellIndex, Corners>& cells() const { return cells_; }
  bool is_tetrahedron(CellIndex cell) const { return cell < tets_.size(); }
  /// Precondition: it is one.
  TetIndex tetrahedron(CellIndex cell) const { return TetIndex(cell); }
  Label cell_label(CellIndex cell) const {
    return is_tetrahedron(cell) ? labels_[tetrahedron(cell)] : thick_labels_[cell - tets_.size()];
  }
  std::span<const CellIndex> star(SlabPoint v) const { return star_[v]; }
  std::vector<LinkTriangle> link(SlabPoint v) const;
  /// Of the tetrahedra that have the point, raised or not.
  std::span<const TetIndex> tetrahedra_at(SlabPoint p) const { return at_[p]; }

  /// Points whose star has changed since they were last taken, ascending.
  std::vector<SlabPoint> take_changed();
  /// To be looked at again.
  void mark(SlabPoint v) { changed_[v] = true; }

  Point3 place(SlabPoint v) const;
  SlabPoint top(SlabPoint p) const { return raised_[p] ? copy_of(p) : p; }
  /// Heights of points that are raised as usual.
  double raised_lower() const { return raised_lower_; }
  double raised_upper() const { return raised_upper_; }

 private:
  double height(SlabPoint p) const;
  bool rises_far(SlabPoint p) const { return raised_[p] && shares_[p] > 0; }
  void lower_to(SlabPoint p, double share);
  void lower_corners(const delaunay::SlabTetrahedron& tet);
  template <class Number>
  void thicken(const PartitionSlice& slice, Number number, delaunay::Thickened direction);
  void collect_stars();
  void mark_around(TetIndex t);

  const PartitionSlice& lower_;
  const PartitionSlice& upper_;
  const delaunay::SlabTetrahedra tets_;
  const delaunay::SlabNumbers numbers_;
  const std::uint32_t on_slices_;
  const double raised_lower_, raised_upper_;
  IndexGroups<SlabPoint, TetIndex> at_;
  Table<TetIndex, Label> labels_;
  Table<SlabPoint, bool> raised_;
  Table<SlabPoint, double> shares_;               // 0: as usual
  Table<SlabPoint, std::uint8_t> times_lowered_;  // of those
  bool any_raised_ = false, stale_ = true;
  std::vector<SlabPoint> fresh_;  // raised since keep_positive was called
  Table<CellIndex, Corners> cells_;
  std::vector<Label> thick_labels_;
  IndexGroups<SlabPoint, CellIndex> star_;
  Table<SlabPoint, bool> changed_;
};

}  // namespace odontoscope::partition
