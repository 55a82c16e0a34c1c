#include "engine/app/volume_look_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "engine/app/words.h"
#include "engine/scene/scene_json.h"
#include "recon/radiograph/tissue.h"

namespace odontoscope::app {
namespace {

constexpr const char* group = "A volume's grey values";

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::optional<ValueWindow> window(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == text.npos) return std::nullopt;
  const auto low = number(text.substr(0, comma)), high = number(text.substr(comma + 1));
  if (!low || !high || !ValueWindow{*low, *high}.sensible()) return std::nullopt;
  return ValueWindow{*low, *high};
}

struct Cast {
  VolumeLook::Cast cast = VolumeLook::Cast::shaded;
  std::optional<ValueWindow> window;
  std::optional<double> iso;
};

/// "shaded", "maximum", "maximum=LOW,HIGH", "surface=T", ...
Cast cast_from(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t sign = std::min(text.find('='), text.size());
  Cast cast{cast_named(text.substr(0, sign)), {}, {}};
  const std::string value = sign < text.size() ? text.substr(sign + 1) : std::string();
  const bool windowed = cast.cast == VolumeLook::Cast::maximum || cast.cast == VolumeLook::Cast::average;
  if (windowed && sign < text.size()) {
    cast.window = window(value);
    if (!cast.window)
      throw UsageError(fmt::format("--cast {}: that is no range of values", text),
                       "Give the value that is black, then a higher one that is white: maximum=60,220");
  } else if (cast.cast == VolumeLook::Cast::surface) {
    cast.iso = number(value);
    if (!cast.iso) throw UsageError(fmt::format("--cast {}: say at which value", text), "For example surface=120");
  } else if (sign < text.size()) {
    throw UsageError(fmt::format("--cast {}: only maximum, average and surface take values", text));
  }
  return cast;
}

/// "VALUE:#RRGGBB:EXTINCTION,..."; nothing for a preset's name.
std::optional<std::vector<TransferPoint>> points_from(const std::string& text) {
  if (text.find(':') == std::string::npos) return std::nullopt;
  std::vector<TransferPoint> points;
  for (std::size_t from = 0; from <= text.size();) {
    const std::string_view one = std::string_view(text).substr(from, text.find(',', from) - from);
    from += one.size() + 1;
    const std::size_t first = one.find(':'), second = one.find(':', std::min(first, one.size() - 1) + 1);
    const auto value = first == one.npos ? std::nullopt : number(one.substr(0, first));
    const auto extinction = second == one.npos ? std::nullopt : number(one.substr(second + 1));
    if (!value || !extinction)
      throw UsageError(fmt::format("--transfer: \"{}\" is no value with its colour and extinction", one),
                       "For example 90:#e8b56a:0,120:#e8b56a:2,200:#ffffff:20");
    points.push_back({*value, colour_from_hex(one.substr(first + 1, second - first - 1)), *extinction});
  }
  if (!sensible(points))
    throw UsageError(
        "--transfer: that is no transfer function",
        fmt::format("Values must ascend, extinctions (1/mm) lie between 0 and {:g}, and there may be {} of them.",
                    most_extinction, most_transfer_points));
  return points;
}

Slopes slopes_from(const std::string& text) {
  if (text.empty()) return {};
  const auto both = window(text);
  const Slopes slopes = both ? Slopes{both->low, both->high} : Slopes{0, 0};
  if (!slopes.count() || !slopes.sensible())
    throw UsageError(
        fmt::format("--slopes {}: those are no two slopes", text),
        "Give what is too flat to be seen, then what is steep enough, in values a millimetre: --slopes 100,400");
  return slopes;
}

void lay_out(const VolumeLookRequest& request, const GreyAnchors& greys, const ValueGrid& values, VolumeLook& look) {
  const VolumeLookWords& words = request.words;
  if (!words.cast.empty()) {
    const Cast cast = cast_from(words.cast);
    look.cast = cast.cast;
    look.iso = cast.iso.value_or(look.iso);
    if (look.cast == VolumeLook::Cast::maximum || look.cast == VolumeLook::Cast::average) {
      const ValueWindow shown = cast.window.value_or(
          values.usual.high > greys.air ? ValueWindow{greys.air, values.usual.high} : values.usual);
      look.black = shown.low;
      look.white = shown.high;
    } else if (look.cast == VolumeLook::Cast::radiograph) {
      look.black = greys.air;
      look.white = greys.dentine;
      look.attenuation = linear_attenuation(*tissue_called("dentine"), effective_energy_kev(request.kv));
    }
  }
  if (!words.slopes.empty()) {
    if (look.cast != VolumeLook::Cast::shaded)
      throw UsageError("--slopes is about a shaded volume", "Leave --cast out, or --slopes.");
    look.slopes = slopes_from(words.slopes);
  }
  if (!words.transfer.empty() || look.transfer.empty()) {
    const auto points = points_from(words.transfer);
    look.transfer = points
                        ? *points
                        : transfer_of(words.transfer.empty() ? TransferPreset::tooth : transfer_named(words.transfer),
                                      greys.air, greys.dentine);
  }
}

void clear_around(const std::vector<std::string>& told, Scene& scene) {
  for (Look& look : scene.looks) {
    const bool own = std::any_of(told.begin(), told.end(),
                                 [&](const std::string& text) { return text.starts_with(look.structure + "="); });
    if (!own && !look.as_body) look.opacity = std::min(look.opacity, around_volume);
  }
}

}  // namespace

void add_volume_look_options(CLI::App& parser, VolumeLookWords& words) {
  parser.add_option("--show", words.show, "surfaces (default), volume (needs no --iso), or both")
      ->type_name("WHAT")
      ->group(group);
  parser.add_option("--cast", words.cast, "shaded (default), maximum, average[=BLACK,WHITE], radiograph, surface=T")
      ->type_name("HOW")
      ->group(group);
  parser
      .add_option("--transfer", words.transfer, "tooth (default), enamel, dentine, pulp, soft, or V:#RRGGBB:1/MM,...")
      ->type_name("WHAT")
      ->group(group);
  parser.add_option("--slopes", words.slopes, "Show borders: nothing flatter than FLAT values/mm, all of STEEP ones")
      ->type_name("FLAT,STEEP")
      ->group(group);
}

void add_grey_option(CLI::App& parser, std::string& grey) {
  parser.add_option("--grey", grey, "Values of air and dentine in a volume (default: by its histogram)")
      ->type_name("AIR,DENTINE")
      ->group(group);
}

std::optional<GreyAnchors> greys_from(const std::string& text) {
  if (text.empty()) return std::nullopt;
  if (const auto both = window(text)) return GreyAnchors{both->low, both->high};
  throw UsageError(fmt::format("--grey {}: those are no two values", text),
                   "Give the value of air, then the higher one of dentine: --grey 20,150");
}

void refuse_senseless(const VolumeLookWords& words) {
  if (!words.show.empty()) shows_named(words.show);
  VolumeLook look;
  look.cast = cast_from(words.cast).cast;
  if (!points_from(words.transfer) && !words.transfer.empty()) transfer_named(words.transfer);
  if (slopes_from(words.slopes).count() && look.cast != VolumeLook::Cast::shaded)
    throw UsageError("--slopes is about a shaded volume", "Leave --cast out, or --slopes.");
  if (words.any_of_volume() && words.show == "surfaces")
    throw UsageError("--cast, --transfer and --slopes are about a volume's grey values",
                     "Show them: --show volume, or --show both.");
  if (words.show == "both" && look.projects())
    throw UsageError(
        fmt::format("--cast {}: greys along the whole ray have no depth, and show nothing else", words.cast),
        "Choose --show volume.");
}

bool wants_voxels(const VolumeLookWords& words, const std::string& scene_file) {
  if (!words.show.empty()) return shows_named(words.show) != VolumeLook::Shows::surfaces;
  return !scene_file.empty() && read_scene(scene_file, Scene{}).volume.shows_volume();
}

void show_volume(const VolumeLookRequest& request, const Shown& shown, Scene& scene, Session& session) {
  VolumeLook& look = scene.volume;
  const VolumeLookWords& words = request.words;
  if (!words.show.empty()) look.shows = shows_named(words.show);
  if (!look.shows_volume()) {
    if (words.any_of_volume())
      throw UsageError("--cast, --transfer and --slopes are about a volume's grey values",
                       "Show them: --show volume, or --show both.");
    return;
  }
  if (!shown.values || !shown.greys)
    throw UsageError(
        "only a volume has grey values to show",
        "Give the volume that the model was made from, with --show volume, or with --iso and --show both.");
  if (look.shows == VolumeLook::Shows::both && shown.only_voxels)
    throw UsageError("--show both: nothing says where in the volume the surface lies",
                     "Give --iso T (or --iso auto) for an image, or --show volume.");
  const auto told = greys_from(request.grey);
  const GreyAnchors greys = told.value_or(*shown.greys);
  lay_out(request, greys, *shown.values, look);
  if (look.shows == VolumeLook::Shows::both) clear_around(request.opacities, scene);
  if (look.projects() && !request.background_told) scene.background = {Background::Kind::plain, {0, 0, 0}, {0, 0, 0}};
  const ValueGrid& grid = *shown.values;
  session.console.say(fmt::format(
      "The volume is shown by {} x {} x {} values ({:.0f} MB); {:.6g} is taken as air and {:.6g} as dentine{}",
      grid.size[0], grid.size[1], grid.size[2],
      std::ceil(static_cast<double>(grid.values.size() * sizeof(float)) / 1e6), greys.air, greys.dentine,
      told ? "" : " (the middle of either side of Otsu's threshold; --grey says otherwise)"));
  if (grid.merged != std::array<std::size_t, 3>{1, 1, 1})
    session.console.say(fmt::format("  each value is the mean of {} x {} x {} voxels, to bound its memory",
                                    grid.merged[0], grid.merged[1], grid.merged[2]));
}

}  // namespace odontoscope::app
