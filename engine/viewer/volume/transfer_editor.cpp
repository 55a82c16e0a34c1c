#include "engine/viewer/volume/transfer_editor.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/panel.h"

namespace odontoscope {
namespace {

using widgets::scaled;

/// Extinctions from hardly any to that of a wall are to be told apart: they stand at their logarithms.
constexpr double highest_shown = 60;
double share_of(double extinction) { return std::min(std::log1p(extinction) / std::log1p(highest_shown), 1.0); }
double extinction_at(double share) { return std::expm1(std::clamp(share, 0.0, 1.0) * std::log1p(highest_shown)); }

/// Where values and extinctions stand on the screen.
struct Plot {
  ImVec2 corner;
  float width, height;
  double low, span;

  float x(double value) const {
    return corner.x + static_cast<float>(std::clamp((value - low) / span, 0.0, 1.0)) * width;
  }
  float y(double extinction) const { return corner.y + static_cast<float>(1 - share_of(extinction)) * height; }
  double value(float place) const {
    return low + span * std::clamp(static_cast<double>((place - corner.x) / width), 0.0, 1.0);
  }
  double extinction(float place) const { return extinction_at(1 - static_cast<double>((place - corner.y) / height)); }
};

ImU32 shown(const glm::vec3& light, int alpha) {
  const auto channel = [](float part) {
    return static_cast<int>(255 * std::pow(std::clamp(part, 0.0f, 1.0f), 1 / 2.2f));
  };
  return IM_COL32(channel(light.r), channel(light.g), channel(light.b), alpha);
}

void draw_bars(const Plot& plot, const GreyValues& greys, const std::vector<TransferPoint>& transfer) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float bottom = plot.corner.y + plot.height,
              bar = plot.width / static_cast<float>(std::max<std::size_t>(greys.bars.size(), 1));
  list.AddRectFilled(plot.corner, {plot.corner.x + plot.width, bottom}, theme::raised, scaled(4));
  for (std::size_t i = 0; i < greys.bars.size(); ++i) {
    const double value =
        greys.low + plot.span * (static_cast<double>(i) + 0.5) / static_cast<double>(greys.bars.size());
    const float left = plot.corner.x + static_cast<float>(i) * bar, right = left + std::max(bar - scaled(0.5f), 1.0f);
    list.AddRectFilled({left, bottom - greys.bars[i] * (plot.height - scaled(6))}, {right, bottom}, theme::quiet);
    const glm::vec4 seen = transferred(transfer, value);
    if (seen.a > 0)
      list.AddRectFilled({left, plot.y(static_cast<double>(seen.a))}, {right, bottom}, shown(glm::vec3(seen), 150));
  }
  for (const double iso : greys.isos)
    list.AddLine({plot.x(iso), plot.corner.y}, {plot.x(iso), bottom}, theme::accent, scaled(2));
}

void draw_points(const Plot& plot, const std::vector<TransferPoint>& transfer, std::size_t chosen) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < transfer.size(); ++i) {
    const ImVec2 place(plot.x(transfer[i].value), plot.y(transfer[i].extinction));
    if (i > 0)
      list.AddLine({plot.x(transfer[i - 1].value), plot.y(transfer[i - 1].extinction)}, place, theme::text, scaled(1));
    list.AddCircleFilled(place, scaled(i == chosen ? 5.5f : 4), i == chosen ? theme::accent : theme::text, 16);
    list.AddCircleFilled(place, scaled(2.5f), shown(linear(transfer[i].colour), 255), 12);
  }
}

std::optional<std::size_t> point_at(const Plot& plot, const std::vector<TransferPoint>& transfer, const ImVec2& place) {
  std::optional<std::size_t> nearest;
  float best = scaled(9);
  for (std::size_t i = 0; i < transfer.size(); ++i) {
    const float away = std::hypot(plot.x(transfer[i].value) - place.x, plot.y(transfer[i].extinction) - place.y);
    if (away >= best) continue;
    best = away;
    nearest = i;
  }
  return nearest;
}

/// As far as its neighbours let it.
void put(std::vector<TransferPoint>& transfer, std::size_t index, double value, double extinction, const Plot& plot) {
  const double gap = 1e-3 * plot.span;
  const double low = index > 0 ? transfer[index - 1].value + gap : plot.low,
               high = index + 1 < transfer.size() ? transfer[index + 1].value - gap : plot.low + plot.span;
  if (low <= high) transfer[index].value = std::clamp(value, low, high);
  transfer[index].extinction = std::clamp(extinction, 0.0, most_extinction);
}

std::size_t added(std::vector<TransferPoint>& transfer, double value, double extinction) {
  const auto above = std::upper_bound(transfer.begin(), transfer.end(), value,
                                      [](double wanted, const TransferPoint& point) { return wanted < point.value; });
  const Colour colour = above == transfer.begin() ? above->colour : (above - 1)->colour;
  const auto place = transfer.insert(above, {value, colour, extinction});  // the points may lie elsewhere from here on
  return static_cast<std::size_t>(place - transfer.begin());
}

bool take_away(std::vector<TransferPoint>& transfer, std::size_t index, std::size_t& chosen) {
  if (transfer.size() <= 2) return false;
  transfer.erase(transfer.begin() + static_cast<std::ptrdiff_t>(index));
  chosen = std::min(chosen, transfer.size() - 1);
  return true;
}

bool moved_by_mouse(const Plot& plot, std::vector<TransferPoint>& transfer, std::size_t& chosen) {
  const ImVec2 place = ImGui::GetIO().MousePos;
  const bool hovered = ImGui::IsItemHovered();
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    const auto hit = point_at(plot, transfer, place);
    return hit && take_away(transfer, *hit, chosen);
  }
  if (!ImGui::IsItemActive() || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) return false;
  if (ImGui::IsItemActivated()) {
    const auto hit = point_at(plot, transfer, place);
    const bool room = transfer.size() < most_transfer_points &&
                      std::none_of(transfer.begin(), transfer.end(),
                                   [&](const TransferPoint& point) { return point.value == plot.value(place.x); });
    if (!hit && !room) return false;
    chosen = hit ? *hit : added(transfer, plot.value(place.x), plot.extinction(place.y));
    return !hit;
  }
  if (!ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0)) return false;
  const TransferPoint before = transfer[chosen];
  put(transfer, chosen, plot.value(place.x), plot.extinction(place.y), plot);
  return !(before == transfer[chosen]);
}

bool moved_by_numbers(const Plot& plot, std::vector<TransferPoint>& transfer, std::size_t& chosen,
                      const Interface& interface) {
  bool changed = colour_swatch("point colour", transfer[chosen].colour);
  ImGui::SameLine();
  if (widgets::button("Next point")) chosen = (chosen + 1) % transfer.size();
  ImGui::SameLine();
  if (widgets::button("Remove")) changed = take_away(transfer, chosen, chosen) || changed;
  widgets::remark(interface, fmt::format("Point {} of {}", chosen + 1, transfer.size()));
  double value = transfer[chosen].value, share = 100 * share_of(transfer[chosen].extinction);
  const bool value_moved = widgets::slider("Value of the point", value, plot.low, plot.low + plot.span, "%.5g");
  const bool share_moved = widgets::slider("Its extinction", share, 0, 100, "%.0f %%");
  if (value_moved || share_moved)
    put(transfer, chosen, value, share_moved ? extinction_at(share / 100) : transfer[chosen].extinction, plot);
  return changed || value_moved || share_moved;
}

}  // namespace

bool transfer_editor(const GreyValues& greys, std::vector<TransferPoint>& transfer, std::size_t& chosen,
                     const Interface& interface, float height) {
  chosen = std::min(chosen, transfer.size() - 1);
  const Plot plot{ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail().x, height, greys.low,
                  std::max(greys.high - greys.low, 1e-30)};
  draw_bars(plot, greys, transfer);
  ImGui::InvisibleButton("##transfer points", {plot.width, plot.height});
  widgets::noted("##transfer points", widgets::Field::drawn);
  const bool by_mouse = moved_by_mouse(plot, transfer, chosen);
  draw_points(plot, transfer, chosen);
  return moved_by_numbers(plot, transfer, chosen, interface) || by_mouse;
}

}  // namespace odontoscope
