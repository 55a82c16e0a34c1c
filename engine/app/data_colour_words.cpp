#include "engine/app/data_colour_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/picture/lettering.h"
#include "engine/scene/wall_colours.h"
#include "engine/ui/fonts.h"
#include "recon/formats/shell_groups.h"

namespace odontoscope::app {
namespace {

struct ColourBy {
  DataColours::Of of = DataColours::Of::distance;
  std::optional<double> reach;
};

ColourBy understood_colour_by(const std::string& words) {
  const std::size_t sign = std::min(words.find('='), words.size());
  ColourBy by{data_colours_named(words.substr(0, sign)), {}};
  if (sign == words.size()) return by;
  double reach = 0;
  const char *from = words.data() + sign + 1, *const end = words.data() + words.size();
  const auto [behind, error] = std::from_chars(from, end, reach);
  if (error != std::errc() || behind != end || !std::isfinite(reach) || !(reach > 0))
    throw UsageError(fmt::format("--colour-by {}: that is no number above 0", words),
                     "Say where colours end: distance=0.2 (mm), slope=300 (values a millimetre).");
  by.reach = reach;
  return by;
}

void tell(const DeviationSummary& found, Console& console) {
  console.say(
      fmt::format("The surface lies {:.3g} mm from where the CT's values cross its own (median); 95 % within {:.3g} "
                  "mm, the farthest {:.3g} mm at ({:.3f}, {:.3f}, {:.3f}).",
                  found.median_mm, found.nineteen_of_twenty_mm, found.most_mm, found.most_at_mm.x, found.most_at_mm.y,
                  found.most_at_mm.z));
  if (found.without > 0)
    console.say(fmt::format("  {} of {} points have no such place within {:g} voxels", found.without,
                            found.positions + found.without, deviation_reach_steps));
  console.say(fmt::format("  There the CT's values rise by {:.4g} a millimetre (median).", found.usual_slope));
}

std::array<std::uint8_t, 3> colour_at(const DataColours& colours, double part) {
  const auto [low, middle, high] = stops_of(colours.of);
  const double place = 2 * part - 1;
  const glm::vec3 light = glm::mix(linear(middle), linear(place < 0 ? low : high), static_cast<float>(std::abs(place)));
  std::array<std::uint8_t, 3> shown{};
  for (int channel = 0; channel < 3; ++channel) {
    const double encoded = screen_value(static_cast<double>(light[channel]));
    shown[static_cast<std::size_t>(channel)] =
        static_cast<std::uint8_t>(std::lround(255 * std::clamp(encoded, 0.0, 1.0)));
  }
  return shown;
}

void fill(Image& image, int left, int top, int right, int bottom, const std::array<std::uint8_t, 3>& colour) {
  for (int y = std::max(top, 0); y < std::min(bottom, image.height); ++y)
    for (int x = std::max(left, 0); x < std::min(right, image.width); ++x)
      image.set_pixel(x, y, {colour[0], colour[1], colour[2], 255});
}

/// Under a legend's bar: `part` of the way from left to right.
struct LegendNumber {
  double part;
  std::string words;
};

/// At the lower left, on paper of its own.
template <class BarOf>
void draw_bar(const std::string& title, const std::vector<LegendNumber>& numbers, BarOf bar_of, Image& image) {
  constexpr ShownColour behind{255, 255, 255}, ink{30, 34, 40};
  const int letters = std::max(10, image.height / 36), gap = std::max(2, letters / 3),
            bar = std::min(std::max(160, image.width / 3), image.width - 6 * gap), tall = std::max(6, letters * 2 / 3);
  const Lettering lettering(regular_font(), letters);
  const int left = 2 * gap, bottom = image.height - 2 * gap, top = bottom - 2 * letters - tall - 4 * gap;
  fill(image, left - gap, top, left + bar + gap, bottom, behind);
  lettering.draw(image, title, left, top + gap, ink);
  const int bar_top = top + 2 * gap + letters;
  const std::vector<ShownColour> colours = bar_of(bar);
  for (int x = 0; x < bar; ++x)
    fill(image, left + x, bar_top, left + x + 1, bar_top + tall, colours[static_cast<std::size_t>(x)]);
  for (const auto& [part, words] : numbers) {
    const double wide = lettering.width(words), middle = left + part * bar;
    lettering.draw(image, words, std::clamp(middle - 0.5 * wide, static_cast<double>(left), left + bar - wide),
                   bar_top + tall + gap, ink);
  }
}

}  // namespace

void add_colour_by_option(CLI::App& parser, std::string& words) {
  parser.add_option("--colour-by", words, "Surfaces by distance[=MM] from the CT's own, or its slope[=VALUES/MM]")
      ->type_name("WHAT")
      ->group("A volume's grey values");
}

void refuse_senseless_colour_by(const std::string& words) {
  if (!words.empty()) understood_colour_by(words);
}

void colour_by_data(const std::string& words, const std::vector<std::string>& opacities, Shown& shown, Scene& scene,
                    Session& session) {
  if (words.empty() && !scene.data_colours) return;
  if (!shown.values || shown.isos.empty())
    throw UsageError("--colour-by: there is no value of a CT at which the surface was taken",
                     "Give the CT itself, with --iso T.");
  const ColourBy by =
      words.empty() ? ColourBy{scene.data_colours->of, scene.data_colours->reach} : understood_colour_by(words);
  mark_deviations(shown.model, *shown.values, shown.isos);
  const auto found = deviations_in(shown.model);
  if (!found)
    throw UsageError("--colour-by: none of the structures shown was taken from the CT at a value",
                     "Give the CT itself, with --iso T.");
  scene.data_colours = DataColours{by.of, by.reach.value_or(usual_data_colours(by.of, *found, *shown.values).reach)};
  if (!words.empty())
    for (Look& look : scene.looks) {
      const bool told = std::any_of(opacities.begin(), opacities.end(),
                                    [&](const std::string& text) { return text.starts_with(look.structure + "="); });
      if (!told) look.opacity = 1;
    }
  tell(*found, session.console);
}

void draw_legend(const DataColours& colours, Image& image) {
  const bool distance = colours.of == DataColours::Of::distance;
  const std::string title = distance ? "From the CT's surface, mm" : "Slope of the CT, values/mm";
  const std::vector<LegendNumber> numbers =
      distance
          ? std::vector<LegendNumber>{{0, fmt::format("\u2212{:.3g}", colours.reach)},
                                      {0.5, "0"},
                                      {1, fmt::format("+{:.3g}", colours.reach)}}
          : std::vector<LegendNumber>{
                {0, "0"}, {0.5, fmt::format("{:.3g}", 0.5 * colours.reach)}, {1, fmt::format("{:.3g}", colours.reach)}};
  draw_bar(
      title, numbers,
      [&](int width) {
        std::vector<ShownColour> bar;
        for (int x = 0; x < width; ++x) bar.push_back(colour_at(colours, (x + 0.5) / width));
        return bar;
      },
      image);
}

void draw_thickness_legend(const Colour& own, const odontoscope::Model& model, Image& image) {
  const auto [bold, twice, thickest] = thickness_marks_mm(model);
  std::vector<LegendNumber> numbers;
  for (const double mm : {0.0, bold, twice, thickest}) numbers.push_back({mm / thickest, fmt::format("{:g}", mm)});
  draw_bar(
      "Thickness of the wall, mm", numbers, [&](int width) { return thickness_bar(own, width); }, image);
}

}  // namespace odontoscope::app
