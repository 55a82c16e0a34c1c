#include "turned_tooth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "recon/core/limits.h"
#include "recon/sample/implicit.h"
#include "recon/sample/tooth_field.h"

namespace odontoscope::test {
namespace {

using namespace sample;

constexpr double steepest = 2.0;   // change of a value per mm of way, outside the steep heights
constexpr std::size_t block = 8;   // points on the side of the largest block that is judged by its middle alone
constexpr double box_step = 0.2;   // mm; of the grid by which boxes are found
constexpr double margin = 0.5;     // mm; that boxes leave beyond what that grid found
constexpr double far_above = 100;  // mm; an occlusal surface that plays no part
constexpr double widest = 7.5;     // mm; half the width of any tooth of the family before it is stretched

Values values_at(const ToothSection& section, const OcclusalHeights& heights, Point2 at, TurnedTooth::Walls walls) {
  const HardTissue tissue = section.hard_tissue(heights, at);
  const double pulp = section.pulp(at), gap = walls == TurnedTooth::Walls::apart ? limits::sample_gap : 0;
  if (walls == TurnedTooth::Walls::filled)
    return {std::max(tissue.tooth, tissue.below_margin), tissue.dentine, std::max(pulp, tissue.tooth)};
  return {std::max({tissue.tooth, gap - tissue.dentine, tissue.below_margin}), std::max(tissue.dentine, gap - pulp),
          std::max(pulp, tissue.tooth)};
}

std::uint8_t bits_of(const Values& values) {
  std::uint8_t bits = 0;
  for (std::size_t s = 0; s < values.size(); ++s)
    if (values[s] < 0) bits = static_cast<std::uint8_t>(bits | 1u << s);
  return bits;
}

/// Halves a block until its middle tells all of it: ask(i, j, k) gives values, `far` whether they do, fill sets them.
template <class Ask, class Far, class Fill>
void refine(std::array<std::size_t, 3> first, std::array<std::size_t, 3> end, std::size_t size, const Ask& ask,
            const Far& far, const Fill& fill) {
  std::array<std::size_t, 3> middle{}, stop{};
  for (int a = 0; a < 3; ++a) {
    if (first[a] >= end[a]) return;
    stop[a] = std::min(first[a] + size, end[a]);
    middle[a] = std::min(first[a] + size / 2, end[a] - 1);
  }
  const Values values = ask(middle);
  if (size == 1 || far(values, size, middle)) {
    for (std::size_t k = first[2]; k < stop[2]; ++k)
      for (std::size_t j = first[1]; j < stop[1]; ++j)
        for (std::size_t i = first[0]; i < stop[0]; ++i) fill(i, j, k, values);
    return;
  }
  for (unsigned child = 0; child < 8; ++child) {
    std::array<std::size_t, 3> from = first;
    for (unsigned a = 0; a < 3; ++a)
      if (child >> a & 1) from[a] += size / 2;
    refine(from, stop, size / 2, ask, far, fill);
  }
}

}  // namespace

TurnedTooth::TurnedTooth(RandomTooth tooth) : tooth_(std::move(tooth)) {
  const auto& stretch = tooth_.pose.stretch;
  least_stretch_ = *std::min_element(stretch.begin(), stretch.end());
  const ToothShape& shape = tooth_.shape;
  // Rounded ends widen with the square root of the height above their tip.
  constexpr double before = 0.15, round_end = 0.5, round_orifice = 0.75;
  for (const Root& root : shape.roots) steep_.push_back({root.apex_z - before, root.apex_z + root.blunt});
  for (const Canal& canal : shape.canals) {
    const double end = shape.roots[canal.root].apex_z + apical_stop;
    steep_.push_back({end - before, end + round_end});
  }
  steep_.push_back({shape.canal_top_z - round_orifice, shape.canal_top_z + before});
  find_boxes();
}

void TurnedTooth::find_boxes() {
  const ToothShape& shape = tooth_.shape;
  const auto& stretch = tooth_.pose.stretch;
  // The lowest place of the occlusal surface over the crown, fissures and junction included.
  constexpr double step = 0.15, beyond = 0.8, below = 0.6;
  const double mid_crown = (shape.cervical_line.z + shape.top_z) / 2;
  const ToothSection cervical(shape, shape.cervical_line.z + 1), middle(shape, mid_crown);
  crown_z_ = shape.top_z;
  for (double y = -widest; y < widest; y += step) {
    for (double x = -widest; x < widest; x += step) {
      const OcclusalHeights none{far_above, far_above};
      if (cervical.hard_tissue(none, {x, y}).tooth > beyond && middle.hard_tissue(none, {x, y}).tooth > beyond)
        continue;
      const OcclusalHeights heights = occlusal_heights(shape, {x, y});
      crown_z_ = std::min({crown_z_, heights.enamel - below, heights.dentine - below});
    }
  }
  double apex = shape.top_z;
  for (const Root& root : shape.roots) apex = std::min(apex, root.apex_z);
  own_box_ = {{-widest * stretch[0], -widest * stretch[1], (apex - 1) * stretch[2]},
              {widest * stretch[0], widest * stretch[1], (shape.top_z + 1) * stretch[2]}};
  Box found{own_box_.high, own_box_.low};
  image_box_ = {{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
  const auto take_in = [](Box& box, const Point3& p) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  };
  const Grid grid = own_grid(box_step);
  const Voxels voxels = own_voxels(grid);
  for (std::size_t k = 0; k < voxels.layers; ++k)
    for (std::size_t j = 0; j < voxels.rows; ++j)
      for (std::size_t i = 0; i < voxels.columns; ++i)
        if (voxels.values[voxels.index(i, j, k)]) {
          take_in(found, grid.point(i, j, k));
          take_in(image_box_, to_image(grid.point(i, j, k)));
        }
  for (Box* box : {&found, &image_box_}) {
    box->low = {box->low.x - margin, box->low.y - margin, box->low.z - margin};
    box->high = {box->high.x + margin, box->high.y + margin, box->high.z + margin};
  }
  own_box_ = found;
}

bool TurnedTooth::far_from_surfaces(const Values& values, double reach, double z, double z_reach) const {
  if (!skip_) return false;
  for (const double value : values)
    if (std::abs(value) < steepest * reach) return false;
  return std::none_of(steep_.begin(), steep_.end(),
                      [&](const auto& zone) { return z + z_reach > zone.first && z - z_reach < zone.second; });
}

Point3 TurnedTooth::to_own(const Point3& p) const {
  const double ct = std::cos(tooth_.pose.tilt), st = std::sin(tooth_.pose.tilt);
  const double cs = std::cos(tooth_.pose.spin), ss = std::sin(tooth_.pose.spin);
  const double y = ct * p.y + st * p.z, z = ct * p.z - st * p.y;
  return {cs * p.x + ss * y, cs * y - ss * p.x, z};
}

Point3 TurnedTooth::to_image(const Point3& own) const {
  const double ct = std::cos(tooth_.pose.tilt), st = std::sin(tooth_.pose.tilt);
  const double cs = std::cos(tooth_.pose.spin), ss = std::sin(tooth_.pose.spin);
  const double x = cs * own.x - ss * own.y, y = ss * own.x + cs * own.y;
  return {x, ct * y - st * own.z, st * y + ct * own.z};
}

/// A line of the image along x: it runs level in the tooth, whatever the tilt, so that one section serves all of it.
class TurnedTooth::Line {
 public:
  Line(const TurnedTooth& tooth, const Raster& raster, std::size_t row, double z)
      : Line(tooth, tooth.to_own({raster.x0, raster.y(row), z}), tooth.to_own({raster.x0 + 1, raster.y(row), z}),
             raster.step) {}

  double z() const { return z_; }
  Values at(std::size_t column) const {
    const double along = static_cast<double>(column);
    const Point2 at{start_.x + along * step_.x, start_.y + along * step_.y};
    const OcclusalHeights heights =
        z_ > tooth_.crown_z_ ? occlusal_heights(tooth_.tooth_.shape, at) : OcclusalHeights{far_above, far_above};
    Values values = values_at(section_, heights, at, tooth_.walls_);
    for (double& value : values) value *= tooth_.least_stretch_;
    return values;
  }

 private:
  Line(const TurnedTooth& tooth, const Point3& start, const Point3& next, double step)
      : tooth_(tooth),
        z_(start.z / tooth.tooth_.pose.stretch[2]),
        start_{start.x / tooth.tooth_.pose.stretch[0], start.y / tooth.tooth_.pose.stretch[1]},
        step_{(next.x - start.x) * step / tooth.tooth_.pose.stretch[0],
              (next.y - start.y) * step / tooth.tooth_.pose.stretch[1]},
        section_(tooth.tooth_.shape, z_) {}

  const TurnedTooth& tooth_;
  double z_;
  Point2 start_, step_;
  ToothSection section_;
};

Raster TurnedTooth::raster(double step) const {
  Raster raster{image_box_.low.x, image_box_.low.y, step, 0, 0};
  raster.columns = static_cast<std::size_t>(std::ceil((image_box_.high.x - image_box_.low.x) / step)) + 1;
  raster.rows = static_cast<std::size_t>(std::ceil((image_box_.high.y - image_box_.low.y) / step)) + 1;
  return raster;
}

std::vector<Values> TurnedTooth::plane(const Raster& raster, double z) const {
  std::vector<Line> lines;
  for (std::size_t row = 0; row < raster.rows; ++row) lines.emplace_back(*this, raster, row, z);
  std::vector<Values> result(raster.size());
  const double level = std::sin(tooth_.pose.tilt) / tooth_.pose.stretch[2];
  const auto ask = [&](const std::array<std::size_t, 3>& at) { return lines[at[1]].at(at[0]); };
  const auto far = [&](const Values& values, std::size_t size, const std::array<std::size_t, 3>& at) {
    const double half = raster.step * static_cast<double>(size) / 2;
    return far_from_surfaces(values, half * std::sqrt(2.0), lines[at[1]].z(), half * level);
  };
  const auto fill = [&](std::size_t i, std::size_t j, std::size_t, const Values& values) {
    result[raster.index(i, j)] = values;
  };
  for (std::size_t j = 0; j < raster.rows; j += block)
    for (std::size_t i = 0; i < raster.columns; i += block)
      refine({i, j, 0}, {raster.columns, raster.rows, 1}, block, ask, far, fill);
  return result;
}

Mask TurnedTooth::mask(const Raster& raster, double z) const {
  const std::vector<Values> values = plane(raster, z);
  Mask mask(values.size());
  std::transform(values.begin(), values.end(), mask.begin(), bits_of);
  return mask;
}

Grid TurnedTooth::own_grid(double step) const {
  Grid grid{own_box_.low.x, own_box_.low.y, step, step, 0, 0, {}};
  const auto points = [step](double low, double high) {
    return static_cast<std::size_t>(std::ceil((high - low) / step)) + 1;
  };
  grid.columns = points(own_box_.low.x, own_box_.high.x);
  grid.rows = points(own_box_.low.y, own_box_.high.y);
  for (std::size_t k = 0; k < points(own_box_.low.z, own_box_.high.z); ++k)
    grid.layers.push_back({own_box_.low.z + step * static_cast<double>(k), k});
  return grid;
}

template <class Take>
void TurnedTooth::sweep(const Grid& grid, const Take& take) const {
  const auto& stretch = tooth_.pose.stretch;
  std::vector<std::optional<OcclusalHeights>> heights(grid.layer_size());
  std::vector<ToothSection> sections;
  for (const GridLayer& layer : grid.layers) sections.emplace_back(tooth_.shape, layer.z / stretch[2]);
  const auto ask = [&](const std::array<std::size_t, 3>& at) {
    const Point2 place{grid.x(at[0]) / stretch[0], grid.y(at[1]) / stretch[1]};
    OcclusalHeights here{far_above, far_above};
    if (grid.layers[at[2]].z / stretch[2] > crown_z_) {
      std::optional<OcclusalHeights>& known = heights[at[1] * grid.columns + at[0]];
      if (!known) known = occlusal_heights(tooth_.shape, place);
      here = *known;
    }
    Values values = values_at(sections[at[2]], here, place, walls_);
    for (double& value : values) value *= least_stretch_;
    return values;
  };
  const auto far = [&](const Values& values, std::size_t size, const std::array<std::size_t, 3>& at) {
    const double half = grid.dx * static_cast<double>(size) / 2;
    return far_from_surfaces(values, half * std::sqrt(3.0), grid.layers[at[2]].z / stretch[2], half / stretch[2]);
  };
  for (std::size_t k = 0; k < grid.layers.size(); k += block)
    for (std::size_t j = 0; j < grid.rows; j += block)
      for (std::size_t i = 0; i < grid.columns; i += block)
        refine({i, j, k}, {grid.columns, grid.rows, grid.layers.size()}, block, ask, far, take);
}

Voxels TurnedTooth::own_voxels(const Grid& grid) const {
  Voxels voxels(grid.columns, grid.rows, grid.layers.size());
  sweep(grid, [&](std::size_t i, std::size_t j, std::size_t k, const Values& values) {
    voxels.values[voxels.index(i, j, k)] = bits_of(values);
  });
  return voxels;
}

std::array<std::vector<double>, structure_count> TurnedTooth::own_values(const Grid& grid) const {
  std::array<std::vector<double>, structure_count> result;
  result.fill(std::vector<double>(grid.size()));
  sweep(grid, [&](std::size_t i, std::size_t j, std::size_t k, const Values& values) {
    for (std::size_t s = 0; s < structure_count; ++s) result[s][grid.index(i, j, k)] = values[s];
  });
  return result;
}

}  // namespace odontoscope::test
