#include "engine/app/volume_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "engine/app/foreign_input.h"
#include "engine/app/options.h"
#include "engine/app/words.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/input/stack_json.h"
#include "recon/input/validate.h"
#include "recon/volume/read_volume.h"

namespace odontoscope::app {
namespace {

void refuse_two_of_one_name(const VolumeContourOptions& options) {
  std::vector<std::string> names;
  for (const IsoLevel& level : options.isos) names.push_back(level.structure);
  for (const LabelLevel& level : options.labels) names.push_back(level.structure);
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice == names.end()) return;
  throw UsageError(fmt::format("two of --iso and --label make a structure of the same name, {}", *twice),
                   "Name them: --iso 120=dentine --iso 195=enamel");
}

void tell_volume(const std::string& file, const VolumeSummary& volume, Console& console) {
  console.say(fmt::format("{}: {} x {} x {} voxels of {} x {} x {} mm", file, volume.size[0], volume.size[1],
                          volume.size[2], measured(volume.spacing[0]), measured(volume.spacing[1]),
                          measured(volume.spacing[2])));
  if (volume.tilt_degrees > limits::tilt_unspoken) {
    console.say(fmt::format("  its axes are turned by {:.1f} degrees in the file; the model keeps the image's own axes",
                            volume.tilt_degrees));
  }
  if (volume.lattice_shift > 0) {
    console.say(fmt::format("  contours lie on a lattice of 2^{:.0f} mm, which moves them by at most {:.1g} mm",
                            std::log2(volume.lattice_step / 2), volume.lattice_shift));
  }
}

void tell_levels(const std::vector<LevelReport>& levels, Console& console) {
  for (const LevelReport& level : levels) {
    const std::string dropped =
        level.dropped == 0 ? "" : fmt::format("; {} below --min-area left out", counted(level.dropped, "contour"));
    console.say(fmt::format("  {}: {}, {}{}", level.structure, counted(level.contours, "contour"),
                            counted(level.points, "point"), dropped));
  }
}

void tell_simplification(std::size_t before, std::size_t after, double largest_deviation, Console& console) {
  console.say(fmt::format("  simplified from {} to {}, which moved contours by at most {} mm", counted(before, "point"),
                          counted(after, "point"), measured(largest_deviation)));
}

}  // namespace

void add_volume_options(CLI::App& parser, VolumeWords& words) {
  const std::string group = "Volumes";
  repeatable(parser.add_option("--iso", words.isos, "Surface at value T, as structure NAME (default: tooth); repeatable"))
      ->type_name("T[=NAME]")->group(group);
  repeatable(parser.add_option("--label", words.labels, "Surface of label N of a label map; repeatable"))
      ->type_name("N[=NAME]")->group(group);
  parser.add_option("--min-area", words.min_area, "Leave out contours that enclose less, mm^2")
      ->type_name("A")->check(at_least_zero())->group(group);
  parser.add_option("--spacing", words.spacing, "Size of a voxel in mm, instead of the file's")
      ->type_name("X,Y,Z")->group(group);
  parser.add_option("--smooth", words.smooth, "Smooth the borders of labels, by MM and half a voxel at most")
      ->type_name("MM")->check(at_least_zero())->group(group);
  parser.add_option("--simplify", words.simplify, "Fewer points: contours may move by up to E mm, and stay disjoint")
      ->type_name("E")->check(at_least_zero());
}

VolumeContourOptions understood(const VolumeWords& words) {
  VolumeContourOptions options;
  for (const std::string& text : words.isos) options.isos.push_back(parse_iso_level(text));
  for (const std::string& text : words.labels) options.labels.push_back(parse_label_level(text));
  if (!words.spacing.empty()) options.spacing = parse_spacing(words.spacing);
  options.trace.min_area = words.min_area.value_or(0);
  if (words.smooth) options.smooth = SmoothLabelsOptions{*words.smooth};
  if (words.simplify) options.simplify = SimplifyContoursOptions{*words.simplify};
  refuse_two_of_one_name(options);
  return options;
}

ContourStack contours_told(const std::string& file, const VolumeContourOptions& options, Session& session, Volume* volume) {
  Volume read = read_volume(file, {options.spacing}, session.progress());
  VolumeContours found = contours_of_volume(read, options, session.progress());
  if (volume) *volume = std::move(read);
  tell_volume(file, found.volume, session.console);
  tell_levels(found.levels, session.console);
  if (found.smoothing_shift) {
    session.console.say(fmt::format("  smoothed, which moved points by at most {} mm and no voxel across a border",
                                    measured(*found.smoothing_shift)));
  }
  if (const auto& simpler = found.simplification) {
    tell_simplification(simpler->points_before, simpler->points_after, simpler->largest_deviation, session.console);
  }
  return std::move(found.stack);
}

ContourStack simplify_told(const ContourStack& stack, const SimplifyContoursOptions& options, Session& session) {
  SimplifiedContours simpler = simplify_contours(stack, options, session.progress());
  tell_simplification(simpler.points_before, simpler.points_after, simpler.largest_deviation, session.console);
  return std::move(simpler.stack);
}

bool named_like_a_volume(const std::string& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) return true;
  for (const std::string_view ending : {".nrrd", ".nhdr", ".mha", ".mhd", ".nii", ".nii.gz", ".hdr", ".img", ".dcm"}) {
    if (file.ends_with(ending)) return !is_contour_file(file);   // structure sets are DICOM, too
  }
  return false;
}

ContourStack contours_of_input(const std::string& file, const VolumeWords& words, Session& session) {
  if (words.any_level()) return contours_told(file, understood(words), session);
  ContourStack stack = is_contour_file(file) ? converted_told(file, {}, session) : read_stack(file);
  if (words.simplify) {
    validate(stack, session.progress());
    stack = simplify_told(stack, {*words.simplify}, session);
  }
  return stack;
}

void refuse_volume_without_level(const std::string& file, const VolumeWords& words) {
  if (words.smooth && words.labels.empty()) {
    throw UsageError("--smooth is about label maps", "Add --label N, or leave it out: --iso lies between voxels already");
  }
  if (words.any_level()) return;
  if (words.min_area || !words.spacing.empty()) {
    throw UsageError("--min-area and --spacing are about volumes, and nothing says where in a volume the surface lies",
                     "Give --iso T for an image, --label N for a label map");
  }
  if (named_like_a_volume(file)) {
    throw UsageError(fmt::format("{} looks like a volume, and nothing says where in it the surface lies", file),
                     "Give --iso T for an image, --label N for a label map");
  }
}

}  // namespace odontoscope::app
