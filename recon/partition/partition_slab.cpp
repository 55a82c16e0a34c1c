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

class SlabSolver {
 public:
  SlabSolver(const PartitionSlice& lower, const PartitionSlice& upper, const Materials& materials, const Place& place,
             const Progress& progress)
      : lower_(lower), upper_(upper), materials_(materials), place_(place), progress_(progress) {}

  PartitionSlab run() {
    result_.cut = !lower_.conforming || !upper_.conforming;
    const bool apart = result_.cut || lower_.empty() || upper_.empty();
    complex_.emplace(
        lower_, upper_,
        apart ? std::vector<delaunay::SlabTetrahedron>{} : delaunay::bare_slab(lower_.planar, upper_.planar));
    mends_.assign(complex_->on_slices(), 0);
    if (apart) {
      for (std::uint32_t p = 0; p < complex_->on_slices(); ++p) complex_->raise(p);
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
    std::vector<std::uint32_t> open(complex_->tetrahedra().size());
    for (std::uint32_t t = 0; t < open.size(); ++t) open[t] = t;
    while (!open.empty()) {
      std::vector<std::uint32_t> losers;
      for (const std::uint32_t t : open) complex_->relabel(t, rule.label(t, complex_->raised(), losers));
      for (const std::uint32_t p : losers) complex_->raise(p);
      open = complex_->keep_positive();
      if (!open.empty()) continue;
      complex_->build();
      raise_where_not_exact();
      open = complex_->keep_positive();
    }
  }

  void raise_ending(const SlabLabels& rule) {
    for (const RaisedShare& one : rule.ramp()) complex_->set_share(one.point, one.share);
    for (const EndingTriangle& one : rule.ending())
      for (const std::uint32_t own : (one.lower ? lower_ : upper_).planar.triangles[one.triangle].v)
        complex_->raise(complex_->number(own, one.lower));
  }

  // ---- exact sections -----------------------------------------------------------------------------------------------

  /// Raises points of the slices at which something touches that is none of their faces, or at which a face is no disc
  /// seen from the slab. Looks at what has changed since the last time; raised copies of points are left to be looked
  /// at. False: there were none.
  bool raise_where_not_exact() {
    progress_.check();
    std::vector<std::uint32_t> wrong;
    for (const std::uint32_t v : complex_->take_changed()) {
      if (v >= complex_->on_slices())
        later_.push_back(v);
      else if (!complex_->raised()[v])
        check_exact(v, wrong);
    }
    bool any = false;
    for (const std::uint32_t p : wrong) any = complex_->raise(p) || any;
    return any;
  }

  /// Precondition: the three points are the corners of a triangle.
  static Label label_of_triangle(const PartitionSlice& slice, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const EdgeSides sides = sides_of(slice, a, b);
    if (sides.left == sides.right || sides.left_triangle == delaunay::none) return sides.right;
    const auto& corners = slice.planar.triangles[sides.left_triangle].v;
    return std::find(corners.begin(), corners.end(), c) != corners.end() ? sides.left : sides.right;
  }

  void check_exact(std::uint32_t p, std::vector<std::uint32_t>& wrong) const {
    const PartitionSlice& slice = complex_->slice_of(p);
    const std::uint32_t own = complex_->own(p), first = p - own;
    std::vector<Label> faces;
    for (std::uint32_t s = slice.planar.first_spoke[own]; s < slice.planar.first_spoke[own + 1]; ++s)
      faces.push_back(slice.label(slice.planar.spokes[s].triangle));
    std::vector<LinkTriangle> triangles = complex_->link(p);
    const auto on_slice = [&](std::uint32_t w) {
      return w < complex_->on_slices() && complex_->is_lower(w) == complex_->is_lower(p);
    };
    bool exact = true;
    for (const LinkTriangle& triangle : triangles) {
      if (std::find(faces.begin(), faces.end(), triangle.label) == faces.end()) exact = false;
      std::vector<std::uint32_t> in_plane;
      for (const std::uint32_t w : triangle.v)
        if (on_slice(w)) in_plane.push_back(w - first);
      for (const std::uint32_t w : in_plane) {
        if (sides_of(slice, own, w).has(triangle.label)) continue;
        exact = false;
        wrong.push_back(w + first);
      }
      if (in_plane.size() < 2 || label_of_triangle(slice, own, in_plane[0], in_plane[1]) == triangle.label) continue;
      exact = false;
      for (const std::uint32_t w : in_plane) wrong.push_back(w + first);
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
    std::vector<std::uint32_t> now;
    std::swap(now, later_);
    std::vector<bool> touched(complex_->cells(), false);
    bool any = false;
    for (const std::uint32_t v : now) {
      const auto [begin, end] = complex_->star(v);
      if (begin == end || std::all_of(begin, end, [&, first = begin](std::uint32_t cell) {
            return complex_->cell_label(cell) == complex_->cell_label(*first);
          }))
        continue;
      const VertexLink around(complex_->link(v));
      if (around.regular()) continue;
      any = true;
      complex_->mark(v);
      if (std::any_of(begin, end, [&](std::uint32_t cell) { return touched[cell]; }))
        continue;  // seen again in the next round
      mend_at(v, around);
      for (auto cell = begin; cell != end; ++cell) touched[*cell] = true;
    }
    if (any && ++rounds_ > limits::most_rounds) throw InternalError("a partition's slab could not be mended");
    return any;
  }

  void mend_at(std::uint32_t v, const VertexLink& around) {
    std::size_t& mends = mends_[v - complex_->on_slices()];
    ++mends;
    const std::size_t free_cells = complex_->tetrahedra().size();
    const std::vector<Mend> found = around.mends([&](std::uint32_t cell) { return cell >= free_cells; });
    if (mends > limits::single_mends || found.empty()) {
      patch(v, mends > limits::single_mends ? mends - limits::single_mends : 1);
      return;
    }
    for (const std::uint32_t cell : found.front().cells)
      result_.relabelled += complex_->relabel(cell, found.front().label);
  }

  /// The commonest label of the tetrahedra around v, for all of them and those 2^steps - 1 rings further out, with all
  /// their points raised.
  void patch(std::uint32_t v, std::size_t steps) {
    ++result_.patches;
    const auto& tets = complex_->tetrahedra();
    std::vector<bool> in(tets.size(), false);
    std::vector<std::uint32_t> patch;
    const auto add_at = [&](std::uint32_t p) {
      const auto [begin, end] = complex_->tetrahedra_at(p);
      for (auto t = begin; t != end; ++t) {
        if (in[*t]) continue;
        in[*t] = true;
        patch.push_back(*t);
      }
    };
    add_at(v - complex_->on_slices());
    const std::size_t rings = std::size_t{1} << std::min<std::size_t>(steps, 40);
    std::size_t from = 0;
    for (std::size_t ring = 1; ring < rings && from < patch.size(); ++ring)
      for (const std::size_t end = patch.size(); from < end; ++from)
        for (const std::uint32_t p : tets[patch[from]].v) add_at(p);
    std::map<Label, std::size_t> votes;
    for (const std::uint32_t t : patch) ++votes[complex_->label(t)];
    const auto most = std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
                        return a.second < b.second;
                      })->first;
    for (const std::uint32_t t : patch) {
      result_.relabelled += complex_->relabel(t, most);
      for (const std::uint32_t p : tets[t].v) complex_->raise(p);
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
    std::vector<std::uint32_t> number(2 * std::size_t{complex_->on_slices()});
    for (std::uint32_t p = 0; p < complex_->on_slices(); ++p) {
      number[p] = p;
      if (!complex_->raised()[p]) continue;
      number[p + complex_->on_slices()] = complex_->on_slices() + static_cast<std::uint32_t>(result_.added.size());
      result_.added.push_back(complex_->place(p + complex_->on_slices()));
    }
    for (std::uint32_t c = 0; c < complex_->cells(); ++c) {
      if (complex_->cell_label(c) == void_label) continue;
      auto corners = complex_->corners(c);
      for (std::uint32_t& v : corners) v = number[v];
      result_.tetrahedra.push_back(corners);
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
  std::vector<std::uint32_t> later_;  // raised copies to be looked at
  std::vector<std::size_t> mends_;    // at each point
  std::size_t rounds_ = 0;
  PartitionSlab result_;
};

}  // namespace

PartitionSlab solve_partition_slab(const PartitionSlice& lower, const PartitionSlice& upper, const Materials& materials,
                                   const Place& place, const Progress& progress) {
  return SlabSolver(lower, upper, materials, place, progress).run();
}

}  // namespace odontoscope::partition
