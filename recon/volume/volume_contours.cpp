#include "recon/volume/volume_contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/volume/lattice.h"
#include "recon/volume/read_volume.h"

namespace odontoscope {
namespace {

/// The whole of `text` as a number, or nothing.
template <class Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

struct NamedNumber {
  std::string_view number;
  std::optional<std::string> name;
};

NamedNumber split(std::string_view text) {
  const std::size_t at = text.find('=');
  if (at == std::string_view::npos) return {text, std::nullopt};
  return {text.substr(0, at), std::string(text.substr(at + 1))};
}

void check_name(const std::string& name, std::string_view whole) {
  const bool control = std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == 127; });
  if (!name.empty() && name.size() <= limits::name_length && !control) return;
  throw UsageError(fmt::format("\"{}\" gives a structure no usable name", whole.substr(0, limits::quoted_length)),
                   fmt::format("give 1 to {} printable characters after the =", limits::name_length));
}

}  // namespace

IsoLevel parse_iso_level(std::string_view text) {
  const NamedNumber parts = split(text);
  const std::optional<double> threshold = number<double>(parts.number);
  if (!threshold || !std::isfinite(*threshold)) {
    throw UsageError(fmt::format("\"{}\" is no iso value", text.substr(0, limits::quoted_length)),
                     "give --iso T or --iso T=NAME, T a number");
  }
  IsoLevel level{*threshold};
  if (parts.name) level.structure = *parts.name;
  check_name(level.structure, text);
  return level;
}

LabelLevel parse_label_level(std::string_view text) {
  const NamedNumber parts = split(text);
  const std::optional<std::int64_t> label = number<std::int64_t>(parts.number);
  if (!label) {
    throw UsageError(fmt::format("\"{}\" is no label", text.substr(0, limits::quoted_length)),
                     "give --label N or --label N=NAME, N a whole number");
  }
  LabelLevel level{*label, parts.name.value_or(fmt::format("label-{}", *label))};
  check_name(level.structure, text);
  return level;
}

std::array<double, 3> parse_spacing(std::string_view text) {
  std::array<double, 3> spacing{};
  std::string_view rest = text;
  bool good = std::count(text.begin(), text.end(), ',') == 2;
  for (std::size_t n = 0; good && n < 3; ++n) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::optional<double> value = number<double>(rest.substr(0, comma));
    good = value && std::isfinite(*value) && *value > 0;
    if (good) spacing[n] = *value;
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  if (good) return spacing;
  throw UsageError(fmt::format("\"{}\" is no spacing", text.substr(0, limits::quoted_length)),
                   "give three positive numbers in millimetres, as in --spacing 0.12,0.12,0.5");
}

VolumeContours contours_from_volume(const std::string& path, const VolumeContourOptions& options,
                                    const Progress& progress) {
  return contours_of_volume(read_volume(path, {options.spacing}, progress), options, progress);
}

VolumeContours contours_of_volume(const Volume& volume, const VolumeContourOptions& options, const Progress& progress) {
  const ValueRange range = validate_volume(volume);
  std::vector<LevelTracer> tracers = iso_tracers(volume, range, options.isos);
  std::shared_ptr<const SmoothLabels> smooth;
  if (options.smooth && !options.labels.empty()) smooth = smoothed(volume, options.labels, *options.smooth, progress);
  std::vector<LevelTracer> label_ones = label_tracers(volume, options.labels, smooth);
  std::move(label_ones.begin(), label_ones.end(), std::back_inserter(tracers));
  TracedContours traced = trace_levels(volume, tracers, options.trace, progress);

  VolumeContours result;
  const Lattice lattice(volume);
  result.volume = {volume.size,         volume.spacing, volume.origin,          range,
                   volume.tilt_degrees, lattice.step(), lattice.largest_shift()};
  if (smooth) result.smoothing_shift = smooth->largest_shift();
  result.levels = std::move(traced.levels);
  result.stack = std::move(traced.stack);
  if (options.simplify) {
    SimplifiedContours simple = simplify_contours(result.stack, *options.simplify, progress);
    result.simplification = {simple.points_before, simple.points_after, simple.largest_deviation};
    result.stack = std::move(simple.stack);
  }
  return result;
}

}  // namespace odontoscope
