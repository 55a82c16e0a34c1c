#include "recon/partition/slab_complex.h"

#include <algorithm>
#include <limits>

#include "recon/delaunay/predicates.h"
#include "recon/partition/limits.h"

namespace odontoscope::partition {

using delaunay::SlabTetrahedra;
using delaunay::SlabTetrahedron;
using delaunay::SlicePoint;
using delaunay::Thickened;

namespace {

/// How far points are raised off slices at these heights.
double raise_step(double lower, double upper) {
  const double step = limits::raise_share * (upper - lower);
  return lower < lower + step && upper - step < upper ? step : limits::raise_share_narrow * (upper - lower);
}

/// Rounded; positive as `orientation` is.
double six_volumes(const std::array<Point3, 4>& p) {
  std::array<Point3, 3> d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = {p[k + 1].x - p[0].x, p[k + 1].y - p[0].y, p[k + 1].z - p[0].z};
  return d[2].x * (d[0].y * d[1].z - d[0].z * d[1].y) + d[2].y * (d[0].z * d[1].x - d[0].x * d[1].z) +
         d[2].z * (d[0].x * d[1].y - d[0].y * d[1].x);
}

}  // namespace

SlabComplex::SlabComplex(const PartitionSlice& lower, const PartitionSlice& upper, SlabTetrahedra tetrahedra)
    : lower_(lower),
      upper_(upper),
      tets_(std::move(tetrahedra)),
      numbers_(lower.planar),
      on_slices_(static_cast<std::uint32_t>(lower.planar.points.size() + upper.planar.points.size())),
      raised_lower_(lower.z + raise_step(lower.z, upper.z)),
      raised_upper_(upper.z - raise_step(lower.z, upper.z)),
      labels_(tets_.size(), void_label),
      raised_(on_slices_, false),
      shares_(on_slices_, 0),
      times_lowered_(on_slices_, 0),
      changed_(2 * std::size_t{on_slices_}, true) {
  at_ = {on_slices_, [this](const auto& add) {
           for (const TetIndex t : tets_.indices())
             for (const SlabPoint v : tets_[t].v) add(v, t);
         }};
}

Point3 SlabComplex::place(SlabPoint v) const {
  const SlabPoint p = is_copy(v) ? original_of(v) : v;
  const PartitionSlice& slice = slice_of(p);
  const Point2 at = slice.planar.points[numbers_.own(p)];
  return {at.x, at.y, is_copy(v) ? height(p) : slice.z};
}

/// Of its raised copy.
double SlabComplex::height(SlabPoint p) const {
  const double rise = shares_[p] * (upper_.z - lower_.z);
  return numbers_.is_lower(p) ? std::max(raised_lower_, lower_.z + rise) : std::min(raised_upper_, upper_.z - rise);
}

void SlabComplex::set_share(SlabPoint p, double share) { shares_[p] = share; }

/// To a share that it has not yet; too often, as far as usual.
void SlabComplex::lower_to(SlabPoint p, double share) {
  shares_[p] = share <= limits::raise_share || ++times_lowered_[p] > limits::ramp_times_lowered ? 0 : share;
  fresh_.push_back(p);
}

/// The corner that has to be lowered least for the tetrahedron to be positive; all, where one alone will not do.
/// Precondition: one was raised farther than usual.
void SlabComplex::lower_corners(const SlabTetrahedron& tet) {
  const auto volume = [&] {
    return six_volumes({place(top(tet.v[0])), place(top(tet.v[1])), place(top(tet.v[2])), place(top(tet.v[3]))});
  };
  const double now = volume();
  SlabPoint best;
  double best_share = 0, least = std::numeric_limits<double>::infinity();
  for (const SlabPoint v : tet.v) {
    const double share = shares_[v];
    if (!rises_far(v)) continue;
    shares_[v] = 0;
    const double low = volume();
    shares_[v] = share;
    if (!(low > 0) || !(low > now)) continue;
    const double drop = share * std::min(1.0, limits::ramp_spare - now / (low - now));
    if (drop >= least) continue;
    least = drop;
    best = v;
    best_share = share - drop;
  }
  if (best != delaunay::none) return lower_to(best, best_share);
  for (const SlabPoint v : tet.v)
    if (rises_far(v)) lower_to(v, limits::ramp_lowered * shares_[v]);
}

void SlabComplex::mark_around(TetIndex t) {
  for (const SlabPoint v : tets_[t].v) changed_[v] = changed_[copy_of(v)] = true;
}

bool SlabComplex::raise(SlabPoint p) {
  if (raised_[p]) return false;
  raised_[p] = any_raised_ = stale_ = true;
  fresh_.push_back(p);
  changed_[p] = changed_[copy_of(p)] = true;
  for (const TetIndex t : tetrahedra_at(p)) mark_around(t);
  return true;
}

bool SlabComplex::relabel(TetIndex t, Label label) {
  if (labels_[t] == label) return false;
  labels_[t] = label;
  mark_around(t);
  return true;
}

std::vector<TetIndex> SlabComplex::keep_positive() {
  std::vector<TetIndex> around;
  for (std::size_t i = 0; i < fresh_.size(); ++i) {  // it grows meanwhile
    for (const TetIndex t : tetrahedra_at(fresh_[i])) {
      around.push_back(t);
      const SlabTetrahedron& tet = tets_[t];
      const auto mixed = [&](int from, int to) {
        const int count = static_cast<int>(
            std::count_if(tet.v.begin() + from, tet.v.begin() + to, [&](SlabPoint v) { return raised_[v]; }));
        return count > 0 && count < to - from;
      };
      const bool low = mixed(0, tet.lower_count), high = mixed(tet.lower_count, 4),
                 ramp = std::any_of(tet.v.begin(), tet.v.end(), [&](SlabPoint v) { return rises_far(v); });
      if (!low && !high && !ramp) continue;
      if (delaunay::orientation(place(top(tet.v[0])), place(top(tet.v[1])), place(top(tet.v[2])),
                                place(top(tet.v[3]))) > 0)
        continue;
      if (ramp) {
        lower_corners(tet);
        continue;
      }
      for (int k = low ? 0 : tet.lower_count; k < (high ? 4 : tet.lower_count); ++k) raise(tet.v[k]);
    }
  }
  fresh_.clear();
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  return around;
}

void SlabComplex::build() {
  if (!stale_) return;
  stale_ = false;
  cells_.clear();
  thick_labels_.clear();
  for (const SlabTetrahedron& tet : tets_)
    cells_.push_back({top(tet.v[0]), top(tet.v[1]), top(tet.v[2]), top(tet.v[3])});
  if (any_raised_) {
    thicken(
        lower_, [this](SlicePoint p) { return numbers_.of_lower(p); }, Thickened::upwards);
    thicken(
        upper_, [this](SlicePoint p) { return numbers_.of_upper(p); }, Thickened::downwards);
  }
  collect_stars();
}

template <class Number>
void SlabComplex::thicken(const PartitionSlice& slice, Number number, Thickened direction) {
  for (const delaunay::TriangleIndex t : slice.planar.triangles.indices()) {
    delaunay::add_prism(
        slice.planar.triangles[t], number, [&](SlicePoint p) { return top(number(p)); }, direction, cells_);
    thick_labels_.resize(cells_.size() - tets_.size(), slice.label(t));
  }
}

void SlabComplex::collect_stars() {
  star_ = {2 * std::size_t{on_slices_}, [this](const auto& add) {
             for (const CellIndex c : cells_.indices())
               for (const SlabPoint v : cells_[c]) add(v, c);
           }};
}

std::vector<LinkTriangle> SlabComplex::link(SlabPoint v) const {
  std::vector<LinkTriangle> triangles;
  triangles.reserve(star(v).size());
  for (const CellIndex cell : star(v)) {
    LinkTriangle triangle{{}, cell_label(cell), cell};
    int k = 0;
    for (const SlabPoint w : cells_[cell])
      if (w != v) triangle.v[k++] = w;
    triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<SlabPoint> SlabComplex::take_changed() {
  std::vector<SlabPoint> list;
  for (const SlabPoint v : changed_.indices()) {
    if (!changed_[v]) continue;
    changed_[v] = false;
    list.push_back(v);
  }
  return list;
}

}  // namespace odontoscope::partition
