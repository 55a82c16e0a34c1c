#include "engine/app/reshape_volume.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "engine/app/words.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"

namespace odontoscope::app {
namespace {

VolumeBox box_from(const std::string& text) {
  std::array<double, 6> bounds{};
  std::string_view rest = text;
  bool good = std::count(text.begin(), text.end(), ',') == 5;
  for (std::size_t n = 0; good && n < bounds.size(); ++n) {
    const std::string_view word = rest.substr(0, std::min(rest.find(','), rest.size()));
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), bounds[n]);
    good = !word.empty() && error == std::errc{} && end == word.data() + word.size() && std::isfinite(bounds[n]);
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
  }
  if (good && bounds[0] < bounds[1] && bounds[2] < bounds[3] && bounds[4] < bounds[5])
    return {{bounds[0], bounds[2], bounds[4]}, {bounds[1], bounds[3], bounds[5]}};
  throw UsageError(fmt::format("--crop {}: that is no box", text.substr(0, limits::quoted_length)),
                   "Give from and to along x, y and z in mm, as in --crop -12,10,0,15.5,30,52; --histogram tells where "
                   "the volume lies");
}

std::string size_of(const Volume& volume) {
  return fmt::format("{} x {} x {} voxels", volume.size[0], volume.size[1], volume.size[2]);
}

std::string rows_of(const RigidMotion& motion) {
  std::vector<std::string> rows;
  for (const auto& row : motion.matrix())
    rows.push_back(fmt::format("{:.9g} {:.9g} {:.9g} {:.9g}", row[0] + 0.0, row[1] + 0.0, row[2] + 0.0, row[3] + 0.0));
  return fmt::format("{}", fmt::join(rows, "; "));
}

/// Labels are values of a list, an iso level all from its value on.
std::function<bool(float)> belongs_to(const Volume& volume, const VolumeContourOptions& levels) {
  std::vector<LabelValues> labels;
  for (const LabelLevel& level : levels.labels) labels.emplace_back(volume, level.label);
  return [isos = levels.isos, labels](float value) {
    return std::any_of(isos.begin(), isos.end(), [value](const IsoLevel& iso) { return value >= iso.threshold; }) ||
           std::any_of(labels.begin(), labels.end(), [value](const LabelValues& label) { return label(value); });
  };
}

/// A value below every other: no level's. Of labels one that there is not.
float none_of(const Volume& volume, Sampling sampling) {
  const float lowest = *std::min_element(volume.values.begin(), volume.values.end());
  return sampling == Sampling::nearest ? std::min(lowest, 0.0f) - 1 : lowest;
}

}  // namespace

void add_reshape_options(CLI::App& parser, ReshapeWords& words) {
  const std::string group = "Volumes";
  parser.add_option("--crop", words.crop, "Take this box of the volume alone, mm")
      ->type_name("X0,X1,Y0,Y1,Z0,Z1")
      ->group(group);
  parser
      .add_option("--resample", words.resample, "Voxels of MM along all axes: linear, of labels (--label) the nearest")
      ->type_name("MM")
      ->group(group);
  parser.add_flag("--upright", words.upright, "Turn what the levels bound so that its longest axis is z")->group(group);
}

ReshapeRequest understood(const ReshapeWords& words) {
  ReshapeRequest request{{}, words.resample, words.upright};
  if (!words.crop.empty()) request.crop = box_from(words.crop);
  if (words.resample &&
      !(*words.resample >= limits::smallest_spacing && *words.resample <= limits::largest_coordinate)) {
    throw UsageError(fmt::format("--resample {}: that is no size of a voxel", *words.resample),
                     "Give millimetres, as in --resample 0.2");
  }
  return request;
}

void crop_told(Volume& volume, const ReshapeRequest& request, Console& console) {
  if (!request.crop) return;
  volume = cropped(std::move(volume), *request.crop);
  console.say(fmt::format("  cropped to {}", size_of(volume)));
}

std::optional<RigidMotion> reshape_told(Volume& volume, const ReshapeRequest& request,
                                        const VolumeContourOptions& levels, Session& session) {
  const Sampling sampling = levels.labels.empty() ? Sampling::linear : Sampling::nearest;
  const std::string way = sampling == Sampling::linear ? "interpolated linearly" : "each with the label of the nearest";
  if (request.resample) {
    volume = resampled(volume, *request.resample, sampling, session.progress());
    session.console.say(
        fmt::format("  resampled to {} of {} mm, {}", size_of(volume), measured(*request.resample), way));
  }
  if (!request.upright) return std::nullopt;
  const double spacing = *std::min_element(volume.spacing.begin(), volume.spacing.end());
  UprightVolume standing =
      upright(volume, belongs_to(volume, levels), spacing, sampling, none_of(volume, sampling), session.progress());
  volume = std::move(standing.volume);
  session.console.say(fmt::format("  stood upright: turned by {:.2f} degrees, onto {} of {} mm, {}",
                                  standing.motion.degrees(), size_of(volume), measured(spacing), way));
  session.console.say(
      fmt::format("  the file's coordinates became these by the matrix [{}]", rows_of(standing.motion)));
  return standing.motion;
}

}  // namespace odontoscope::app
