#include "engine/ui/volume_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"

namespace odontoscope {
namespace {

using widgets::scaled;

/// How clear structures become around a volume.
constexpr float around_volume = 0.15f;
/// Extinction of a millimetre that fills a bar of the histogram.
constexpr double full_extinction = 4;

void lay_out_transfer(ViewerState& state) {
  const VolumeLayout& layout = state.volume_layout;
  state.scene.volume.transfer = transfer_of(layout.preset, layout.air, layout.dentine);
  for (TransferPoint& point : state.scene.volume.transfer) point.extinction *= layout.density;
}

/// What a way to cast begins with.
void begin_cast(VolumeLook::Cast cast, ViewerState& state) {
  VolumeLook& look = state.scene.volume;
  const VolumeLayout& layout = state.volume_layout;
  look.cast = cast;
  if (!look.projects()) return;
  look.shows = VolumeLook::Shows::volume;   // greys along the whole ray have no depth
  const double brightest = state.shown->values->usual.high;
  look.black = layout.air;
  look.white = cast == VolumeLook::Cast::radiograph || brightest <= layout.air ? layout.dentine : brightest;
  look.attenuation = state.shown->greys->dentine_attenuation;
}

void choose_what_is_shown(ViewerState& state) {
  VolumeLook& look = state.scene.volume;
  int shows = static_cast<int>(look.shows);
  if (!widgets::choice("volume shows", shows, {"Surfaces", "Volume", "Both"})) return;
  look.shows = static_cast<VolumeLook::Shows>(shows);
  if (look.transfer.empty()) {
    state.volume_layout.air = state.shown->greys->air;
    state.volume_layout.dentine = state.shown->greys->dentine;
    lay_out_transfer(state);
  }
  if (look.shows != VolumeLook::Shows::both) return;
  if (look.projects()) look.cast = VolumeLook::Cast::shaded;
  for (Look& structure : state.scene.looks)
    if (!structure.as_body) structure.opacity = std::min(structure.opacity, around_volume);
}

/// Bars in the colours that their values are shown in; lines where the surfaces were taken.
void histogram(const ViewerState& state, float height) {
  const GreyValues& greys = *state.shown->greys;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, theme::raised, scaled(4));
  const double span = std::max(greys.high - greys.low, 1e-30);
  const float bar = width / static_cast<float>(std::max<std::size_t>(greys.bars.size(), 1));
  for (std::size_t i = 0; i < greys.bars.size(); ++i) {
    const double value = greys.low + span * (static_cast<double>(i) + 0.5) / static_cast<double>(greys.bars.size());
    const float left = corner.x + static_cast<float>(i) * bar, right = left + std::max(bar - scaled(0.5f), 1.0f), bottom = corner.y + height;
    list.AddRectFilled({left, bottom - greys.bars[i] * (height - scaled(6))}, {right, bottom}, theme::quiet);
    const glm::vec4 seen = transferred(state.scene.volume.transfer, value);
    const auto share = static_cast<float>(std::min(static_cast<double>(seen.a) / full_extinction, 1.0));
    if (share <= 0) continue;
    const auto channel = [](float light) { return static_cast<int>(255 * std::pow(std::clamp(light, 0.0f, 1.0f), 1 / 2.2f)); };
    list.AddRectFilled({left, bottom - share * height}, {right, bottom}, IM_COL32(channel(seen.r), channel(seen.g), channel(seen.b), 150));
  }
  for (const double iso : greys.isos) {
    const float x = corner.x + static_cast<float>(std::clamp((iso - greys.low) / span, 0.0, 1.0)) * width;
    list.AddLine({x, corner.y}, {x, corner.y + height}, theme::accent, scaled(2));
  }
  ImGui::Dummy({width, height});
}

/// Two values of which the first stays below the other. true: one was moved.
bool two_values(const char* low_words, double& low, const char* high_words, double& high, const ValueWindow& range) {
  const double least = 0.001 * (range.high - range.low);
  const bool low_moved = widgets::slider(low_words, low, range.low, range.high, "%.5g"), high_moved = widgets::slider(high_words, high, range.low, range.high, "%.5g");
  if (low_moved) high = std::max(high, low + least);
  else if (high_moved) low = std::min(low, high - least);
  return low_moved || high_moved;
}

void transfer_controls(ViewerState& state, const Interface& interface) {
  VolumeLayout& layout = state.volume_layout;
  int preset = static_cast<int>(layout.preset);
  bool changed = widgets::choice("transfer", preset, {"Tooth", "Enamel", "Dentine", "Pulp", "Soft"});
  layout.preset = static_cast<TransferPreset>(preset);
  histogram(state, scaled(72));
  if (!state.shown->greys->isos.empty()) widgets::remark(interface, "The lines are where the surfaces were taken.");
  double density = 100 * layout.density;
  if (widgets::slider("Density", density, 5, 400, "%.0f %%")) {
    layout.density = density / 100;
    changed = true;
  }
  changed = two_values("Air", layout.air, "Dentine", layout.dentine, state.shown->values->range) || changed;
  if (changed) lay_out_transfer(state);
}

}  // namespace

void volume_section(ViewerState& state, const Interface& interface) {
  if (!state.shown || !state.shown->values || !state.shown->greys) return;
  if (!widgets::section(interface, "Volume")) return;
  choose_what_is_shown(state);
  VolumeLook& look = state.scene.volume;
  if (!look.shows_volume()) return;
  constexpr std::array casts{VolumeLook::Cast::shaded, VolumeLook::Cast::maximum, VolumeLook::Cast::average, VolumeLook::Cast::radiograph};
  int cast = static_cast<int>(std::find(casts.begin(), casts.end(), look.cast) - casts.begin());
  if (widgets::choice("cast", cast, {"Shaded", "Maximum", "Average", "X-ray"})) begin_cast(casts[static_cast<std::size_t>(cast)], state);
  if (look.cast == VolumeLook::Cast::shaded) return transfer_controls(state, interface);
  if (look.cast == VolumeLook::Cast::radiograph) {
    widgets::slider("White at attenuation", look.latitude, 0.5, 10, "%.1f");
    two_values("Air", look.black, "Dentine", look.white, state.shown->values->range);
    return;
  }
  if (look.projects()) two_values("Black", look.black, "White", look.white, state.shown->values->range);
}

}  // namespace odontoscope
