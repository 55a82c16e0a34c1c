#include "engine/viewer/look/look_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/navigate/section_handle.h"
#include "engine/navigate/thickness_colours.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/fly/on_wall.h"
#include "engine/viewer/panel.h"
#include "recon/core/grouped.h"

namespace odontoscope {

namespace {

using widgets::scaled;

struct VerdictLook {
  Certificate::Mark mark;
  ImU32 edge, ground;
};

VerdictLook look_of(Certificate::Verdict verdict) {
  switch (verdict) {
    case Certificate::Verdict::certified:
    case Certificate::Verdict::sound:
      return {Certificate::Mark::good, theme::good, theme::good_back};
    case Certificate::Verdict::look_here:
      return {Certificate::Mark::look, theme::amber, theme::amber_back};
    case Certificate::Verdict::wanting:
      break;
  }
  return {Certificate::Mark::bad, theme::bad, theme::bad_back};
}

/// true: colour or opacity were changed by hand.
bool structure_row(Look& look) {
  ImGui::PushID(look.structure.c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {scaled(2), scaled(2)});
  widgets::eye("eye", look.visible);
  ImGui::SameLine();
  bool changed = colour_swatch("colour", look.colour);
  ImGui::SameLine(0, scaled(6));
  ImGui::BeginGroup();
  ImGui::PushStyleColor(ImGuiCol_Text, look.visible ? theme::text : theme::quiet);
  double percent = 100.0 * look.opacity;
  if (widgets::slider(look.structure.c_str(), percent, 0, 100, "%.0f %%")) {
    look.opacity = static_cast<float>(percent / 100);
    changed = true;
  }
  ImGui::PopStyleColor();
  ImGui::EndGroup();
  ImGui::PopStyleVar();
  ImGui::PopID();
  return changed;
}

/// Colours and opacities as for anybody who opens this model for the first time; nothing of them is remembered.
void reset_looks(ViewerState& state) {
  for (Look& look : state.scene.looks) {
    forget(state.settings, look.structure);
    if (const Look* usual = state.shown->scene.look_of(look.structure)) {
      look.colour = usual->colour;
      look.opacity = usual->opacity;
    }
  }
}

bool looks_are_usual(const ViewerState& state) {
  return std::all_of(state.scene.looks.begin(), state.scene.looks.end(), [&](const Look& look) {
    const Look* usual = state.shown->scene.look_of(look.structure);
    return !usual || (look.colour == usual->colour && look.opacity == usual->opacity);
  });
}

void headline(const Certificate& certificate, const VerdictLook& look, const Interface& interface) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, inset = scaled(12);
  const float wrap = width - 2 * inset - scaled(20);
  ImGui::PushFont(interface.bold);
  const float height =
      ImGui::CalcTextSize(interface.say(certificate.headline).c_str(), nullptr, false, wrap).y + 2 * scaled(9);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, look.ground, scaled(6));
  list.AddRectFilled(corner, {corner.x + scaled(4), corner.y + height}, look.edge, scaled(6),
                     ImDrawFlags_RoundCornersLeft);
  ImGui::SetCursorScreenPos({corner.x + inset, corner.y + scaled(9)});
  ImGui::BeginGroup();
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width - 2 * inset);
  widgets::marked(interface, look.mark, certificate.headline);
  ImGui::PopTextWrapPos();
  ImGui::EndGroup();
  ImGui::PopFont();
  ImGui::SetCursorScreenPos({corner.x, corner.y + height});
  ImGui::Dummy({width, 0});
}

/// Only what came from a volume has values to show.
void cap_choice(CapLook& cap, const ValueGrid& values) {
  int shows = cap.shows == CapLook::Shows::ct ? 1 : 0;
  if (widgets::choice("cap", shows, {"Material", "CT values"}))
    cap.shows = shows == 1 ? CapLook::Shows::ct : CapLook::Shows::material;
  if (cap.shows != CapLook::Shows::ct) return;
  const ValueWindow range = values.range;
  ValueWindow window = cap.window.value_or(values.usual);
  const double least = 0.001 * (range.high - range.low);  // that black and white stay apart
  const bool black = widgets::slider("Black", window.low, range.low, range.high, "%.5g");
  const bool white = widgets::slider("White", window.high, range.low, range.high, "%.5g");
  if (!black && !white) return;
  if (black)
    window.high = std::max(window.high, window.low + least);
  else
    window.low = std::min(window.low, window.high - least);
  if (window.sensible()) cap.window = window;
}

/// Each by its own name, which whoever looks for it can read.
void language_choice(ViewerState& state, const Interface& interface) {
  std::vector<const char*> names;
  int chosen = 0;
  for (const Language& language : state.languages) {
    if (language.tag == interface.language().tag) chosen = static_cast<int>(names.size());
    names.push_back(language.name.c_str());
  }
  if (widgets::choice("language", chosen, names))
    state.settings.language = state.languages[static_cast<std::size_t>(chosen)].tag;
}

}  // namespace

std::optional<glm::dvec3> report_section(const LoadedModel& shown, const Interface& interface) {
  const Certificate& certificate = shown.certificate;
  const VerdictLook look = look_of(certificate.verdict);
  headline(certificate, look, interface);
  if (!widgets::section(interface, "Report", widgets::open_if(look.mark != Certificate::Mark::good))) return {};
  const std::size_t structures = shown.scene.looks.size();
  widgets::remark(interface, fmt::format("{} triangles in {} surface{}", grouped(shown.triangles), structures,
                                         structures == 1 ? "" : "s"));
  ImGui::PushFont(interface.small);
  std::optional<glm::dvec3> asked;
  std::size_t number = 0;
  for (const Certificate::Finding& finding : certificate.findings) {
    if (!finding.at) {
      widgets::marked(interface, finding.mark, finding.words);
    } else if (widgets::marked_button(fmt::format("place {}", number++).c_str(), finding.mark, finding.words)) {
      asked = finding.at;
    }
  }
  ImGui::PopFont();
  return asked;
}

void structures_section(ViewerState& state, bool remembered, const Interface& interface) {
  if (!widgets::section(interface, "Structures")) return;
  for (Look& look : state.scene.looks)
    if (structure_row(look) && remembered) remember(state.settings, look);
  if (remembered && !looks_are_usual(state) && widgets::wide_button("Usual colours and opacities")) reset_looks(state);
}

void faces_section(ViewerState& state, const Interface& interface) {
  if (!widgets::section(interface, "Faces")) return;
  int mode = static_cast<int>(state.scene.back_faces);
  if (widgets::choice("back faces", mode, {"Cull", "Two-sided", "Tint"}))
    state.scene.back_faces = static_cast<BackFaces>(mode);
  constexpr const char* explained[] = {
      "Faces seen from behind are left out, as games and web pages do: a wrongly turned triangle is a hole.",
      "Faces seen from behind are drawn like any other.",
      "Faces seen from behind are magenta. On a sound model there are none to see from outside."};
  widgets::remark(interface, explained[mode]);
  double strength = state.scene.occlusion.on ? state.scene.occlusion.strength : 0;
  if (widgets::slider("Shadow in fissures", strength, 0, 2, "%.1f")) {
    state.scene.occlusion.on = strength > 0.02;
    state.scene.occlusion.strength = static_cast<float>(strength);
  }
}

void overlays_section(ViewerState& state, const Interface& interface) {
  if (!widgets::section(interface, "Overlays", widgets::AtFirst::folded) || !state.shown) return;
  const OverlaySource& source = state.shown->overlays;
  OverlayChoice& overlays = state.scene.overlays;
  widgets::toggle("Triangle edges", state.scene.wire);
  ImGui::BeginDisabled(source.contours.slices.empty());
  widgets::toggle("Contours of the slices", overlays.contours);
  ImGui::EndDisabled();
  widgets::toggle("Faulty edges", overlays.edges);
  if (overlays.edges && source.faulty_edges.empty())
    widgets::remark(interface, "There are none: every edge has two triangles that agree.");
  ImGui::BeginDisabled(source.slabs() == 0);
  bool slab = overlays.slab.has_value();
  if (widgets::toggle("Tetrahedra of one slab", slab)) {
    overlays.slab = slab ? std::optional(source.slabs() / 2) : std::nullopt;
    constexpr float clear_enough = 0.12f;  // what surrounds the tetrahedra must let them be seen
    if (slab)
      for (Look& look : state.scene.looks) look.opacity = std::min(look.opacity, clear_enough);
  }
  ImGui::EndDisabled();
  if (overlays.slab && source.slabs() > 0) {
    double number = static_cast<double>(*overlays.slab), shrink = 100.0 * overlays.shrink;
    if (widgets::slider("Slab", number, 0, static_cast<double>(source.slabs() - 1), "%.0f"))
      overlays.slab = static_cast<std::size_t>(std::lround(number));
    if (widgets::slider("Size of each", shrink, 20, 100, "%.0f %%")) overlays.shrink = static_cast<float>(shrink / 100);
  }
  if (source.slabs() == 0)
    widgets::remark(interface, "A mesh file has neither contours nor tetrahedra: open the contour stack for those.");
}

void section_section(ViewerState& state, const Interface& interface) {
  if (!widgets::section(interface, "Section")) return;
  bool on = state.scene.section.has_value();
  if (widgets::toggle("Cut the model open", on)) state.pending_actions.push_back(Action::toggle_section);
  if (!state.scene.section || !state.shown) return;
  Section& section = *state.scene.section;
  const Model& model = state.shown->model;
  const AnatomicalFrame tooth;
  const std::pair<const char*, glm::dvec3> sides[] = {
      {"Buccal", tooth.buccal}, {"Mesial", tooth.mesial}, {"Occlusal", tooth.occlusal}};
  int chosen = -1;
  for (int i = 0; i < 3; ++i)
    if (std::abs(glm::dot(glm::normalize(section.normal), sides[i].second)) > 0.99999) chosen = i;
  if (widgets::choice("side", chosen, {"Buccal", "Mesial", "Occlusal"}))
    section = with_offset({section.point_mm, sides[chosen].second}, 0, model);
  double offset = offset_of(section, model);
  if (widgets::slider("Position", offset, -model.radius_mm, model.radius_mm, "%+.2f mm"))
    section = with_offset(section, offset, model);
  SectionAngles angles = angles_of(section);
  const bool turned = widgets::slider("Turn", angles.round_deg, -180, 180, "%.0f\xC2\xB0");
  if (widgets::slider("Tilt", angles.up_deg, -90, 90, "%.0f\xC2\xB0") || turned) {
    const double kept = offset_of(section, model);
    section = with_offset({section.point_mm, normal_of(angles)}, kept, model);
  }
  if (state.shown->values) cap_choice(state.scene.cap, *state.shown->values);
  if (widgets::wide_button("Cut away the other side")) state.pending_actions.push_back(Action::flip_section);
  widgets::remark(interface, "In the picture: drag the knob to move the plane, the arrow's tip to turn it.");
}

void camera_section(ViewerState& state, const Interface& interface) {
  if (!widgets::section(interface, "View")) return;
  int projection = static_cast<int>(state.scene.camera.projection);
  if (widgets::choice("projection", projection, {"Perspective", "Parallel"}))
    state.pending_actions.push_back(Action::toggle_projection);
  widgets::toggle("Names (H)", state.settings.names);
  if (state.shown && tells_thickness(state.shown->model)) {
    widgets::toggle("Thickness of the wall (I)", state.scene.wall_thickness);
    if (state.scene.wall_thickness) widgets::remark(interface, thickness_in_words(state.shown->model));
  }
  two_buttons(state.pending_actions, "Fit", Action::fit, "Three quarters", Action::view_three_quarter);
  int backdrop = static_cast<int>(state.settings.backdrop);
  if (widgets::choice("backdrop", backdrop, {"Dark", "Light", "White"})) {
    state.settings.backdrop = static_cast<Backdrop>(backdrop);
    state.scene.background = background_of(state.settings.backdrop);
  }
  language_choice(state, interface);
}

}  // namespace odontoscope
