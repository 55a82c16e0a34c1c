#include "engine/viewer/help/first_hints.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "engine/navigate/screen.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/fly/fly_mode.h"
#include "engine/viewer/names/names_mode.h"
#include "engine/viewer/notes/notes_mode.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

namespace {

constexpr double turned_cosine = 0.985;       // some ten degrees
constexpr double hints_beside_compass = 170;  // interface pixels

bool has_canals(const ViewerState& state) {
  return state.shown->flight && !state.shown->flight->cavities.empty() &&
         !rideable(state.shown->flight->cavities.front().lines).empty();
}

}  // namespace

bool FirstHints::follow(Workspace& at) {
  ViewerState& state = at.state;
  if (!state.settings.hints || !state.shown) return false;
  const FlyMode& fly = at.modes.get<FlyMode>();
  const NamesMode& names = at.modes.get<NamesMode>();
  const glm::dvec3 towards_eye = axes_of(state.scene.camera).towards_eye;
  if (!first_view_) first_view_ = towards_eye;
  const bool from_outside = at.modes.effects().from_outside;
  if (from_outside && !at.modes.get<NotesMode>().notes().shown && glm::dot(towards_eye, *first_view_) < turned_cosine)
    turned_ = true;
  const bool inside = has_canals(state);
  if (names.canal() || (inside ? fly.riding() : names.names().told.has_value())) clicked_ = true;
  if (!from_outside && (fly.inside() || !inside)) flown_ = true;
  if (!(turned_ && clicked_ && flown_)) return false;
  state.settings.hints = false;
  return true;
}

void FirstHints::draw(Workspace& at) const {
  ViewerState& state = at.state;
  const Interface& interface = at.interface;
  const Area& viewport = at.layout.viewport;
  const float scale = at.layout.scale;
  struct Hint {
    const char* words;
    bool done;
  };
  const bool inside = has_canals(state);
  const std::array hints = {Hint{"Drag to turn", turned_}, Hint{inside ? "Click a canal" : "Click a name", clicked_},
                            Hint{inside ? "C: fly inside" : "A: fly around", flown_}};
  const float room = static_cast<float>(viewport.width - (14 + hints_beside_compass) * scale);
  ImGui::SetNextWindowPos(
      {static_cast<float>(viewport.left) + 14 * scale, static_cast<float>(viewport.top) + 12 * scale});
  ImGui::SetNextWindowSize({0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12 * scale, 7 * scale});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::rgb(0x14181c, 225));
  ImGui::Begin("hints", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  const bool in_a_row = room > 480 * scale;
  for (std::size_t i = 0; i < hints.size(); ++i) {
    if (i > 0 && in_a_row) ImGui::SameLine(0, 18 * scale);
    ImGui::BeginGroup();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float radius = 9 * scale, line = ImGui::GetFrameHeight();
    const ImVec2 middle(corner.x + radius, corner.y + 0.5f * line);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircleFilled(middle, radius, hints[i].done ? theme::good_back : theme::accent_dark, 24);
    if (hints[i].done) {
      const float s = 4 * scale;
      const ImVec2 tick[] = {
          {middle.x - s, middle.y}, {middle.x - 0.2f * s, middle.y + 0.8f * s}, {middle.x + s, middle.y - 0.8f * s}};
      list.AddPolyline(tick, 3, theme::good, 0, 2 * scale);
    } else {
      const char number[] = {static_cast<char>('1' + i), 0};
      const ImVec2 extent = interface.small->CalcTextSizeA(interface.small->FontSize, 1e9f, 0, number);
      list.AddText(interface.small, interface.small->FontSize, {middle.x - 0.5f * extent.x, middle.y - 0.5f * extent.y},
                   theme::text, number);
    }
    ImGui::Dummy({2 * radius, line});
    ImGui::SameLine(0, 7 * scale);
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, hints[i].done ? theme::quiet : theme::text);
    widgets::text(hints[i].words);
    ImGui::PopStyleColor();
    ImGui::EndGroup();
  }
  if (in_a_row) ImGui::SameLine(0, 18 * scale);
  if (widgets::button("Got it")) state.settings.hints = false;
  ImGui::End();
}

}  // namespace odontoscope
