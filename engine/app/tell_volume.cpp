#include "engine/app/tell_volume.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "engine/app/words.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"

namespace odontoscope::app {
namespace {

std::string dropped_in_words(const LevelReport& level, const Volume& volume) {
  if (level.dropped == 0) return {};
  const double pixel = volume.spacing[0] * volume.spacing[1];
  std::vector<std::string> parts;
  if (level.small.holes > 0) parts.push_back(counted(level.small.holes, "hole"));
  if (level.small.islands > 0) parts.push_back(counted(level.small.islands, "island"));
  return fmt::format("; --min-area left out {}, the largest {} mm^2 ({:.3g} pixels)", fmt::join(parts, " and "),
                     measured(level.small.largest_area), level.small.largest_area / pixel);
}

/// One that goes on from slice to slice is a canal rather than noise.
void warn_of_lost_canals(const LevelReport& level, const Volume& volume, Console& console) {
  const DroppedCounts& small = level.small;
  if (level.dropped == 0) return;
  if (!small.looked_at) {
    console.say(
        fmt::format("  Warning: {}: so many contours were left out that it was not looked at which of them are canals",
                    level.structure));
    return;
  }
  if (small.going_on == 0) return;
  console.say(fmt::format(
      "  Warning: {}: {} of those left out go on in a neighbouring slice{}: they may be canals. A smaller --min-area "
      "keeps them.",
      level.structure, small.going_on,
      small.longest_run < 2
          ? ""
          : fmt::format(", the longest through {} slices from z = {} at ({}, {}) on", small.longest_run,
                        measured(volume.origin.z + static_cast<double>(small.run_slice) * volume.spacing[2]),
                        measured(small.run_at.x), measured(small.run_at.y))));
}

void warn_of_pieces(const LevelReport& level, bool of_labels, Console& console) {
  constexpr std::size_t worth_a_word = 3;
  if (level.pieces < worth_a_word) return;
  console.say(fmt::format(
      "  Warning: {}: {} meet the next slice's at a corner only: something about one voxel wide runs aslant there, and "
      "may fall to pieces. {}",
      level.structure, counted(level.pieces, "contour"),
      of_labels ? "A finer segmentation keeps it whole."
                : "--resample at a quarter of a voxel, with an --iso nearer to the values around it, keeps it whole."));
}

}  // namespace

Thresholds::Thresholds(const Volume& volume)
    : histogram(histogram_of(volume, validate_volume(volume))), source_(volume.source) {}

std::vector<double> Thresholds::all_of(std::size_t classes) const { return otsu_thresholds(histogram, classes); }

double Thresholds::of(const AutoLevel& level) const {
  const std::vector<double> all = all_of(level.classes);
  if (all.size() + 1 == level.classes) return all[level.number - 1];
  Place place;
  place.file = source_;
  throw InputError("nothing-crosses-iso", place,
                   fmt::format("its values fall into fewer than {} classes", level.classes), "Give a value (--iso T)");
}

void tell_volume(const std::string& file, const Volume& volume, Console& console) {
  const std::array<std::size_t, 3>&size = volume.size, &merged = volume.merged;
  const std::array<std::string, 3> spacing{measured(volume.spacing[0]), measured(volume.spacing[1]),
                                           measured(volume.spacing[2])};
  if (merged == std::array<std::size_t, 3>{1, 1, 1})
    console.say(fmt::format("{}: {} x {} x {} voxels of {} x {} x {} mm", file, size[0], size[1], size[2], spacing[0],
                            spacing[1], spacing[2]));
  else
    console.say(fmt::format(
        "{}: of {} x {} x {} voxels one, so that {} x {} x {} of them are looked at, {} x {} x {} mm apart", file,
        merged[0], merged[1], merged[2], size[0], size[1], size[2], spacing[0], spacing[1], spacing[2]));
  if (volume.tilt_degrees > limits::tilt_unspoken) {
    console.say(fmt::format("  its axes are turned by {:.1f} degrees in the file; the model keeps the image's own axes",
                            volume.tilt_degrees));
  }
  constexpr std::size_t most_lines = 20;
  for (std::size_t n = 0; n < std::min(volume.remarks.size(), most_lines); ++n) console.say("  " + volume.remarks[n]);
  if (volume.remarks.size() > most_lines)
    console.say(fmt::format("  and {} more remarks", volume.remarks.size() - most_lines));
}

void tell_place(const Volume& volume, Console& console) {
  const auto end = [&](double origin, std::size_t axis) {
    return origin + static_cast<double>(volume.size[axis] - 1) * volume.spacing[axis];
  };
  const Point3& low = volume.origin;
  console.say(fmt::format("  from {:.6g} to {:.6g} mm along x, {:.6g} to {:.6g} along y, {:.6g} to {:.6g} along z",
                          low.x, end(low.x, 0), low.y, end(low.y, 1), low.z, end(low.z, 2)));
}

void tell_thresholds(const Thresholds& thresholds, Console& console) {
  std::vector<std::string> parts;
  for (const std::size_t classes : {2, 3, 4}) {
    std::vector<std::string> values;
    for (const double threshold : thresholds.all_of(classes)) values.push_back(fmt::format("{:.4g}", threshold));
    if (values.size() + 1 == classes) parts.push_back(fmt::format("{} classes {}", classes, fmt::join(values, ", ")));
  }
  console.say(fmt::format("  Otsu's thresholds: {}", fmt::join(parts, "; ")));
  console.say("  (--iso auto takes that of 2 classes, --iso auto:3/2 the second of 3)");
}

void tell_label_map(const Volume& volume, Console& console) {
  std::set<float> values(volume.values.begin(), volume.values.end());
  std::vector<std::string> words;
  constexpr std::size_t enough = 12;
  for (const float value : values) {
    if (value == 0 || is_overlap(volume, value)) continue;
    if (words.size() == enough) {
      words.push_back("...");
      break;
    }
    std::string name;
    for (const VolumeLabel& label : volume.labels)
      if (static_cast<float>(label.value) == value) name = "=" + label.name;
    words.push_back(fmt::format("{}{}", value, name));
  }
  console.say(
      fmt::format("  Warning: it looks like a label map, with the {} {}: --iso runs between the values of labels; "
                  "--label N[=NAME] takes one of them",
                  words.size() == 1 ? "label" : "labels", fmt::join(words, ", ")));
}

void tell_levels(const std::vector<LevelReport>& levels, const Volume& volume, const VolumeContourOptions& options,
                 Console& console) {
  for (const LevelReport& level : levels) {
    std::string at;  // empty of labels
    for (const IsoLevel& iso : options.isos)
      if (iso.structure == level.structure) at = fmt::format(" (at {:.6g})", iso.threshold);
    console.say(fmt::format("  {}{}: {}, {}{}", level.structure, at, counted(level.contours, "contour"),
                            counted(level.points, "point"), dropped_in_words(level, volume)));
    warn_of_lost_canals(level, volume, console);
    warn_of_pieces(level, at.empty(), console);
  }
}

}  // namespace odontoscope::app
