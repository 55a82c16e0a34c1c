#include "engine/viewer/volume/volume_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/volume/film_panel.h"
#include "engine/viewer/volume/transfer_editor.h"

namespace odontoscope {
namespace {

using widgets::scaled;

void lay_out_transfer(const VolumeLayout& layout, ViewerState& state) {
  state.scene.volume.transfer =
      layout.edited.empty() ? transfer_of(layout.preset, layout.air, layout.dentine) : layout.edited;
  for (TransferPoint& point : state.scene.volume.transfer) point.extinction *= layout.density;
}

/// What a way to cast begins with.
void begin_cast(VolumeLook::Cast cast, const VolumeLayout& layout, ViewerState& state) {
  VolumeLook& look = state.scene.volume;
  look.cast = cast;
  if (!look.projects()) return;
  look.shows = VolumeLook::Shows::volume;  // greys along the whole ray have no depth
  const double brightest = state.shown->values->usual.high;
  look.black = layout.air;
  look.white = cast == VolumeLook::Cast::radiograph || brightest <= layout.air ? layout.dentine : brightest;
  look.attenuation = state.shown->greys->dentine_attenuation;
}

void choose_what_is_shown(VolumeLayout& layout, ViewerState& state) {
  VolumeLook& look = state.scene.volume;
  int shows = static_cast<int>(look.shows);
  if (!widgets::choice("volume shows", shows, {"Surfaces", "Volume", "Both"})) return;
  show_as(static_cast<VolumeLook::Shows>(shows), state.scene);
  if (look.transfer.empty()) {
    layout.air = state.shown->greys->air;
    layout.dentine = state.shown->greys->dentine;
    lay_out_transfer(layout, state);
  }
}

/// Two values of which the first stays below the other. true: one was moved.
bool two_values(const char* low_words, double& low, const char* high_words, double& high, const ValueWindow& range) {
  const double least = 0.001 * (range.high - range.low);
  const bool low_moved = widgets::slider(low_words, low, range.low, range.high, "%.5g"),
             high_moved = widgets::slider(high_words, high, range.low, range.high, "%.5g");
  if (low_moved)
    high = std::max(high, low + least);
  else if (high_moved)
    low = std::min(low, high - least);
  return low_moved || high_moved;
}

/// Opacity by slope: borders are seen, and what lies between them is clear.
void slope_controls(ViewerState& state) {
  Slopes& slopes = state.scene.volume.slopes;
  const ValueGrid& values = *state.shown->values;
  const double steepest =
      (values.usual.high - values.usual.low) / std::min({values.step_mm.x, values.step_mm.y, values.step_mm.z});
  bool only_borders = slopes.count();
  if (widgets::toggle("Borders only", only_borders))
    slopes = only_borders ? Slopes{0.05 * steepest, 0.2 * steepest} : Slopes{};
  if (slopes.count())
    two_values("Too flat, values/mm", slopes.flat, "Steep enough, values/mm", slopes.steep,
               {0, std::max(steepest, slopes.steep)});
}

void transfer_controls(VolumeLayout& layout, ViewerState& state, const Interface& interface) {
  std::vector<TransferPoint>& transfer = state.scene.volume.transfer;
  int preset = layout.edited.empty() ? static_cast<int>(layout.preset) : -1;
  bool changed = widgets::choice("transfer", preset, {"Tooth", "Enamel", "Dentine", "Pulp", "Soft"});
  if (changed) {
    layout.preset = static_cast<TransferPreset>(preset);
    layout.edited.clear();
    lay_out_transfer(layout, state);
  }
  if (transfer.size() >= 2 && transfer_editor(*state.shown->greys, transfer, layout.chosen, interface, scaled(84))) {
    layout.edited = transfer;
    for (TransferPoint& point : layout.edited) point.extinction /= layout.density;
  }
  widgets::remark(interface, state.shown->greys->isos.empty()
                                 ? "Drag points; a click makes one, the right button takes one away."
                                 : "Drag points; a click makes one, the right button takes one away. The lines are "
                                   "where the surfaces were taken.");
  double density = 100 * layout.density;
  if (widgets::slider("Density", density, 5, 400, "%.0f %%")) {
    layout.density = density / 100;
    lay_out_transfer(layout, state);
  }
  slope_controls(state);
  if (layout.edited.empty() && two_values("Air", layout.air, "Dentine", layout.dentine, state.shown->values->range))
    lay_out_transfer(layout, state);
}

/// The legend's bar, its numbers below.
void data_legend(const DataColours& colours, const Interface& interface) {
  const auto stops = stops_of(colours.of);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = scaled(10);
  const auto light = [&](float part) {
    return part < 0 ? glm::mix(linear(stops[1]), linear(stops[0]), -part)
                    : glm::mix(linear(stops[1]), linear(stops[2]), part);
  };
  const auto channel = [](float part) {
    return static_cast<int>(255 * std::pow(std::clamp(part, 0.0f, 1.0f), 1 / 2.2f));
  };
  constexpr int pieces = 48;
  for (int i = 0; i < pieces; ++i) {
    const glm::vec3 colour = light(2 * (static_cast<float>(i) + 0.5f) / pieces - 1);
    ImGui::GetWindowDrawList()->AddRectFilled(
        {corner.x + width * static_cast<float>(i) / pieces, corner.y},
        {corner.x + width * static_cast<float>(i + 1) / pieces, corner.y + height},
        IM_COL32(channel(colour.r), channel(colour.g), channel(colour.b), 255));
  }
  ImGui::Dummy({width, height});
  if (colours.of == DataColours::Of::distance)
    widgets::remark(
        interface,
        fmt::format("−{0:.3g} mm (blue: the CT reaches beyond the model) to +{0:.3g} mm (red: the model beyond the CT)",
                    colours.reach));
  else
    widgets::remark(interface, fmt::format("0 to {:.3g} grey values a millimetre", colours.reach));
}

/// Model against data: distances and slopes on the surfaces.
void data_colours(VolumeAsked& asked, ViewerState& state, const Interface& interface) {
  if (!state.shown->deviations && state.shown->isos.empty()) return;
  std::optional<DataColours>& colours = state.scene.data_colours;
  const auto shown = colours ? std::optional(colours->of) : asked.data_colours;
  int chosen = !shown ? 0 : *shown == DataColours::Of::distance ? 1 : 2;
  widgets::remark(interface, "Surfaces against the CT");
  if (widgets::choice("data colours", chosen, {"Own colours", "Distance", "Slope"})) {
    colours.reset();
    asked.data_colours.reset();
    if (chosen > 0) {
      const auto of = chosen == 1 ? DataColours::Of::distance : DataColours::Of::slope;
      if (state.shown->deviations)
        colours = usual_data_colours(of, *state.shown->deviations, *state.shown->values);
      else
        asked.data_colours = of;
      for (Look& structure : state.scene.looks)
        if (!structure.as_body && state.scene.volume.shows != VolumeLook::Shows::both)
          structure.opacity = 1;  // colours are to be told apart
    }
  }
  if (asked.data_colours) widgets::remark(interface, "Comparing with the CT\xE2\x80\xA6");
  if (!colours || !state.shown->deviations) return;
  const DeviationSummary& found = *state.shown->deviations;
  const bool distance = colours->of == DataColours::Of::distance;
  const double most = distance ? std::max(found.most_mm, colours->reach) : 4 * std::max(found.steep_slope, 1e-9);
  widgets::slider(distance ? "Colours reach to, mm" : "Colours reach to, values/mm", colours->reach, most / 200, most,
                  "%.3g");
  data_legend(*colours, interface);
  if (distance)
    widgets::remark(interface, fmt::format("Median {:.3g} mm, 95 % within {:.3g} mm, the farthest {:.3g} mm.",
                                           found.median_mm, found.nineteen_of_twenty_mm, found.most_mm));
}

/// From the surfaces alone (0) to the volume alone (1).
void slide_between(VolumeLayout& layout, ViewerState& state) {
  VolumeLook& look = state.scene.volume;
  if (look.shows != VolumeLook::Shows::both || look.cast != VolumeLook::Cast::shaded) return;
  double& data = layout.data;
  if (!widgets::slider("Model to data", data, 0, 1, "%.2f")) return;
  for (Look& structure : state.scene.looks)
    if (!structure.as_body) structure.opacity = static_cast<float>(1 - data);
  layout.density = std::max(data, 0.05);
  lay_out_transfer(layout, state);
}

}  // namespace

void volume_section(VolumeLayout& layout, VolumeAsked& asked, ViewerState& state, const Interface& interface) {
  if (!state.shown || !state.shown->values || !state.shown->greys) return;
  if (!widgets::section(interface, "Volume")) return;
  data_colours(asked, state, interface);
  choose_what_is_shown(layout, state);
  slide_between(layout, state);
  VolumeLook& look = state.scene.volume;
  if (!look.shows_volume()) return;
  constexpr std::array casts{VolumeLook::Cast::shaded, VolumeLook::Cast::maximum, VolumeLook::Cast::average,
                             VolumeLook::Cast::radiograph};
  int cast = static_cast<int>(std::find(casts.begin(), casts.end(), look.cast) - casts.begin());
  if (widgets::choice("cast", cast, {"Shaded", "Maximum", "Average", "X-ray"}))
    begin_cast(casts[static_cast<std::size_t>(cast)], layout, state);
  if (look.cast == VolumeLook::Cast::shaded) return transfer_controls(layout, state, interface);
  if (look.cast == VolumeLook::Cast::radiograph) {
    widgets::slider("White at attenuation", look.latitude, 0.5, 10, "%.1f");
    two_values("Air", look.black, "Dentine", look.white, state.shown->values->range);
    film_controls(asked, state, interface);
    return;
  }
  if (look.projects()) two_values("Black", look.black, "White", look.white, state.shown->values->range);
}

}  // namespace odontoscope
