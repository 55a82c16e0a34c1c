#include "engine/app/volume_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "engine/app/words.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/volume/read_volume.h"
#include "recon/volume/simplify_contours.h"

namespace odontoscope::app {
namespace {

template <typename Number>
std::optional<Number> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

struct NamedText {
  std::string value, name;
};

/// "T=NAME" in its two parts; without a name the structure is the usual one.
NamedText named(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return {text, Contour{}.structure};
  return {text.substr(0, equals), text.substr(equals + 1)};
}

IsoLevel iso_level(const std::string& text) {
  const NamedText parts = named(text);
  const auto threshold = number_in<double>(parts.value);
  if (!threshold || !std::isfinite(*threshold) || parts.name.empty()) {
    throw UsageError(fmt::format("--iso {}: that is no T or T=NAME with a number T", text),
                     "For example --iso 120, or --iso 120=dentine --iso 195=enamel");
  }
  return {*threshold, parts.name};
}

LabelLevel label_level(const std::string& text) {
  const NamedText parts = named(text);
  const auto label = number_in<std::int64_t>(parts.value);
  if (!label || parts.name.empty()) {
    throw UsageError(fmt::format("--label {}: that is no N or N=NAME with a whole number N", text),
                     "For example --label 2=dentine --label 3=pulp");
  }
  return {*label, parts.name};
}

std::array<double, 3> spacing_triple(const std::string& text) {
  std::array<double, 3> spacing{};
  std::string_view rest = text;
  for (std::size_t axis = 0; axis < spacing.size(); ++axis) {
    const bool last = axis + 1 == spacing.size();
    const std::size_t comma = last ? rest.size() : rest.find(',');
    const auto number = comma == std::string_view::npos ? std::nullopt : number_in<double>(rest.substr(0, comma));
    if (!number || !std::isfinite(*number) || *number <= 0) {
      throw UsageError(fmt::format("--spacing {}: that is not three positive numbers", text),
                       "Give the size of a voxel in mm along columns, rows and slices, for example --spacing 0.12,0.12,0.12");
    }
    spacing[axis] = *number;
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return spacing;
}

void refuse_two_levels_of_one_name(const VolumeRequest& request) {
  std::vector<std::string> names;
  for (const IsoLevel& level : request.iso) names.push_back(level.structure);
  for (const LabelLevel& level : request.labels) names.push_back(level.structure);
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice == names.end()) return;
  throw UsageError(fmt::format("two of --iso and --label make a structure of the same name, {}", *twice),
                   "Name them: --iso 120=dentine --iso 195=enamel");
}

void tell_what_was_read(const Volume& volume, Console& console) {
  console.say(fmt::format("{}: {} x {} x {} voxels of {} x {} x {} mm", volume.source, volume.size[0], volume.size[1],
                          volume.size[2], measured(volume.spacing[0]), measured(volume.spacing[1]),
                          measured(volume.spacing[2])));
  if (volume.tilt_degrees > limits::tilt_unspoken) {
    console.say(fmt::format("  its axes are turned by {:.1f} degrees in the file; the model keeps the image's own axes",
                            volume.tilt_degrees));
  }
}

}  // namespace

void add_volume_options(CLI::App& parser, VolumeOptions& options) {
  const std::string group = "Volumes";
  parser.add_option("--iso", options.iso, "Surface at value T, as structure NAME (default: tooth); repeatable")
      ->allow_extra_args(false)->type_name("T[=NAME]")->group(group);
  parser.add_option("--label", options.label, "Surface of label N of a label map; repeatable")
      ->allow_extra_args(false)->type_name("N[=NAME]")->group(group);
  parser.add_option("--min-area", options.min_area, "Drop contours that enclose less, mm^2")
      ->type_name("A")->check(CLI::NonNegativeNumber)->group(group);
  parser.add_option("--spacing", options.spacing, "Size of a voxel in mm, instead of the file's")
      ->type_name("X,Y,Z")->group(group);
  parser.add_option("--simplify", options.simplify, "Fewer points: contours may move by up to E mm, and stay disjoint")
      ->type_name("E")->check(CLI::NonNegativeNumber);
}

VolumeRequest understood(const VolumeOptions& options) {
  VolumeRequest request;
  for (const std::string& text : options.iso) request.iso.push_back(iso_level(text));
  for (const std::string& text : options.label) request.labels.push_back(label_level(text));
  if (!options.spacing.empty()) request.spacing = spacing_triple(options.spacing);
  refuse_two_levels_of_one_name(request);
  return request;
}

ContourStack contours_of_volume(const std::string& file, const VolumeOptions& options, Session& session) {
  const VolumeRequest request = understood(options);
  const Progress progress = session.progress();
  const Volume volume = read_volume(file, {.spacing = request.spacing}, progress);
  tell_what_was_read(volume, session.console);
  const ValueRange range = validate_volume(volume);
  std::vector<LevelTracer> tracers = iso_tracers(volume, range, request.iso);
  for (LevelTracer& tracer : label_tracers(volume, request.labels)) tracers.push_back(std::move(tracer));
  TracedContours traced = trace_levels(volume, tracers, {.min_area = options.min_area.value_or(0)}, progress);
  for (const LevelReport& level : traced.levels) {
    session.console.say(fmt::format("  {}: {}, {}{}", level.structure, counted(level.contours, "contour"),
                                    counted(level.points, "point"),
                                    level.dropped == 0 ? "" : fmt::format("; {} below --min-area left out", level.dropped)));
  }
  return simplified(std::move(traced.stack), options, session);
}

ContourStack simplified(ContourStack stack, const VolumeOptions& options, Session& session) {
  if (!options.simplify) return stack;
  SimplifiedContours fewer = simplify_contours(stack, {.tolerance = *options.simplify}, session.progress());
  session.console.say(fmt::format("  simplified from {} to {}, moved by at most {} mm",
                                  counted(fewer.points_before, "point"), counted(fewer.points_after, "point"),
                                  measured(fewer.largest_deviation)));
  return std::move(fewer.stack);
}

bool named_like_a_volume(const std::string& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) return true;
  for (const std::string_view ending : {".nrrd", ".nhdr", ".mha", ".mhd", ".nii", ".nii.gz", ".hdr", ".img", ".dcm"}) {
    if (file.ends_with(ending)) return true;
  }
  return false;
}

}  // namespace odontoscope::app
