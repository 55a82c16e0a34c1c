#include "recon/volume/iso_contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/contours/trace.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/volume/lattice_crossing.h"

namespace odontoscope {
namespace {

using trace::Vertex;

class IsoField {
 public:
  IsoField(const Volume& volume, const Lattice& lattice, std::size_t k, double threshold)
      : pixels_(volume.slice(k)),
        width_(static_cast<std::ptrdiff_t>(volume.size[0])),
        height_(static_cast<std::ptrdiff_t>(volume.size[1])),
        threshold_(threshold),
        lattice_(lattice) {}

  bool inside(Vertex v) const { return in_image(v) && excess(v) >= 0; }

  /// Saddle of the bilinear surface over the cell is (a b - c d) / (a + b - c - d), whose denominator is positive here.
  bool joined(Vertex a, Vertex b, Vertex c, Vertex d) const {
    if (!in_image(c) || !in_image(d)) return false;
    return excess(a) * excess(b) >= excess(c) * excess(d);
  }

  Point2 crossing(Vertex in, Vertex out) const {
    constexpr double border = 0.5;
    if (!in_image(out)) return trace::between(lattice_, in, out, border);
    const double fraction = excess(in) / (excess(in) - excess(out));
    return trace::between(lattice_, in, out,
                          std::clamp(fraction, limits::grid_vertex_margin, 1 - limits::grid_vertex_margin));
  }

 private:
  bool in_image(Vertex v) const { return v.i >= 0 && v.j >= 0 && v.i < width_ && v.j < height_; }
  double excess(Vertex v) const { return static_cast<double>(pixels_[v.j * width_ + v.i]) - threshold_; }

  const float* pixels_;
  std::ptrdiff_t width_, height_;
  double threshold_;
  const Lattice& lattice_;
};

void check_crossed(const Volume& volume, ValueRange range, double threshold) {
  if (!std::isfinite(threshold)) {
    throw UsageError(fmt::format("the iso value {} is not a finite number", threshold), "give a number (--iso T)");
  }
  const bool all = range.lowest >= threshold;
  const bool none = range.highest < threshold;
  if (!all && !none) return;
  Place place;
  place.file = volume.source;
  throw InputError(
      "nothing-crosses-iso", place,
      fmt::format("nothing crosses the iso value {}: {} voxel has at least that value; the volume's values run "
                  "from {} to {}",
                  threshold, all ? "every" : "no", range.lowest, range.highest),
      "give an iso value above the lowest and up to the highest value");
}

}  // namespace

std::vector<LevelTracer> iso_tracers(const Volume& volume, ValueRange range, const std::vector<IsoLevel>& levels) {
  std::vector<LevelTracer> tracers;
  for (const IsoLevel& level : levels) {
    check_crossed(volume, range, level.threshold);
    const auto trace_slice = [&volume, lattice = Lattice(volume), threshold = level.threshold](
                                 std::size_t k, const LevelTracer::Take& take) {
      trace::contours(IsoField(volume, lattice, k, threshold), volume.size[0], volume.size[1], take);
    };
    tracers.push_back({level.structure, trace_slice, fmt::format("iso value {}", level.threshold)});
  }
  return tracers;
}

TracedContours iso_contours(const Volume& volume, const std::vector<IsoLevel>& levels, const TraceOptions& options,
                            const Progress& progress) {
  const ValueRange range = validate_volume(volume);
  return trace_levels(volume, iso_tracers(volume, range, levels), options, progress);
}

}  // namespace odontoscope
