#include "recon/volume/label_contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "recon/contours/trace.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/volume/label_meetings.h"
#include "recon/volume/lattice_crossing.h"

namespace odontoscope {
namespace {

using trace::Vertex;

class LabelField {
 public:
  LabelField(const Volume& volume, const Lattice& lattice, const SmoothLabels* smooth, const LabelMeetings* meetings,
             std::size_t k, const LabelValues& label)
      : pixels_(volume.slice(k)),
        width_(static_cast<std::ptrdiff_t>(volume.size[0])),
        height_(static_cast<std::ptrdiff_t>(volume.size[1])),
        label_(label),
        lattice_(lattice),
        smooth_(smooth),
        meetings_(meetings),
        k_(k) {}

  bool inside(Vertex v) const { return in_image(v) && label_(pixels_[v.j * width_ + v.i]); }
  /// Never: joining one label across a cell's corner could cross another's join over the other diagonal.
  bool joined(Vertex, Vertex, Vertex, Vertex) const { return false; }

  Point2 crossing(Vertex in, Vertex out) const {
    constexpr double middle = 0.5;
    if (smooth_ && in_image(out)) {
      const int axis = in.j == out.j ? 0 : 1;
      const Vertex low = in.i < out.i || in.j < out.j ? in : out;
      return trace::between_from_low(lattice_, in, out, smooth_->crossing(k_, low, axis));
    }
    return trace::between(lattice_, in, out, middle);
  }

  void bend(const trace::Stand& stand, std::vector<Point2>& points) const {
    if (!meetings_) return;
    constexpr float outside = std::numeric_limits<float>::quiet_NaN();
    meetings_->append(
        lattice_, stand, [&](Vertex v) { return in_image(v) ? pixels_[v.j * width_ + v.i] : outside; }, points);
  }

 private:
  bool in_image(Vertex v) const { return v.i >= 0 && v.j >= 0 && v.i < width_ && v.j < height_; }

  const float* pixels_;
  std::ptrdiff_t width_, height_;
  const LabelValues& label_;
  const Lattice& lattice_;
  const SmoothLabels* smooth_;
  const LabelMeetings* meetings_;
  std::size_t k_;
};

/// "0, 1, 2, ..." for the message; looks only as far as it needs to.
std::string some_values(const Volume& volume) {
  constexpr std::size_t enough = 12;
  std::set<float> seen;
  for (const float value : volume.values) {
    if (!is_overlap(volume, value) && seen.insert(value).second && seen.size() > enough) break;
  }
  const bool more = seen.size() > enough;
  if (more) seen.erase(std::prev(seen.end()));
  std::string words;
  for (const float value : seen) words += fmt::format("{}{}", words.empty() ? "" : ", ", value);
  return more ? words + " and more" : words;
}

void check_label(const Volume& volume, std::int64_t label) {
  if (label > limits::largest_label || label < -limits::largest_label) {
    throw UsageError(fmt::format("the label {} is beyond {}", label, limits::largest_label),
                     "number the labels from 1 up");
  }
  if (std::any_of(volume.values.begin(), volume.values.end(), LabelValues(volume, label))) return;
  Place place;
  place.file = volume.source;
  throw InputError("label-not-found", place,
                   fmt::format("no voxel has the label {}; the volume has {}", label, some_values(volume)),
                   "give a label that is there (--label N[=NAME])");
}

/// None where labels overlap: then nobody knows whose a place is.
std::shared_ptr<const LabelMeetings> meetings_of(const Volume& volume, const std::vector<LabelLevel>& labels) {
  std::vector<float> values;
  for (const LabelLevel& level : labels) {
    if (LabelValues(volume, level.label).any_shared()) return {};
    values.push_back(static_cast<float>(level.label));
  }
  return std::make_shared<const LabelMeetings>(std::move(values));
}

}  // namespace

std::shared_ptr<const SmoothLabels> smoothed(const Volume& volume, const std::vector<LabelLevel>& labels,
                                             const SmoothLabelsOptions& options, const Progress& progress) {
  std::vector<float> values;
  for (const LabelLevel& level : labels) {
    check_label(volume, level.label);
    if (LabelValues(volume, level.label).any_shared()) {
      throw UsageError(fmt::format("\"{}\" overlaps other segments, and --smooth moves borders that two labels share",
                                   level.structure),
                       "Leave out --smooth");
    }
    values.push_back(static_cast<float>(level.label));
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return std::make_shared<const SmoothLabels>(volume, values, options, progress);
}

std::vector<LevelTracer> label_tracers(const Volume& volume, const std::vector<LabelLevel>& labels,
                                       const std::shared_ptr<const SmoothLabels>& smooth) {
  std::vector<LevelTracer> tracers;
  const std::shared_ptr<const LabelMeetings> meetings = meetings_of(volume, labels);
  for (const LabelLevel& level : labels) {
    check_label(volume, level.label);
    const auto trace_slice = [&volume, smooth, meetings, lattice = Lattice(volume),
                              label = LabelValues(volume, level.label)](std::size_t k, const LevelTracer::Take& take) {
      trace::contours(LabelField(volume, lattice, smooth.get(), meetings.get(), k, label), volume.size[0],
                      volume.size[1], take);
    };
    tracers.push_back({level.structure, trace_slice, fmt::format("label {}", level.label)});
  }
  return tracers;
}

TracedContours label_contours(const Volume& volume, const std::vector<LabelLevel>& labels, const TraceOptions& options,
                              const Progress& progress) {
  validate_volume(volume);
  return trace_levels(volume, label_tracers(volume, labels), options, progress);
}

}  // namespace odontoscope
