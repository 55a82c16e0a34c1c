#include "recon/sample/sample_tooth.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/partition/own_faces.h"
#include "recon/sample/field_loops.h"
#include "recon/sample/implicit.h"
#include "recon/sample/tooth_field.h"
#include "recon/sample/tooth_table.h"

namespace odontoscope {
namespace {

using namespace sample;

void require_in_range(std::string_view what, double value, double low, double high) {
  if (value >= low && value <= high) return;  // NaN fails
  throw UsageError(std::string(what) + " of the sample tooth is out of range",
                   "Choose a value from " + std::to_string(low) + " to " + std::to_string(high) + " mm");
}

/// The three solids on one grid, slice by slice.
class Sampler {
 public:
  explicit Sampler(const ToothShape& shape) : shape_(shape) {
    const auto count = static_cast<std::size_t>(std::ceil(2 * limits::sample_half_width / limits::sample_grid));
    const double low = -limits::sample_grid * static_cast<double>(count) / 2;
    grid_ = {{low, low}, limits::sample_grid, count + 1, count + 1, std::vector<double>((count + 1) * (count + 1))};
    for (std::size_t row = 0; row < grid_.rows; ++row)
      for (std::size_t column = 0; column < grid_.columns; ++column)
        heights_.push_back(occlusal_heights(shape, grid_.at(column, row)));
    tissue_.resize(heights_.size());
    pulp_.resize(heights_.size());
  }

  void go_to(double z) {
    // So far outside the dentine, mm, no pulp is looked for, which saves a sixth of the time; open canals reach out.
    const bool closed = std::none_of(shape_.canals.begin(), shape_.canals.end(), [](const Canal& c) { return c.open; });
    const double no_pulp = closed ? 0.5 : far_outside;
    const ToothSection section(shape_, z);
    for (std::size_t row = 0; row < grid_.rows; ++row) {
      for (std::size_t column = 0; column < grid_.columns; ++column) {
        const std::size_t i = row * grid_.columns + column;
        const Point2 at = grid_.at(column, row);
        tissue_[i] = section.hard_tissue(heights_[i], at);
        pulp_[i] = tissue_[i].dentine < no_pulp ? section.pulp(at) : no_pulp;
      }
    }
  }

  // Contours of the slice gone to; the gap is taken from the outer of two structures.
  std::vector<Polygon> enamel(bool apart) {
    if (!apart) return loops([this](std::size_t i) { return std::max(tissue_[i].tooth, tissue_[i].below_margin); });
    return loops([this](std::size_t i) {
      return std::max({tissue_[i].tooth, limits::sample_gap - tissue_[i].dentine, tissue_[i].below_margin});
    });
  }
  std::vector<Polygon> dentine(bool hollow) {
    if (!hollow) return loops([this](std::size_t i) { return tissue_[i].dentine; });
    return loops([this](std::size_t i) { return std::max(tissue_[i].dentine, limits::sample_gap - pulp_[i]); });
  }
  std::vector<Polygon> pulp() {
    return loops([this](std::size_t i) { return pulp_[i]; });
  }

 private:
  template <class Value>
  std::vector<Polygon> loops(const Value& value) {
    for (std::size_t i = 0; i < grid_.values.size(); ++i) grid_.values[i] = value(i);
    return trace(grid_, limits::sample_speck);
  }

  const ToothShape& shape_;
  Grid grid_;
  std::vector<OcclusalHeights> heights_;
  std::vector<HardTissue> tissue_;
  std::vector<double> pulp_;
};

double lowest_apex(const ToothShape& shape) {
  double low = shape.top_z;
  for (const Root& root : shape.roots) low = std::min(low, root.apex_z);
  return low;
}

/// With canals that leave their roots. The rounded tips lose as much as leaves a rim around the foramina, and the roots
/// keep their length.
ToothShape opened(ToothShape shape) {
  constexpr double rim = 0.2;  // mm
  for (Canal& canal : shape.canals) canal.open = true;
  for (Root& root : shape.roots) root.cut = rim;
  return shape;
}

double at_root(const Profile& profile, const Root& root) { return profile(root.apex_z); }

std::vector<Point3> canal_axis(const ToothShape& shape, const Canal& canal, double low, double high) {
  constexpr double step = 0.5;
  const auto count = static_cast<std::size_t>(std::ceil((high - low) / step));
  std::vector<Point3> axis;
  for (std::size_t i = 0; i <= count; ++i)
    axis.push_back(
        canal_centre(shape, canal, low + (high - low) * static_cast<double>(i) / static_cast<double>(count)));
  return axis;
}

/// Lowest height at which something lies between the roots' axes, halfway between them.
double furcation(const ToothShape& shape) {
  if (shape.roots.size() < 2) return shape.cervical_line.z;
  constexpr double step = 0.01;
  const double low = std::max(shape.roots[0].apex_z, shape.roots[1].apex_z);
  for (double z = low; z < shape.cervical_line.z; z += step) {
    const ToothSection section(shape, z);
    const Root &a = shape.roots[0], &b = shape.roots[1];
    bool joined = true;
    constexpr int samples = 40;
    const OcclusalHeights above{shape.top_z, shape.top_z};
    for (int i = 0; i <= samples && joined; ++i) {
      const double t = static_cast<double>(i) / samples;
      const Point2 at{a.x(z) + t * (b.x(z) - a.x(z)), a.y(z) + t * (b.y(z) - a.y(z))};
      joined = section.hard_tissue(above, at).tooth < 0;
    }
    if (joined) return z;
  }
  return shape.cervical_line.z;
}

/// Heights between which sections change so fast along z that slices are set closer.
std::vector<Zone> steep_zones(const ToothShape& shape) {
  constexpr double apical = 0.9, edge = 0.25;  // mm: the apex with the canal's end; floor or roof of the chamber
  std::vector<Zone> zones = shape.steep;
  for (const Root& root : shape.roots) zones.push_back({root.apex_z, root.apex_z + apical});
  const PulpChamber& box = shape.chamber;
  double tip = box.high.z;
  for (const Horn& horn : shape.horns) tip = std::max(tip, horn.tip.z + horn.tip_radius);
  if (shape.roots.size() > 1 || shape.canals.size() > 1) zones.push_back({box.low.z - edge, box.low.z + edge});
  zones.push_back({box.high.z - edge, tip});
  const CervicalLine& line = shape.cervical_line;
  zones.push_back({line.z, line.z + std::max({line.rise_mesial, line.rise_distal, line.rise_lingual}) + edge});
  return zones;
}

/// Ascending, the first a little above the lowest apex.
std::vector<double> slice_heights(const ToothShape& shape, const std::optional<double>& even) {
  std::vector<double> heights;
  const double low = lowest_apex(shape);
  if (even) {
    for (double i = 0.5; low + i * *even < shape.top_z; ++i) heights.push_back(low + i * *even);
    return heights;
  }
  const std::vector<Zone> zones = steep_zones(shape);
  constexpr double fine = 0.16, usual = 0.33;  // mm
  for (double z = low + fine / 2; z < shape.top_z;) {
    heights.push_back(z);
    const auto reaches = [&](const Zone& zone) { return z + usual > zone.low && z < zone.high; };
    const bool steep = std::any_of(zones.begin(), zones.end(), reaches);
    z += steep ? fine : usual;
  }
  return heights;
}

}  // namespace

ContourStack sample_tooth(ToothKind kind, const SampleOptions& options) {
  if (options.slice_spacing)
    require_in_range("the slice spacing", *options.slice_spacing, limits::sample_least_slice_spacing,
                     limits::sample_most_slice_spacing);
  require_in_range("the point spacing", options.point_spacing, limits::sample_least_point_spacing,
                   limits::sample_most_point_spacing);
  const ToothShape shape = options.open_apex ? opened(tooth_shape(kind)) : tooth_shape(kind);
  Sampler sampler(shape);
  const bool apart = options.walls == SampleWalls::apart;
  const Thinning thinning{options.point_spacing, limits::sample_deviation, limits::sample_clearance,
                          limits::sample_grain};
  ContourStack stack;
  stack.source = std::string("sample ") + name(kind);
  for (const double z : slice_heights(shape, options.slice_spacing)) {
    Slice slice;
    slice.z = z;
    const auto add = [&](const char* structure, const std::vector<Polygon>& loops) {
      for (Polygon& loop : thin(loops, thinning)) slice.contours.push_back({structure, std::move(loop)});
    };
    sampler.go_to(slice.z);
    add("enamel", sampler.enamel(apart));
    add("dentine", sampler.dentine(apart && options.hollow_dentine));
    add("pulp", sampler.pulp());
    if (!slice.contours.empty()) stack.slices.push_back(std::move(slice));
  }
  if (options.walls == SampleWalls::shared) return partition::own_faces(stack, {"pulp", "dentine", "enamel"});
  return stack;
}

SampleFacts sample_facts(ToothKind kind) {
  const ToothShape shape = tooth_shape(kind);
  SampleFacts facts;
  facts.kind = kind;
  facts.tooth = shape.tooth;
  facts.fdi = shape.fdi;
  facts.proportions = shape.proportions;
  facts.cervix_z = shape.cervical_line.z;
  facts.top_z = shape.top_z;
  facts.furcation_z = furcation(shape);
  facts.chamber_low_z = shape.chamber.low.z;
  facts.chamber_high_z = shape.chamber.high.z;
  for (const Root& root : shape.roots)
    facts.roots.push_back({root.name, {at_root(root.x, root), at_root(root.y, root), root.apex_z}});
  for (const Cusp& cusp : shape.occlusal.cusps) facts.cusps.push_back({cusp.name, cusp.tip});
  if (facts.cusps.empty()) facts.cusps = shape.landmarks;
  for (const Horn& horn : shape.horns)
    facts.horns.push_back({horn.name, {horn.tip.x, horn.tip.y, horn.tip.z + horn.tip_radius}});
  for (const Canal& canal : shape.canals) {
    const Root& root = shape.roots[canal.root];
    const double low = root.apex_z + apical_stop;
    facts.canals.push_back(
        {canal.name, root.name, low, shape.chamber.low.z, canal_axis(shape, canal, low, shape.chamber.low.z)});
  }
  return facts;
}

}  // namespace odontoscope
