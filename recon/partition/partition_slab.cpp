#include "recon/partition/partition_slab.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "recon/partition/limits.h"
#include "recon/partition/slab_complex.h"
#include "recon/partition/slab_labels.h"

namespace odontoscope::partition {
namespace {

using delaunay::SlicePoint;

class SlabSolver {
 public:
  SlabSolver(const PartitionSlice& lower, const PartitionSlice& upper, const Materials& materials, const Place& place,
             const Progress& progress)
      : lower_(lower), upper_(upper), materials_(materials), place_(place), progress_(progress) {}

  PartitionSlab run() {
    result_.cut = !lower_.conforming || !upper_.conforming;
    const bool apart = result_.cut || lower_.empty() || upper_.empty();
    complex_.emplace(lower_, upper_,
                     apart ? delaunay::SlabTetrahedra{} : delaunay::bare_slab(lower_.planar, upper_.planar));
    mends_.assign(complex_->raised().size(), 0);
    if (apart) {
      for (const SlabPoint p : complex_->on_slices()) complex_->raise(p);
      complex_->build();
      return collect();
    }
    label();
    do {
      complex_->keep_positive();
      complex_->build();
    } while (improve());
    return collect();
  }

 private:
  // ---- labels -------------------------------------------------------------------------------------------------------

  /// By rule, with points raised where the rule contradicts itself or a slice.
  void label() {
    const SlabLabels rule(complex_->tetrahedra(), lower_, upper_, materials_);
    raise_ending(rule);
    complex_->keep_positive();
    std::vector<TetIndex> open;
    for (const TetIndex t : complex_->tetrahedra().indices()) open.push_back(t);
    while (!open.empty()) {
      std::vector<SlabPoint> losers;
      for (const TetIndex t : open) complex_->relabel(t, rule.label(t, complex_->raised(), losers));
      for (const SlabPoint p : losers) complex_->raise(p);
      open = complex_->keep_positive();
      if (!open.empty()) continue;
      complex_->build();
      raise_where_not_exact();
      open = complex_->keep_positive();
    }
  }

  void raise_ending(const SlabLabels& rule) {
    for (const RaisedShare& one : rule.ramp()) complex_->set_share(one.point, one.share);
    const delaunay::SlabNumbers& numbers = complex_->numbers();
    for (const EndingTriangle& one : rule.ending()) {
      const bool lower = one.slice == delaunay::Side::lower;
      for (const SlicePoint own : (lower ? lower_ : upper_).planar.triangles[one.triangle].v)
        complex_->raise(lower ? numbers.of_lower(own) : numbers.of_upper(own));
    }
  }

  // ---- exact sections -----------------------------------------------------------------------------------------------

  /// Raises points of the slices at which something touches that is none of their faces, or at which a face is no disc
  /// seen from the slab. Looks at what has changed since the last time; raised copies of points are left to be looked
  /// at. False: there were none.
  bool raise_where_not_exact() {
    progress_.check();
    std::vector<SlabPoint> wrong;
    for (const SlabPoint v : complex_->take_changed()) {
      if (complex_->is_copy(v))
        later_.push_back(v);
      else if (!complex_->raised()[v])
        check_exact(v, wrong);
    }
    bool any = false;
    for (const SlabPoint p : wrong) any = complex_->raise(p) || any;
    return any;
  }

  /// Precondition: the three points are the corners of a triangle.
  static Label label_of_triangle(const PartitionSlice& slice, SlicePoint a, SlicePoint b, SlicePoint c) {
    const EdgeSides sides = sides_of(slice, a, b);
    if (sides.left == sides.right || sides.left_triangle == delaunay::none) return sides.right;
    const auto& corners = slice.planar.triangles[sides.left_triangle].v;
    return std::find(corners.begin(), corners.end(), c) != corners.end() ? sides.left : sides.right;
  }

  void check_exact(SlabPoint p, std::vector<SlabPoint>& wrong) const {
    const PartitionSlice& slice = complex_->slice_of(p);
    const delaunay::SlabNumbers& numbers = complex_->numbers();
    const SlicePoint own = numbers.own(p);
    std::vector<Label> faces;
    for (const delaunay::SpokeIndex s : slice.planar.spokes_of(own))
      faces.push_back(slice.label(slice.planar.spokes[s].triangle));
    std::vector<LinkTriangle> triangles = complex_->link(p);
    const auto on_slice = [&](SlabPoint w) {
      return !complex_->is_copy(w) && numbers.is_lower(w) == numbers.is_lower(p);
    };
    bool exact = true;
    for (const LinkTriangle& triangle : triangles) {
      if (std::find(faces.begin(), faces.end(), triangle.label) == faces.end()) exact = false;
      std::vector<SlabPoint> in_plane;
      for (const std::uint32_t v : triangle.v)
        if (const SlabPoint w(v); on_slice(w)) in_plane.push_back(w);
      for (const SlabPoint w : in_plane) {
        if (sides_of(slice, own, numbers.own(w)).has(triangle.label)) continue;
        exact = false;
        wrong.push_back(w);
      }
      if (in_plane.size() < 2 ||
          label_of_triangle(slice, own, numbers.own(in_plane[0]), numbers.own(in_plane[1])) == triangle.label)
        continue;
      exact = false;
      wrong.insert(wrong.end(), in_plane.begin(), in_plane.end());
    }
    if (exact) exact = VertexLink(std::move(triangles)).regular();
    if (!exact) wrong.push_back(p);
  }

  // ---- singularities ------------------------------------------------------------------------------------------------

  /// One round: exact sections first, then each singular point that no mend of this round has touched. False: there was
  /// nothing to do.
  bool improve() {
    if (raise_where_not_exact()) return true;
    std::sort(later_.begin(), later_.end());
    later_.erase(std::unique(later_.begin(), later_.end()), later_.end());
    std::vector<SlabPoint> now;
    std::swap(now, later_);
    Table<CellIndex, bool> touched(complex_->cells().size(), false);
    bool any = false;
    for (const SlabPoint v : now) {
      const std::span<const CellIndex> star = complex_->star(v);
      if (std::all_of(star.begin(), star.end(),
                      [&](CellIndex cell) { return complex_->cell_label(cell) == complex_->cell_label(star.front()); }))
        continue;
      const VertexLink around(complex_->link(v));
      if (around.regular()) continue;
      any = true;
      complex_->mark(v);
      if (std::any_of(star.begin(), star.end(), [&](CellIndex cell) { return touched[cell]; }))
        continue;  // seen again in the next round
      mend_at(v, around);
      for (const CellIndex cell : star) touched[cell] = true;
    }
    if (any && ++rounds_ > limits::most_rounds) throw InternalError("a partition's slab could not be mended");
    return any;
  }

  void mend_at(SlabPoint v, const VertexLink& around) {
    std::size_t& mends = mends_[complex_->original_of(v)];
    ++mends;
    const std::vector<Mend> found =
        around.mends([&](std::uint32_t cell) { return !complex_->is_tetrahedron(CellIndex(cell)); });
    if (mends > limits::single_mends || found.empty()) {
      patch(v, mends > limits::single_mends ? mends - limits::single_mends : 1);
      return;
    }
    for (const std::uint32_t cell : found.front().cells)
      result_.relabelled += complex_->relabel(complex_->tetrahedron(CellIndex(cell)), found.front().label);
  }

  /// The commonest label of the tetrahedra around v, for all of them and those 2^steps - 1 rings further out, with all
  /// their points raised.
  void patch(SlabPoint v, std::size_t steps) {
    ++result_.patches;
    const auto& tets = complex_->tetrahedra();
    Table<TetIndex, bool> in(tets.size(), false);
    std::vector<TetIndex> patch;
    const auto add_at = [&](SlabPoint p) {
      for (const TetIndex t : complex_->tetrahedra_at(p)) {
        if (in[t]) continue;
        in[t] = true;
        patch.push_back(t);
      }
    };
    add_at(complex_->original_of(v));
    const std::size_t rings = std::size_t{1} << std::min<std::size_t>(steps, 40);
    std::size_t from = 0;
    for (std::size_t ring = 1; ring < rings && from < patch.size(); ++ring)
      for (const std::size_t end = patch.size(); from < end; ++from)
        for (const SlabPoint p : tets[patch[from]].v) add_at(p);
    std::map<Label, std::size_t> votes;
    for (const TetIndex t : patch) ++votes[complex_->label(t)];
    const auto most = std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
                        return a.second < b.second;
                      })->first;
    for (const TetIndex t : patch) {
      result_.relabelled += complex_->relabel(t, most);
      for (const SlabPoint p : tets[t].v) complex_->raise(p);
    }
  }

  // ---- result -------------------------------------------------------------------------------------------------------

  PartitionSlab collect() {
    const double low = complex_->raised_lower(), high = complex_->raised_upper();
    if (complex_->any_raised() && !(lower_.z < low && low < high && high < upper_.z))
      throw InputError("slices-too-close", place_,
                       fmt::format("too few numbers lie between the heights {} and {} of two neighbouring slices",
                                   lower_.z, upper_.z),
                       "Leave one of the slices out");
    const std::size_t on_slices = complex_->raised().size();
    Table<SlabPoint, std::uint32_t> number(2 * on_slices);
    for (const SlabPoint p : complex_->on_slices()) {
      number[p] = p;
      if (!complex_->raised()[p]) continue;
      number[complex_->copy_of(p)] = static_cast<std::uint32_t>(on_slices + result_.added.size());
      result_.added.push_back(complex_->place(complex_->copy_of(p)));
    }
    for (const CellIndex c : complex_->cells().indices()) {
      if (complex_->cell_label(c) == void_label) continue;
      const SlabComplex::Corners& v = complex_->cells()[c];
      result_.tetrahedra.push_back({number[v[0]], number[v[1]], number[v[2]], number[v[3]]});
      result_.labels.push_back(complex_->cell_label(c));
    }
    return std::move(result_);
  }

  const PartitionSlice& lower_;
  const PartitionSlice& upper_;
  const Materials& materials_;
  const Place& place_;
  const Progress& progress_;
  std::optional<SlabComplex> complex_;
  std::vector<SlabPoint> later_;         // raised copies to be looked at
  Table<SlabPoint, std::size_t> mends_;  // at each point
  std::size_t rounds_ = 0;
  PartitionSlab result_;
};

}  // namespace

PartitionSlab solve_partition_slab(const PartitionSlice& lower, const PartitionSlice& upper, const Materials& materials,
                                   const Place& place, const Progress& progress) {
  return SlabSolver(lower, upper, materials, place, progress).run();
}

}  // namespace odontoscope::partition
