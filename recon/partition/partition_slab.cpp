#include "recon/partition/partition_slab.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "recon/delaunay/predicates.h"
#include "recon/delaunay/slab.h"
#include "recon/partition/limits.h"
#include "recon/partition/slab_labels.h"
#include "recon/partition/vertex_link.h"

namespace odontoscope::partition {
namespace {

using delaunay::none;
using delaunay::SlabTetrahedron;
using Corners = std::array<std::uint32_t, 4>;

class SlabSolver {
 public:
  SlabSolver(const PartitionSlice& lower, const PartitionSlice& upper, const Materials& materials, const Place& place, const Progress& progress)
      : lower_(lower),
        upper_(upper),
        materials_(materials),
        place_(place),
        progress_(progress),
        offset_(static_cast<std::uint32_t>(lower.planar.points.size())),
        on_slices_(offset_ + static_cast<std::uint32_t>(upper.planar.points.size())),
        raised_(on_slices_, false),
        mends_(on_slices_, 0) {}

  PartitionSlab run() {
    result_.cut = !lower_.conforming || !upper_.conforming;
    if (result_.cut || lower_.empty() || upper_.empty()) {
      raise_all();
      build();
      return collect();
    }
    tets_ = delaunay::bare_slab(lower_.planar, upper_.planar);
    const SlabLabels rule(tets_, lower_, upper_, materials_);
    for (const std::uint32_t p : rule.ending()) raised_[p] = true;
    do {
      label_all(rule);
      keep_positive();
      build();
    } while (raise_where_not_exact());
    while (mend()) {
      keep_positive();
      build();
      while (raise_where_not_exact()) {
        keep_positive();
        build();
      }
    }
    return collect();
  }

 private:
  // ---- places -------------------------------------------------------------------------------------------------------

  bool is_lower(std::uint32_t p) const { return p < offset_; }
  Point2 in_plane(std::uint32_t p) const { return is_lower(p) ? lower_.planar.points[p] : upper_.planar.points[p - offset_]; }

  double raised_height(std::uint32_t p) const {
    const double step = limits::raise_share * (upper_.z - lower_.z);
    return is_lower(p) ? lower_.z + step : upper_.z - step;
  }

  Point3 top(std::uint32_t p) const {
    const Point2 at = in_plane(p);
    return {at.x, at.y, raised_[p] ? raised_height(p) : is_lower(p) ? lower_.z : upper_.z};
  }

  void refuse_too_close() const {
    throw InputError("slices-too-close", place_,
                     fmt::format("no two numbers lie between the heights {} and {} of two neighbouring slices", lower_.z, upper_.z),
                     "Leave one of the slices out");
  }

  // ---- raising ------------------------------------------------------------------------------------------------------

  void raise_all() { raised_.assign(on_slices_, true); }

  bool raise(std::uint32_t p) {
    if (raised_[p]) return false;
    raised_[p] = true;
    return true;
  }

  void label_all(const SlabLabels& rule) {
    labels_.resize(tets_.size());
    std::vector<std::uint32_t> losers;
    for (std::uint32_t t = 0; t < tets_.size(); ++t) labels_[t] = rule.label(t, raised_, losers);
    for (const std::uint32_t p : losers) raise(p);
  }

  /// Where some corners in one slice are raised and some are not, and the tetrahedron is not positive any more, all are.
  void keep_positive() {
    for (bool changed = true; changed;) {
      changed = false;
      for (const SlabTetrahedron& tet : tets_) {
        const auto mixed = [&](int from, int to) {
          bool any = false, all = true;
          for (int i = from; i < to; ++i) {
            any = any || raised_[tet.v[i]];
            all = all && raised_[tet.v[i]];
          }
          return any && !all;
        };
        const bool low = mixed(0, tet.lower_count), high = mixed(tet.lower_count, 4);
        if (!low && !high) continue;
        if (delaunay::orientation(top(tet.v[0]), top(tet.v[1]), top(tet.v[2]), top(tet.v[3])) > 0) continue;
        for (int i = low ? 0 : tet.lower_count; i < (high ? 4 : tet.lower_count); ++i) changed = raise(tet.v[i]) || changed;
      }
    }
  }

  // ---- the complex --------------------------------------------------------------------------------------------------

  /// The tetrahedra of the triangulation, then the thickened triangles of both slices.
  void build() {
    number_.assign(on_slices_, none);
    result_.added.clear();
    for (std::uint32_t p = 0; p < on_slices_; ++p) {
      if (!raised_[p]) continue;
      number_[p] = on_slices_ + static_cast<std::uint32_t>(result_.added.size());
      result_.added.push_back(top(p));
    }
    if (!result_.added.empty() && !(lower_.z < lower_.z + limits::raise_share * (upper_.z - lower_.z) &&
                                    lower_.z + limits::raise_share * (upper_.z - lower_.z) < upper_.z - limits::raise_share * (upper_.z - lower_.z) &&
                                    upper_.z - limits::raise_share * (upper_.z - lower_.z) < upper_.z))
      refuse_too_close();
    cells_.clear();
    cell_labels_.clear();
    for (std::uint32_t t = 0; t < tets_.size(); ++t) {
      Corners v{};
      for (int i = 0; i < 4; ++i) v[i] = up(tets_[t].v[i]);
      cells_.push_back(v);
      cell_labels_.push_back(labels_[t]);
    }
    thicken(lower_, 0, true);
    thicken(upper_, offset_, false);
    collect_stars();
  }

  std::uint32_t up(std::uint32_t p) const { return number_[p] == none ? p : number_[p]; }

  /// As add_prism (recon/delaunay/prism.h) cuts it, without what has no height.
  void thicken(const PartitionSlice& slice, std::uint32_t first, bool upwards) {
    for (std::uint32_t t = 0; t < slice.planar.triangles.size(); ++t) {
      std::array<std::uint32_t, 3> v = slice.planar.triangles[t].v;
      const auto& given = slice.planar.triangles[t].v;
      std::sort(v.begin(), v.end());
      const int fixed = (v[0] == given[0]) + (v[1] == given[1]) + (v[2] == given[2]);
      const bool even = fixed != 1;
      for (std::uint32_t& p : v) p += first;
      const std::array<std::uint32_t, 3> to{up(v[0]), up(v[1]), up(v[2])};
      const std::array<std::pair<Corners, bool>, 3> parts{{{{v[0], v[1], v[2], to[2]}, to[2] != v[2]},
                                                          {{v[0], v[1], to[2], to[1]}, to[1] != v[1]},
                                                          {{v[0], to[1], to[2], to[0]}, to[0] != v[0]}}};
      for (auto [corners, there] : parts) {
        if (!there) continue;
        if (even != upwards) std::swap(corners[0], corners[1]);
        cells_.push_back(corners);
        cell_labels_.push_back(slice.label(t));
      }
    }
  }

  void collect_stars() {
    const std::size_t points = on_slices_ + result_.added.size();
    first_.assign(points + 1, 0);
    for (const Corners& cell : cells_)
      for (const std::uint32_t v : cell) ++first_[v + 1];
    for (std::size_t p = 0; p < points; ++p) first_[p + 1] += first_[p];
    star_.resize(first_[points]);
    std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
    for (std::uint32_t c = 0; c < cells_.size(); ++c)
      for (const std::uint32_t v : cells_[c]) star_[at[v]++] = c;
  }

  std::vector<LinkTriangle> link(std::uint32_t v) const {
    std::vector<LinkTriangle> triangles;
    for (std::uint32_t s = first_[v]; s < first_[v + 1]; ++s) {
      LinkTriangle triangle{{}, cell_labels_[star_[s]], star_[s]};
      int k = 0;
      for (const std::uint32_t w : cells_[star_[s]])
        if (w != v) triangle.v[k++] = w;
      triangles.push_back(triangle);
    }
    return triangles;
  }

  bool one_label(std::uint32_t v) const {
    for (std::uint32_t s = first_[v]; s < first_[v + 1]; ++s)
      if (cell_labels_[star_[s]] != cell_labels_[star_[first_[v]]]) return false;
    return true;
  }

  // ---- exact sections -----------------------------------------------------------------------------------------------

  /// Raises points of the slices at which something touches that is none of their faces, or at which a face is no disc seen from the slab.
  bool raise_where_not_exact() {
    progress_.check();
    std::vector<std::uint32_t> wrong;
    for (std::uint32_t p = 0; p < on_slices_; ++p)
      if (!raised_[p]) check_exact(p, wrong);
    bool changed = false;
    for (const std::uint32_t p : wrong) changed = raise(p) || changed;
    return changed;
  }

  void check_exact(std::uint32_t p, std::vector<std::uint32_t>& wrong) const {
    const PartitionSlice& slice = is_lower(p) ? lower_ : upper_;
    const std::uint32_t first = is_lower(p) ? 0 : offset_, own = p - first;
    std::vector<Label> faces{};
    for (std::uint32_t s = slice.planar.first_spoke[own]; s < slice.planar.first_spoke[own + 1]; ++s)
      faces.push_back(slice.label(slice.planar.spokes[s].triangle));
    const std::vector<LinkTriangle> triangles = link(p);
    const auto on_slice = [&](std::uint32_t w) { return w < on_slices_ && is_lower(w) == is_lower(p); };
    bool exact = true;
    for (const LinkTriangle& triangle : triangles) {
      if (std::find(faces.begin(), faces.end(), triangle.label) == faces.end()) exact = false;
      for (const std::uint32_t w : triangle.v) {
        if (!on_slice(w) || sides_of(slice, own, w - first).has(triangle.label)) continue;
        exact = false;
        wrong.push_back(w);
      }
    }
    if (exact) exact = VertexLink(triangles).regular();
    if (!exact) wrong.push_back(p);
  }

  // ---- singularities ------------------------------------------------------------------------------------------------

  /// Mends each singular point that no mend of this round has touched. False: there was none.
  bool mend() {
    progress_.check();
    std::vector<bool> touched(cells_.size(), false);
    bool any = false;
    const auto points = static_cast<std::uint32_t>(on_slices_ + result_.added.size());
    for (std::uint32_t v = 0; v < points; ++v) {
      if (first_[v] == first_[v + 1] || one_label(v)) continue;
      const VertexLink around(link(v));
      if (around.regular()) continue;
      any = true;
      mend_at(v, around, touched);
    }
    if (any && ++rounds_ > most_rounds()) throw InternalError("a partition's slab could not be mended");
    return any;
  }

  std::size_t most_rounds() const { return 1000 + on_slices_; }

  void mend_at(std::uint32_t v, const VertexLink& around, std::vector<bool>& touched) {
    const auto changed = [&](std::uint32_t cell) { return touched[cell]; };
    for (std::uint32_t s = first_[v]; s < first_[v + 1]; ++s)
      if (changed(star_[s])) return;   // see again in the next round
    const std::uint32_t slice_point = point_of(v);
    std::size_t& mends = mends_[slice_point];
    ++mends;
    const auto found = around.mends([&](std::uint32_t cell) { return cell >= tets_.size(); });
    if (mends <= limits::single_mends && !found.empty()) {
      for (const std::uint32_t cell : found.front().cells) relabel(cell, found.front().label);
    } else {
      patch(v, mends > limits::single_mends ? mends - limits::single_mends : 1);
    }
    for (std::uint32_t s = first_[v]; s < first_[v + 1]; ++s) touched[star_[s]] = true;
  }

  std::uint32_t point_of(std::uint32_t v) const {
    if (v < on_slices_) return v;
    return static_cast<std::uint32_t>(std::find(number_.begin(), number_.end(), v) - number_.begin());
  }

  void relabel(std::uint32_t t, Label label) {
    result_.relabelled += labels_[t] != label;
    labels_[t] = label;
  }

  /// The commonest label of the tetrahedra around v, for all of them and their neighbours, `steps` doublings far.
  void patch(std::uint32_t v, std::size_t steps) {
    ++result_.patches;
    std::vector<bool> in(tets_.size(), false);
    std::vector<std::uint32_t> patch;
    for (std::uint32_t s = first_[v]; s < first_[v + 1]; ++s)
      if (star_[s] < tets_.size()) patch.push_back(star_[s]);
    for (const std::uint32_t t : patch) in[t] = true;
    const std::size_t rings = std::size_t{1} << std::min<std::size_t>(steps, 40);
    std::size_t from = 0;
    for (std::size_t ring = 1; ring < rings && from < patch.size(); ++ring) {
      const std::size_t end = patch.size();
      for (; from < end; ++from)
        for (const std::uint32_t p : tets_[patch[from]].v)
          for (std::uint32_t s = first_[up(p)]; s < first_[up(p) + 1]; ++s) {
            if (star_[s] >= tets_.size() || in[star_[s]]) continue;
            in[star_[s]] = true;
            patch.push_back(star_[s]);
          }
    }
    std::map<Label, std::size_t> votes;
    for (const std::uint32_t t : patch) ++votes[labels_[t]];
    Label most = void_label;
    std::size_t count = 0;
    for (const auto& [label, times] : votes)
      if (times > count) {
        most = label;
        count = times;
      }
    for (const std::uint32_t t : patch) {
      relabel(t, most);
      for (const std::uint32_t p : tets_[t].v) raise(p);
    }
  }

  PartitionSlab collect() {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (cell_labels_[c] == void_label) continue;
      result_.tetrahedra.push_back(cells_[c]);
      result_.labels.push_back(cell_labels_[c]);
    }
    return std::move(result_);
  }

  const PartitionSlice& lower_;
  const PartitionSlice& upper_;
  const Materials& materials_;
  const Place& place_;
  const Progress& progress_;
  const std::uint32_t offset_, on_slices_;
  std::vector<SlabTetrahedron> tets_;
  std::vector<Label> labels_;
  std::vector<bool> raised_;
  std::vector<std::size_t> mends_;
  std::size_t rounds_ = 0;
  std::vector<std::uint32_t> number_;   // of a raised point; none: it stays in its slice
  std::vector<Corners> cells_;          // of the triangulation, then thickened triangles
  std::vector<Label> cell_labels_;
  std::vector<std::uint32_t> first_, star_;   // cells at v: star_[first_[v]] to star_[first_[v + 1]]
  PartitionSlab result_;
};

}  // namespace

PartitionSlab solve_partition_slab(const PartitionSlice& lower, const PartitionSlice& upper, const Materials& materials, const Place& place,
                                   const Progress& progress) {
  return SlabSolver(lower, upper, materials, place, progress).run();
}

}  // namespace odontoscope::partition
