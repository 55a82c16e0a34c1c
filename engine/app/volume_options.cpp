#include "engine/app/volume_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "engine/app/foreign_input.h"
#include "engine/app/options.h"
#include "engine/app/plain_input.h"
#include "engine/app/tell_volume.h"
#include "engine/app/words.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/lower_case.h"
#include "recon/input/stack_json.h"
#include "recon/input/validate.h"
#include "recon/volume/label_names.h"
#include "recon/volume/thresholds.h"

namespace odontoscope::app {
namespace {

/// All of `text`.
template <class Number>
bool is_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return !text.empty() && error == std::errc{} && end == text.data() + text.size();
}

/// "auto", "auto=NAME", "auto:3/2", "auto:3/2=NAME"; nothing for anything else.
std::optional<AutoLevel> auto_level(const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string_view which = std::string_view(text).substr(0, equals);
  if (which != "auto" && !which.starts_with("auto:")) return std::nullopt;
  AutoLevel level;
  if (equals < text.size()) level.structure = parse_iso_level("0" + text.substr(equals)).structure;
  if (which == "auto") return level;
  const std::string_view numbers = which.substr(5);
  const std::size_t slash = numbers.find('/');
  constexpr std::size_t most_classes = 5;
  const bool good = slash != numbers.npos && is_number(numbers.substr(0, slash), level.classes) &&
                    is_number(numbers.substr(slash + 1), level.number);
  if (good && level.classes >= 2 && level.classes <= most_classes && level.number >= 1 && level.number < level.classes)
    return level;
  throw UsageError(fmt::format("\"{}\" is none of Otsu's thresholds", text.substr(0, limits::quoted_length)),
                   "Give --iso auto, or --iso auto:3/2 for the second threshold of three classes (2 to 5)");
}

VolumeRequest::Level iso_level(const std::string& text) {
  if (const auto automatic = auto_level(text)) return {{}, automatic, {}, false, {}};
  return {parse_iso_level(text), {}, {}, false, {}};
}

VolumeRequest::Level label_level(const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  double number = 0;  // one that is not whole is refused rather than taken for a name
  if (is_number(std::string_view(text).substr(0, equals), number))
    return {{}, {}, parse_label_level(text), equals < text.size(), {}};
  // A name: its number is known once the file is.
  VolumeRequest::Level level{{},
                             {},
                             parse_label_level("0=" + (equals < text.size() ? text.substr(equals + 1) : text)),
                             true,
                             text.substr(0, equals)};
  if (level.label_name->empty())
    throw UsageError(fmt::format("\"{}\" is no label", text), "Give --label N or --label N=NAME");
  return level;
}

const std::string& structure_of(const VolumeRequest::Level& level) {
  return level.iso ? level.iso->structure : level.automatic ? level.automatic->structure : level.label->structure;
}

void refuse_two_of_one_name(const std::vector<VolumeRequest::Level>& levels) {
  std::vector<std::string> names;
  for (const VolumeRequest::Level& level : levels) names.push_back(structure_of(level));
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice == names.end()) return;
  throw UsageError(fmt::format("two of --iso and --label make a structure of the same name, {}", *twice),
                   "Name them: --iso 120=dentine --iso 195=enamel");
}

/// "4" pixels of a slice, or "0.5mm2".
void understand_min_area(const std::string& text, VolumeRequest& request) {
  if (text.empty()) return;
  std::string_view number = text;
  for (const std::string_view unit : {"mm2", "mm^2", "mm\xC2\xB2"}) {
    if (!number.ends_with(unit)) continue;
    number.remove_suffix(unit.size());
    request.min_area_in_mm2 = true;
  }
  if (is_number(number, request.min_area) && request.min_area >= 0 && std::isfinite(request.min_area)) return;
  throw UsageError(fmt::format("--min-area {}: that is no area of at least 0", text),
                   "Give a number of pixels, as in --min-area 4, or an area, as in --min-area 0.5mm2");
}

/// The value that a name stands for, in the user's list or the file's.
std::int64_t label_called(const std::string& name, const std::vector<VolumeLabel>& labels, const std::string& file) {
  for (const VolumeLabel& label : labels)
    if (label.name == name) return label.value;
  for (const VolumeLabel& label : labels)
    if (lower_case(label.name) == lower_case(name)) return label.value;
  std::vector<std::string> there;
  for (const VolumeLabel& label : labels) there.push_back(fmt::format("{} ({})", label.name, label.value));
  Place place;
  place.file = file;
  throw InputError("label-not-found", place,
                   labels.empty()
                       ? fmt::format("nothing names its labels, so none is called \"{}\"", name)
                       : fmt::format("no label is called \"{}\"; there are {}", name, fmt::join(there, ", ")),
                   "Give a number (--label N=NAME), or a file of names (--label-names FILE)");
}

/// Numbers for what depended on the volume. The least area depends on the grid, too, which may change yet.
VolumeContourOptions resolved(const VolumeRequest& request, const Volume& volume, const Thresholds& thresholds) {
  VolumeContourOptions options;
  const std::vector<VolumeLabel>& names = request.label_names.empty() ? volume.labels : request.label_names;
  std::vector<VolumeRequest::Level> levels = request.levels;
  for (VolumeRequest::Level& level : levels) {
    if (level.iso) options.isos.push_back(*level.iso);
    if (level.automatic) options.isos.push_back({thresholds.of(*level.automatic), level.automatic->structure});
    if (!level.label) continue;
    if (level.label_name) level.label->label = label_called(*level.label_name, names, volume.source);
    for (const VolumeLabel& name : names)
      if (!level.label_is_named && name.value == level.label->label) level.label->structure = name.name;
    options.labels.push_back(*level.label);
  }
  refuse_two_of_one_name(levels);
  options.smooth = request.smooth;
  if (request.simplify) options.simplify = SimplifyContoursOptions{*request.simplify};
  return options;
}

bool any_automatic(const VolumeRequest& request) {
  return std::any_of(request.levels.begin(), request.levels.end(),
                     [](const auto& level) { return level.automatic.has_value(); });
}

void tell_simplification(std::size_t before, std::size_t after, double largest_deviation, Console& console) {
  console.say(fmt::format("  simplified from {} to {}, which moved contours by at most {} mm", counted(before, "point"),
                          counted(after, "point"), measured(largest_deviation)));
}

}  // namespace

void add_volume_options(CLI::App& parser, VolumeWords& words) {
  const std::string group = "Volumes";
  repeatable(parser.add_option("--iso", words.isos,
                               "Surface at value T or auto, as structure NAME (default: tooth); repeatable"))
      ->type_name("T[=NAME]")
      ->group(group);
  repeatable(parser.add_option("--label", words.labels,
                               "Surface of label N of a label map, or of a named segment; repeatable"))
      ->type_name("N[=NAME]")
      ->group(group);
  parser.add_option("--label-names", words.label_names, "Names of labels, as ITK-SNAP writes them")
      ->type_name("FILE")
      ->group(group);
  parser.add_option("--min-area", words.min_area, "Leave out contours that enclose less: pixels, or mm^2 as in 0.5mm2")
      ->type_name("A")
      ->group(group);
  parser.add_option("--spacing", words.spacing, "Size of a voxel in mm, instead of the file's")
      ->type_name("X,Y,Z")
      ->group(group);
  parser.add_option("--series", words.series, "Of several DICOM series the one to read: number, UID or description")
      ->type_name("N")
      ->group(group);
  parser.add_flag("--allow-outside", words.allow_outside, "Let a header or DICOMDIR name files outside its own folder")
      ->group(group);
  parser.add_option("--smooth", words.smooth, "Smooth the borders of labels, by MM and half a voxel at most")
      ->type_name("MM")
      ->check(at_least_zero())
      ->group(group);
  add_reshape_options(parser, words.reshape);
  parser.add_option("--simplify", words.simplify, "Fewer points: contours may move by up to E mm, and stay disjoint")
      ->type_name("E")
      ->check(at_least_zero());
}

VolumeRequest understood(const VolumeWords& words) {
  VolumeRequest request;
  for (const std::string& text : words.isos) request.levels.push_back(iso_level(text));
  for (const std::string& text : words.labels) request.levels.push_back(label_level(text));
  if (!words.spacing.empty()) request.read.spacing = parse_spacing(words.spacing);
  request.read.series = words.series;
  request.read.allow_outside = words.allow_outside;
  understand_min_area(words.min_area, request);
  if (words.smooth) request.smooth = SmoothLabelsOptions{*words.smooth};
  request.simplify = words.simplify;
  request.reshape = understood(words.reshape);
  refuse_two_of_one_name(request.levels);
  refuse_pipe(words.label_names);
  if (!words.label_names.empty()) request.label_names = read_label_names(words.label_names);
  return request;
}

VolumeContourOptions levels_told(const Volume& volume, const VolumeRequest& request, Session& session) {
  Thresholds thresholds;
  if (any_automatic(request)) thresholds = Thresholds(volume);
  VolumeContourOptions levels = resolved(request, volume, thresholds);
  if (any_automatic(request)) tell_thresholds(thresholds, session.console);
  if (!levels.isos.empty() && looks_like_labels(volume)) tell_label_map(volume, session.console);
  return levels;
}

ContourStack traced_told(const Volume& volume, VolumeContourOptions levels, const VolumeRequest& request,
                         const std::optional<RigidMotion>& upright, Session& session,
                         std::optional<ReportVolume>* facts) {
  levels.trace.min_area = request.min_area * (request.min_area_in_mm2 ? 1 : volume.spacing[0] * volume.spacing[1]);
  VolumeContours found = contours_of_volume(volume, levels, session.progress());
  tell_levels(found.levels, volume, levels, session.console);
  if (found.smoothing_shift) {
    session.console.say(fmt::format("  smoothed, which moved points by at most {} mm and no voxel across a border",
                                    measured(*found.smoothing_shift)));
  }
  if (const auto& simpler = found.simplification) {
    tell_simplification(simpler->points_before, simpler->points_after, simpler->largest_deviation, session.console);
  }
  if (facts) {
    *facts = ReportVolume{{}, volume.remarks, upright, false};
    for (const IsoLevel& level : levels.isos) (*facts)->isos.emplace_back(level.structure, level.threshold);
  }
  return std::move(found.stack);
}

ContourStack contours_told(const std::string& file, const VolumeRequest& request, Session& session, Volume* volume,
                           std::optional<ReportVolume>* facts, Whence* whence) {
  Volume read = read_volume(file, request.read, session.progress());
  tell_volume(file, read, session.console);
  crop_told(read, request.reshape, session.console);
  VolumeContourOptions levels = levels_told(read, request, session);
  const std::optional<RigidMotion> upright = reshape_told(read, request.reshape, levels, session);
  ContourStack stack = traced_told(read, std::move(levels), request, upright, session, facts);
  if (whence) *whence = {read.patient, VoxelGrid{read.size, read.spacing, read.origin}};
  if (volume) *volume = std::move(read);
  return stack;
}

void tell_histogram(const std::string& file, const VolumeRequest& request, Session& session) {
  Volume read = read_volume(file, request.read, session.progress());
  tell_volume(file, read, session.console);
  tell_place(read, session.console);
  crop_told(read, request.reshape, session.console);
  const Thresholds thresholds(read);
  tell_thresholds(thresholds, session.console);
  for (const std::string& line : histogram_lines(thresholds.histogram, thresholds.all_of(4))) session.console.say(line);
  session.console.say(
      "Bars are as long as the root of the number of voxels; marked are the thresholds of four classes.");
  if (looks_like_labels(read)) tell_label_map(read, session.console);
}

ContourStack simplify_told(const ValidStack& stack, const SimplifyContoursOptions& options, Session& session) {
  SimplifiedContours simpler = simplify_contours(stack, options, session.progress());
  tell_simplification(simpler.points_before, simpler.points_after, simpler.largest_deviation, session.console);
  return std::move(simpler.stack);
}

bool looks_like_a_volume(const std::string& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) return true;
  for (const std::string_view ending : {".nrrd", ".nhdr", ".mha", ".mhd", ".nii", ".nii.gz", ".hdr", ".img", ".dcm"}) {
    if (file.ends_with(ending)) return !is_contour_file(file);  // structure sets are DICOM, too
  }
  return begins_like_a_volume(file);
}

ValidStack contours_of_input(const std::string& file, const VolumeWords& words, Session& session,
                             std::optional<ReportVolume>* facts, Whence* whence) {
  if (words.any_level())
    return validate(contours_told(file, understood(words), session, nullptr, facts, whence), session.progress());
  const bool of_another_program = is_contour_file(file);
  if (!of_another_program && needs_conversion(file, {})) {
    throw UsageError(fmt::format("{} is a mesh, and contours are wanted here", file),
                     fmt::format("Cut it first: odontoscope contours {} --spacing-z D -o FILE.json", file));
  }
  const ValidStack stack = of_another_program ? converted_told(file, {}, session, whence)
                                              : validate(read_stack(file, session.progress().stop), session.progress());
  if (!words.simplify) return stack;
  return validate(simplify_told(stack, {*words.simplify}, session), session.progress());
}

void refuse_volume_without_level(const std::string& file, const VolumeWords& words) {
  if (words.smooth && words.labels.empty()) {
    throw UsageError("--smooth is about label maps",
                     "Add --label N, or leave it out: --iso lies between voxels already");
  }
  if (words.any_level()) return;
  const bool any_other = !words.min_area.empty() || !words.spacing.empty() || !words.series.empty() ||
                         !words.label_names.empty() || words.allow_outside;
  if (any_other || words.reshape.any()) {
    throw UsageError(
        "--min-area, --spacing, --series, --label-names, --allow-outside, --crop, --resample and --upright are about "
        "volumes, "
        "and nothing says where in a volume the surface lies",
        "Give --iso T (or --iso auto) for an image, --label N for a label map");
  }
  if (looks_like_a_volume(file)) {
    throw UsageError(fmt::format("{} looks like a volume, and nothing says where in it the surface lies", file),
                     "Give --iso T (or --iso auto) for an image, --label N for a label map");
  }
}

}  // namespace odontoscope::app
