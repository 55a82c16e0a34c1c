#pragma once
// The tetrahedra of a slab while it is being solved: the triangulation's, with raised points, and the thickened
// triangles below (above) these. Inner part of partition_slab.h.
//
// Points: those of the lower slice, those of the upper, then of each of them a place for its raised copy, whether there
// is one or not.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "recon/delaunay/slab.h"
#include "recon/partition/planar_partition.h"
#include "recon/partition/vertex_link.h"

namespace odontoscope::partition {

class SlabComplex {
 public:
  using Corners = std::array<std::uint32_t, 4>;

  /// `tetrahedra`: of both slices' triangulations, or none. All labels are void at first.
  SlabComplex(const PartitionSlice& lower, const PartitionSlice& upper,
              std::vector<delaunay::SlabTetrahedron> tetrahedra);

  const std::vector<delaunay::SlabTetrahedron>& tetrahedra() const { return tets_; }
  std::uint32_t on_slices() const { return on_slices_; }
  bool is_lower(std::uint32_t p) const { return p < offset_; }
  const PartitionSlice& slice_of(std::uint32_t p) const { return is_lower(p) ? lower_ : upper_; }
  std::uint32_t number(std::uint32_t own, bool lower) const { return lower ? own : own + offset_; }
  /// Its number in its own slice.
  std::uint32_t own(std::uint32_t p) const { return is_lower(p) ? p : p - offset_; }

  const std::vector<bool>& raised() const { return raised_; }
  bool any_raised() const { return any_raised_; }
  Label label(std::uint32_t t) const { return labels_[t]; }

  /// How far p is raised if it is, over the slab's height; less than usual is as usual.
  void set_share(std::uint32_t p, double share);
  /// Returns false if it was raised already.
  bool raise(std::uint32_t p);
  /// Where a tetrahedron is not positive any more, corners that were raised farther than usual are lowered, and where
  /// only some corners in one slice are raised, the others are raised too. To be called after raising. Returns the
  /// tetrahedra at all points raised since the last call, ascending.
  std::vector<std::uint32_t> keep_positive();
  /// Returns false if it had that label.
  bool relabel(std::uint32_t t, Label label);

  /// Brings `cells` and stars up to date.
  void build();

  /// Cells: the tetrahedra, in their order, then the thickened triangles.
  std::size_t cells() const { return cells_.size(); }
  const Corners& corners(std::uint32_t cell) const { return cells_[cell]; }
  Label cell_label(std::uint32_t cell) const {
    return cell < tets_.size() ? labels_[cell] : thick_labels_[cell - tets_.size()];
  }
  std::pair<const std::uint32_t*, const std::uint32_t*> star(std::uint32_t v) const {
    return {star_.data() + first_[v], star_.data() + first_[v + 1]};
  }
  std::vector<LinkTriangle> link(std::uint32_t v) const;
  /// Of the tetrahedra that have the point, raised or not.
  std::pair<const std::uint32_t*, const std::uint32_t*> tetrahedra_at(std::uint32_t p) const {
    return {at_.data() + first_at_[p], at_.data() + first_at_[p + 1]};
  }

  /// Points whose star has changed since they were last taken, ascending.
  std::vector<std::uint32_t> take_changed();
  /// To be looked at again.
  void mark(std::uint32_t v) { changed_[v] = true; }

  Point3 place(std::uint32_t v) const;
  std::uint32_t top(std::uint32_t p) const { return raised_[p] ? p + on_slices_ : p; }
  /// Heights of points that are raised as usual.
  double raised_lower() const { return raised_lower_; }
  double raised_upper() const { return raised_upper_; }

 private:
  double height(std::uint32_t p) const;
  bool rises_far(std::uint32_t p) const { return raised_[p] && shares_[p] > 0; }
  void lower_to(std::uint32_t p, double share);
  void lower_corners(const delaunay::SlabTetrahedron& tet);
  void thicken(const PartitionSlice& slice, std::uint32_t first, bool upwards);
  void collect_stars();
  void mark_around(std::uint32_t t);

  const PartitionSlice& lower_;
  const PartitionSlice& upper_;
  const std::vector<delaunay::SlabTetrahedron> tets_;
  const std::uint32_t offset_, on_slices_;
  const double raised_lower_, raised_upper_;
  std::vector<std::uint32_t> first_at_, at_;
  std::vector<Label> labels_;  // of the tetrahedra
  std::vector<bool> raised_;
  std::vector<double> shares_;               // 0: as usual
  std::vector<std::uint8_t> times_lowered_;  // of those
  bool any_raised_ = false, stale_ = true;
  std::vector<std::uint32_t> fresh_;  // raised since keep_positive was called
  std::vector<Corners> cells_;
  std::vector<Label> thick_labels_;
  std::vector<std::uint32_t> first_, star_;
  std::vector<bool> changed_;
};

}  // namespace odontoscope::partition
