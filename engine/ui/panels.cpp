#include "engine/ui/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/navigate/section_handle.h"
#include "engine/ui/film_panel.h"
#include "engine/ui/fly_panel.h"
#include "engine/ui/lab_panel.h"
#include "engine/ui/notes_panel.h"
#include "engine/ui/theme.h"
#include "engine/ui/volume_panel.h"
#include "engine/ui/widgets.h"
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

/// With a capital at its beginning.
std::string sentence(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

void heading(ViewerState& state, const Interface& interface) {
  ImGui::PushFont(interface.large);
  widgets::text(state.shown ? state.shown->title : "Odontoscope");
  ImGui::PopFont();
  const float button = scaled(30);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - button);
  if (widgets::button("?", {button, button})) state.pending_actions.push_back(Action::toggle_help);
  if (!state.shown) return;
  if (!state.shown->tooth.empty()) widgets::wrapped(sentence(state.shown->tooth));
  // In a word; what wants a look has its report above all else.
  const Certificate::Verdict verdict = state.shown->certificate.verdict;
  if (look_of(verdict).mark != Certificate::Mark::good) return;
  ImGui::PushFont(interface.small);
  widgets::marked(
      interface, Certificate::Mark::good,
      verdict == Certificate::Verdict::certified ? "Certified: the report is below" : "Sound: the report is below");
  ImGui::PopFont();
}

/// true: colour or opacity were changed by hand.
bool structure_row(Look& look) {
  ImGui::PushID(look.structure.c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {scaled(2), scaled(2)});
  widgets::eye("eye", look.visible);
  ImGui::SameLine();
  bool changed = widgets::swatch("colour", look.colour);
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

}  // namespace

namespace {

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

}  // namespace

void two_buttons(ViewerState& state, const char* left, Action on_left, const char* right, Action on_right) {
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  if (widgets::button(left, {width, 0})) state.pending_actions.push_back(on_left);
  ImGui::SameLine();
  if (widgets::button(right, {width, 0})) state.pending_actions.push_back(on_right);
}

void report_section(ViewerState& state, const Interface& interface) {
  if (!state.shown) return;
  const Certificate& certificate = state.shown->certificate;
  const VerdictLook look = look_of(certificate.verdict);
  headline(certificate, look, interface);
  if (!widgets::section(interface, "Report", look.mark != Certificate::Mark::good)) return;
  const std::size_t structures = state.shown->scene.looks.size();
  widgets::remark(interface, fmt::format("{} triangles in {} surface{}", grouped(state.shown->triangles), structures,
                                         structures == 1 ? "" : "s"));
  ImGui::PushFont(interface.small);
  std::size_t number = 0;
  for (const Certificate::Finding& finding : certificate.findings) {
    if (!finding.at) {
      widgets::marked(interface, finding.mark, finding.words);
    } else if (widgets::marked_button(fmt::format("place {}", number++).c_str(), finding.mark, finding.words)) {
      state.look_at = finding.at;
    }
  }
  ImGui::PopFont();
}

void structures_section(ViewerState& state, const Interface& interface) {
  if (!widgets::section(interface, "Structures")) return;
  for (Look& look : state.scene.looks)
    if (structure_row(look) && !state.lab.on) remember(state.settings, look);
  if (!state.lab.on && !looks_are_usual(state) && widgets::wide_button("Usual colours and opacities"))
    reset_looks(state);
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
  if (!widgets::section(interface, "Overlays", false) || !state.shown) return;
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

void measure_section(ViewerState& state, const Interface& interface) {
  if (!widgets::section(interface, "Measure")) return;
  int tool = state.tool == Tool::distance ? 0 : state.tool == Tool::thickness ? 1 : -1;
  if (widgets::choice("tool", tool, {"Distance", "Wall thickness"}))
    state.pending_actions.push_back(tool == 0 ? Action::measure_distance : Action::measure_thickness);
  const Measured& measured = state.measured;
  if (measured.ends.size() == 2) {
    widgets::text(fmt::format("{:.3f} mm", distance_between_mm(measured.ends[0], measured.ends[1])));
    widgets::remark(interface,
                    fmt::format("from {} to {}, straight", measured.ends[0].structure, measured.ends[1].structure));
  } else if (measured.wall) {
    widgets::text(fmt::format("{:.3f} mm", measured.wall->along_normal_mm));
    widgets::remark(interface, fmt::format("{}, straight through. The largest ball that fits in is {:.3f} mm across.",
                                           measured.wall_at->structure, measured.wall->largest_ball_mm));
  }
  if (state.tool != Tool::look && widgets::wide_button("Done")) state.pending_actions.push_back(Action::escape);
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

void camera_section(ViewerState& state, const Interface& interface) {
  if (!widgets::section(interface, "View")) return;
  int projection = static_cast<int>(state.scene.camera.projection);
  if (widgets::choice("projection", projection, {"Perspective", "Parallel"}))
    state.pending_actions.push_back(Action::toggle_projection);
  widgets::toggle("Names (H)", state.settings.names);
  two_buttons(state, "Fit", Action::fit, "Three quarters", Action::view_three_quarter);
  int backdrop = static_cast<int>(state.settings.backdrop);
  if (widgets::choice("backdrop", backdrop, {"Dark", "Light", "White"})) {
    state.settings.backdrop = static_cast<Backdrop>(backdrop);
    state.scene.background = background_of(state.settings.backdrop);
  }
  language_choice(state, interface);
}

void picture_section(ViewerState& state, const Interface& interface) {
  if (!widgets::section(interface, "Picture", false)) return;
  PictureSettings& picture = state.settings.picture;
  ImGui::AlignTextToFramePadding();
  widgets::text("Size");
  const float field = scaled(84);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 2 * field - scaled(22));
  ImGui::SetNextItemWidth(field);
  widgets::text_field("##width");
  ImGui::InputInt("##width", &picture.width, 0);
  widgets::noted("##width");
  ImGui::SameLine(0, scaled(6));
  ImGui::TextUnformatted("\xC3\x97");
  ImGui::SameLine(0, scaled(6));
  ImGui::SetNextItemWidth(field);
  ImGui::BeginDisabled(picture.as_seen);
  widgets::text_field("##height");
  ImGui::InputInt("##height", &picture.height, 0);
  widgets::noted("##height");
  ImGui::EndDisabled();
  if (!ImGui::IsAnyItemActive()) {
    picture.width = std::clamp(picture.width, 16, 16384);
    picture.height = std::clamp(picture.height, 16, 16384);
  }
  widgets::toggle("Same shape as the view", picture.as_seen);
  widgets::text("Samples a pixel");
  int samples = picture.side - 1;
  if (widgets::choice("samples", samples, {"1", "4", "9", "16"})) picture.side = samples + 1;
  widgets::toggle("Transparent background", picture.transparent);
  if (widgets::wide_button("Take a picture", true)) state.pending_actions.push_back(Action::take_picture);
  if (widgets::wide_button("Save camera and looks")) state.pending_actions.push_back(Action::save_scene);
  widgets::remark(interface, "Files go to the folder that the viewer was started in.");
}

void draw_panel(ViewerState& state, const Interface& interface, const Area& area) {
  ImGui::SetNextWindowPos({static_cast<float>(area.left), static_cast<float>(area.top)});
  ImGui::SetNextWindowSize({static_cast<float>(area.width), static_cast<float>(area.height)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleVar();
  heading(state, interface);
  if (state.shown && state.fly.on) {
    fly_sections(state, interface);
    notes_section(state, interface);
  } else if (state.shown) {
    // What people come for first; what was proven comes before it only where it wants a look.
    const bool good = look_of(state.shown->certificate.verdict).mark == Certificate::Mark::good;
    fly_entrance(state, interface);
    if (widgets::wide_button("Lessons (G)", true)) state.pending_actions.push_back(Action::toggle_lessons);
    if (state.lab.on) lab_section(state, interface);
    if (!good) report_section(state, interface);
    structures_section(state, interface);
    section_section(state, interface);
    volume_section(state, interface);
    film_section(state, interface);
    measure_section(state, interface);
    camera_section(state, interface);
    if (!state.lab.on) lab_section(state, interface);
    notes_section(state, interface);
    picture_section(state, interface);
    if (good) report_section(state, interface);
    faces_section(state, interface);
    overlays_section(state, interface);
  }
  ImGui::Dummy({0, scaled(2)});
  if (state.shown && state.headset_possible && widgets::wide_button("Enter the headset")) state.headset_asked = true;
  if (widgets::wide_button("Open a file\xE2\x80\xA6")) state.pending_actions.push_back(Action::open_file);
  ImGui::End();
}

}  // namespace odontoscope
