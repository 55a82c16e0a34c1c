#include "recon/partition/slab_complex.h"

#include <algorithm>
#include <limits>

#include "recon/delaunay/predicates.h"
#include "recon/partition/limits.h"

namespace odontoscope::partition {

using delaunay::SlabTetrahedron;

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

SlabComplex::SlabComplex(const PartitionSlice& lower, const PartitionSlice& upper,
                         std::vector<SlabTetrahedron> tetrahedra)
    : lower_(lower),
      upper_(upper),
      tets_(std::move(tetrahedra)),
      offset_(static_cast<std::uint32_t>(lower.planar.points.size())),
      on_slices_(offset_ + static_cast<std::uint32_t>(upper.planar.points.size())),
      raised_lower_(lower.z + raise_step(lower.z, upper.z)),
      raised_upper_(upper.z - raise_step(lower.z, upper.z)),
      labels_(tets_.size(), void_label),
      raised_(on_slices_, false),
      shares_(on_slices_, 0),
      times_lowered_(on_slices_, 0),
      changed_(2 * std::size_t{on_slices_}, true) {
  first_at_.assign(on_slices_ + 1, 0);
  for (const SlabTetrahedron& tet : tets_)
    for (const std::uint32_t v : tet.v) ++first_at_[v + 1];
  for (std::uint32_t p = 0; p < on_slices_; ++p) first_at_[p + 1] += first_at_[p];
  at_.resize(first_at_[on_slices_]);
  std::vector<std::uint32_t> fill(first_at_.begin(), first_at_.end() - 1);
  for (std::uint32_t t = 0; t < tets_.size(); ++t)
    for (const std::uint32_t v : tets_[t].v) at_[fill[v]++] = t;
}

Point3 SlabComplex::place(std::uint32_t v) const {
  const bool is_raised = v >= on_slices_;
  const std::uint32_t p = is_raised ? v - on_slices_ : v;
  const Point2 at = slice_of(p).planar.points[own(p)];
  if (is_raised) return {at.x, at.y, height(p)};
  return {at.x, at.y, is_lower(p) ? lower_.z : upper_.z};
}

/// Of its raised copy.
double SlabComplex::height(std::uint32_t p) const {
  const double rise = shares_[p] * (upper_.z - lower_.z);
  return is_lower(p) ? std::max(raised_lower_, lower_.z + rise) : std::min(raised_upper_, upper_.z - rise);
}

void SlabComplex::set_share(std::uint32_t p, double share) { shares_[p] = share; }

/// To a share that it has not yet; too often, as far as usual.
void SlabComplex::lower_to(std::uint32_t p, double share) {
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
  std::uint32_t best = delaunay::none;
  double best_share = 0, least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t v : tet.v) {
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
  for (const std::uint32_t v : tet.v)
    if (rises_far(v)) lower_to(v, limits::ramp_lowered * shares_[v]);
}

void SlabComplex::mark_around(std::uint32_t t) {
  for (const std::uint32_t v : tets_[t].v) changed_[v] = changed_[v + on_slices_] = true;
}

bool SlabComplex::raise(std::uint32_t p) {
  if (raised_[p]) return false;
  raised_[p] = any_raised_ = stale_ = true;
  fresh_.push_back(p);
  changed_[p] = changed_[p + on_slices_] = true;
  const auto [begin, end] = tetrahedra_at(p);
  for (auto t = begin; t != end; ++t) mark_around(*t);
  return true;
}

bool SlabComplex::relabel(std::uint32_t t, Label label) {
  if (labels_[t] == label) return false;
  labels_[t] = label;
  mark_around(t);
  return true;
}

std::vector<std::uint32_t> SlabComplex::keep_positive() {
  std::vector<std::uint32_t> around;
  for (std::size_t i = 0; i < fresh_.size(); ++i) {  // it grows meanwhile
    const auto [begin, end] = tetrahedra_at(fresh_[i]);
    for (auto t = begin; t != end; ++t) {
      around.push_back(*t);
      const SlabTetrahedron& tet = tets_[*t];
      const auto mixed = [&](int from, int to) {
        const int count = static_cast<int>(
            std::count_if(tet.v.begin() + from, tet.v.begin() + to, [&](std::uint32_t v) { return raised_[v]; }));
        return count > 0 && count < to - from;
      };
      const bool low = mixed(0, tet.lower_count), high = mixed(tet.lower_count, 4),
                 ramp = std::any_of(tet.v.begin(), tet.v.end(), [&](std::uint32_t v) { return rises_far(v); });
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
    thicken(lower_, 0, true);
    thicken(upper_, offset_, false);
  }
  collect_stars();
}

/// As add_prism (recon/delaunay/prism.h) cuts it, without what has no height.
void SlabComplex::thicken(const PartitionSlice& slice, std::uint32_t first, bool upwards) {
  for (std::uint32_t t = 0; t < slice.planar.triangles.size(); ++t) {
    const auto& given = slice.planar.triangles[t].v;
    if (!raised_[given[0] + first] && !raised_[given[1] + first] && !raised_[given[2] + first]) continue;
    std::array<std::uint32_t, 3> v = given;
    std::sort(v.begin(), v.end());
    const int fixed = (v[0] == given[0]) + (v[1] == given[1]) + (v[2] == given[2]);
    const bool even = fixed != 1;  // one corner in place: the other two were swapped
    for (std::uint32_t& p : v) p += first;
    const std::array<std::uint32_t, 3> to{top(v[0]), top(v[1]), top(v[2])};
    const std::array<std::pair<Corners, bool>, 3> parts{{{{v[0], v[1], v[2], to[2]}, to[2] != v[2]},
                                                         {{v[0], v[1], to[2], to[1]}, to[1] != v[1]},
                                                         {{v[0], to[1], to[2], to[0]}, to[0] != v[0]}}};
    for (auto [corners, there] : parts) {
      if (!there) continue;
      if (even != upwards) std::swap(corners[0], corners[1]);
      cells_.push_back(corners);
      thick_labels_.push_back(slice.label(t));
    }
  }
}

void SlabComplex::collect_stars() {
  const std::size_t points = 2 * std::size_t{on_slices_};
  first_.assign(points + 1, 0);
  for (const Corners& cell : cells_)
    for (const std::uint32_t v : cell) ++first_[v + 1];
  for (std::size_t p = 0; p < points; ++p) first_[p + 1] += first_[p];
  star_.resize(first_[points]);
  std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
  for (std::uint32_t c = 0; c < cells_.size(); ++c)
    for (const std::uint32_t v : cells_[c]) star_[fill[v]++] = c;
}

std::vector<LinkTriangle> SlabComplex::link(std::uint32_t v) const {
  std::vector<LinkTriangle> triangles;
  const auto [begin, end] = star(v);
  triangles.reserve(static_cast<std::size_t>(end - begin));
  for (auto cell = begin; cell != end; ++cell) {
    LinkTriangle triangle{{}, cell_label(*cell), *cell};
    int k = 0;
    for (const std::uint32_t w : cells_[*cell])
      if (w != v) triangle.v[k++] = w;
    triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<std::uint32_t> SlabComplex::take_changed() {
  std::vector<std::uint32_t> list;
  for (std::uint32_t v = 0; v < changed_.size(); ++v) {
    if (!changed_[v]) continue;
    changed_[v] = false;
    list.push_back(v);
  }
  return list;
}

}  // namespace odontoscope::partition
