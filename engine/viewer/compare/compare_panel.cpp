#include "engine/viewer/compare/compare_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "engine/navigate/screen.h"
#include "engine/ui/dialog.h"
#include "engine/ui/drawing.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/compare/comparison_run.h"
#include "engine/viewer/trouble.h"
#include "recon/core/grouped.h"

namespace odontoscope {

namespace {

using widgets::scaled;

/// Of the line about back faces, at the bottom.
constexpr double culling_height = 40;

/// One line of the comparison: its name, DT's count, DB's.
void count_row(const Interface& interface, const char* words, std::size_t dt, std::optional<std::size_t> db,
               bool faults) {
  const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
  widgets::text(words);
  const auto number = [&](const std::string& count, float right, ImU32 colour) {
    const std::string text = interface.say(count);
    ImGui::PushFont(interface.bold);
    ImGui::SameLine(left + right - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
  };
  const auto colour = [&](std::size_t count) { return !faults ? theme::text : count > 0 ? theme::bad : theme::good; };
  number(grouped(dt), 0.74f * width, colour(dt));
  number(db ? grouped(*db) : "\xE2\x80\xA6", width, db ? colour(*db) : theme::quiet);
}

void counts(const ComparisonState& compared, const ViewerState& state, const Interface& interface) {
  const FaultyEdges dt = faulty_edges_of(*state.shown);
  const ComparisonResult* db = compared.made.get();
  const auto of_db = [&](auto count) { return db ? std::optional((db->*count)()) : std::nullopt; };
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {scaled(8), scaled(3)});
  const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
  ImGui::PushFont(interface.small);
  ImGui::PushStyleColor(ImGuiCol_Text, theme::quiet);
  widgets::text("Faulty edges");
  for (const auto& [words, right] : {std::pair("DT", 0.74f * width), std::pair("DB", width)}) {
    ImGui::SameLine(left + right - ImGui::CalcTextSize(words).x);
    ImGui::TextUnformatted(words);
  }
  ImGui::PopStyleColor();
  ImGui::PopFont();
  count_row(interface, "Cracks", dt.cracks, of_db(&ComparisonResult::cracks), true);
  count_row(interface, "Misoriented", dt.misoriented, of_db(&ComparisonResult::misoriented), true);
  count_row(interface, "Non-manifold", dt.nonmanifold, of_db(&ComparisonResult::nonmanifold), true);
  count_row(interface, "Triangles", state.shown->triangles, of_db(&ComparisonResult::triangles), false);
  ImGui::PopStyleVar();
}

void db_options(ComparisonState& compared, const Interface& interface) {
  double grid = static_cast<double>(compared.wanted.grid);
  if (widgets::slider("Grid points across", grid, comparison_limits::least_grid, 192, "%.0f"))
    compared.wanted.grid = 4 * static_cast<std::size_t>(std::lround(grid / 4));
  int cases = static_cast<int>(compared.wanted.cases);
  if (widgets::choice("cases", cases, {"Classic", "Unoriented", "Consistent"}))
    compared.wanted.cases = static_cast<CaseTable>(cases);
  constexpr const char* tables[] = {"Table of 1987: neighbours disagree about some faces, which tears cracks.",
                                    "The same, complements not turned over: triangles that face the wrong way.",
                                    "Three more base cases: neighbours always agree."};
  widgets::remark(interface, tables[cases]);
  int field = compared.wanted.field == FieldKind::hybrid            ? 0
              : compared.wanted.field == FieldKind::signed_distance ? 1
                                                                    : 2;
  if (widgets::choice("field", field, {"Hybrid", "Distance", "Sign only"}))
    compared.wanted.field = field == 0 ? FieldKind::hybrid : field == 1 ? FieldKind::signed_distance : FieldKind::sign;
  widgets::text("Triangles kept");
  int decimation = static_cast<int>(compared.wanted.decimation);
  if (widgets::choice("decimation", decimation, {"All", "1/2", "1/10", "Fewest"}))
    compared.wanted.decimation = static_cast<ComparisonDecimation>(decimation);
}

void progress_line(const ComparisonState& compared, const Interface& interface) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = scaled(4);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (compared.run.working) {
    list.AddRectFilled(corner, {corner.x + width, corner.y + height}, theme::raised, height / 2);
    list.AddRectFilled(
        corner,
        {corner.x + width * static_cast<float>(std::clamp(compared.run.fraction, 0.03, 1.0)), corner.y + height},
        theme::accent, height / 2);
  }
  ImGui::Dummy({width, height});  // its room is kept, so that nothing jumps
  if (compared.trouble.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, theme::bad);
  draw_trouble(interface, compared.trouble);
  ImGui::PopStyleColor();
}

/// A line of words on a dark ground; returns its height.
float pill(const Interface& interface, ImFont* font, double left, double top, float scale, ImU32 colour,
           const std::string& english, double most_width) {
  const std::string words = interface.say(english);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float wrap = static_cast<float>(most_width) - 20 * scale;
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e9f, wrap, words.c_str());
  const ImVec2 low = vec(left, top), high(low.x + size.x + 20 * scale, low.y + size.y + 10 * scale);
  list.AddRectFilled(low, high, theme::rgb(0x14181c, 215), 6 * scale);
  list.AddText(font, font->FontSize, {low.x + 10 * scale, low.y + 5 * scale}, colour, words.c_str(), nullptr, wrap);
  return high.y - low.y;
}

std::string faults_in_words(std::size_t cracks, std::size_t misoriented, std::size_t nonmanifold) {
  if (cracks + misoriented + nonmanifold == 0) return "no faulty edge";
  std::string words;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", grouped(count), what);
  };
  add(misoriented, "misoriented");
  add(cracks, "cracked");
  add(nonmanifold, "non-manifold");
  return words;
}

void draw_methods(const ComparisonState& compared, const ViewerState& state, const std::vector<ViewPane>& panes,
                  const Interface& interface, const Area& viewport, float scale) {
  for (const ViewPane& pane : panes) {
    const Area& area = pane.shown();
    constexpr double compass = 150;
    const double left = area.left + 14 * scale,
                 width = area.width - (28 + (&pane == &panes.back() ? compass : 0)) * scale;
    if (width < 60 * scale) continue;
    double top = area.top + 14 * scale;
    std::string facts;
    bool faulty = false;
    if (pane.db) {
      const ComparisonResult& made = *compared.made;
      facts = fmt::format("grid {}, {}: {}", made.options.grid, name(made.options.cases),
                          faults_in_words(made.cracks(), made.misoriented(), made.nonmanifold()));
      faulty = made.cracks() + made.misoriented() + made.nonmanifold() > 0;
    } else {
      const FaultyEdges edges = faulty_edges_of(*state.shown);
      facts = faults_in_words(edges.cracks, edges.misoriented, edges.nonmanifold);
      faulty = edges.cracks + edges.misoriented + edges.nonmanifold > 0;
    }
    top += pill(interface, interface.large, left, top, scale, theme::text,
                pane.db ? "DB  distance field" : "DT  Delaunay", width) +
           4 * scale;
    pill(interface, interface.small, left, top, scale, faulty ? theme::bad : theme::good, facts, width);
  }
  if (!compared.made && compared.trouble.empty()) {
    const double width = 260 * scale;
    pill(interface, interface.bold, viewport.left + (viewport.width - width) / 2, viewport.top + viewport.height / 2,
         scale, theme::mark, "Making the DB surface\xE2\x80\xA6", width + 40 * scale);
  }
}

void draw_split_line(const std::vector<ViewPane>& panes, float scale) {
  for (const ViewPane& pane : panes) {
    if (!pane.seen || !pane.db) continue;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 top = vec(pane.seen->left, pane.seen->top),
                 bottom = vec(pane.seen->left, pane.seen->top + pane.seen->height);
    list.AddLine(top, bottom, theme::mark_outline, 4 * scale);
    list.AddLine(top, bottom, theme::mark, 1.6f * scale);
    const ImVec2 knob(top.x, 0.5f * (top.y + bottom.y));
    list.AddCircleFilled(knob, 13 * scale, theme::mark_outline, 32);
    list.AddCircleFilled(knob, 11 * scale, theme::mark, 32);
    for (const float side : {-1.0f, 1.0f}) {
      const float x = knob.x + side * 3 * scale, s = 4 * scale;
      list.AddTriangleFilled({x, knob.y - s}, {x, knob.y + s}, {x + side * s, knob.y}, theme::mark_outline);
    }
  }
}

void draw_artefact_ring(const ComparisonState& compared, const std::vector<ViewPane>& panes, float scale) {
  if (!compared.made || !compared.artefact || *compared.artefact >= compared.made->artefacts.size()) return;
  for (const ViewPane& pane : panes) {
    const auto place = place_of(pane.camera, compared.made->artefacts[*compared.artefact].at);
    if (!place) continue;
    const glm::dvec2 at = pixel_of(pane.area, *place);
    if (!pane.shown().holds(at.x, at.y)) continue;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float radius = 0.09f * static_cast<float>(pane.area.height);
    list.AddCircle(vec(at.x, at.y), radius, theme::mark_outline, 64, 5 * scale);
    list.AddCircle(vec(at.x, at.y), radius, theme::mark, 64, 2.4f * scale);
  }
}

/// Back, next, close, side by side.
void three_buttons(ViewerState& state, const char* back, Action on_back, const char* next, Action on_next,
                   Action on_close) {
  const float width = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
  if (widgets::button(back, {width, 0})) state.pending_actions.push_back(on_back);
  ImGui::SameLine();
  if (widgets::button(next, {width, 0})) state.pending_actions.push_back(on_next);
  ImGui::SameLine();
  if (widgets::button("Close (Esc)", {width, 0})) state.pending_actions.push_back(on_close);
}

void lesson_dialog(const ComparisonState& compared, ViewerState& state, const Interface& interface,
                   const Area& viewport, float scale) {
  const ArtefactLessonStep& step = compared.lesson->steps[compared.step];
  if (begin_dialog("lesson", viewport, scale, 680, culling_height + 8)) {
    ImGui::PushFont(interface.large);
    widgets::text(fmt::format("{} / {}   {}", compared.step + 1, compared.lesson->steps.size(), step.title));
    ImGui::PopFont();
    widgets::wrapped(step.words);
    if (compared.artefact && compared.made && *compared.artefact < compared.made->artefacts.size())
      widgets::remark(interface, in_words(compared.made->artefacts[*compared.artefact], compared.made->options.cases));
    three_buttons(state, "Back (Page up)", Action::previous_step, "Next (Page down)", Action::next_step,
                  Action::toggle_lesson);
  }
  ImGui::End();
}

void artefact_dialog(const ComparisonState& compared, ViewerState& state, const Interface& interface,
                     const Area& viewport, float scale) {
  const ComparisonResult& made = *compared.made;
  const ComparisonArtefact& artefact = made.artefacts[*compared.artefact];
  if (begin_dialog("artefact", viewport, scale, 680, culling_height + 8)) {
    ImGui::PushFont(interface.large);
    const char* kind = artefact.kind == DefectKind::crack         ? "Crack"
                       : artefact.kind == DefectKind::misoriented ? "Misoriented triangles"
                                                                  : "Non-manifold edge";
    widgets::text(fmt::format("{} in {}   {} of {}", kind, artefact.structure, grouped(*compared.artefact + 1),
                              grouped(made.artefacts.size())));
    ImGui::PopFont();
    widgets::wrapped(in_words(artefact, made.options.cases));
    three_buttons(state, "Before (V)", Action::previous_artefact, "Next artefact (N)", Action::next_artefact,
                  Action::escape);
  }
  ImGui::End();
}

/// The paper's lesson in one key: said where one looks.
void draw_culling(const ViewerState& state, const Interface& interface, const Area& viewport, float scale) {
  constexpr const char* said[] = {"Back faces culled: what is wrongly turned is a hole.  B: draw both sides",
                                  "Both sides drawn: wrongly turned triangles look whole.  B: tint them",
                                  "Back faces tinted: magenta is wrongly turned.  B: cull them"};
  const std::string words = interface.say(said[static_cast<int>(state.scene.back_faces)]);
  ImFont* font = interface.bold;
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e9f, 0, words.c_str());
  const double room = viewport.width - 40 * scale, width = std::min<double>(size.x + 20 * scale, room);
  const double top =
      viewport.top + viewport.height - culling_height * scale - (width < size.x + 20 * scale ? size.y : 0);
  pill(interface, font, viewport.left + (viewport.width - width) / 2, top, scale, theme::mark, words, room);
}

}  // namespace

FaultyEdges faulty_edges_of(const LoadedModel& shown) {
  FaultyEdges edges;
  for (const LineSet& set : shown.overlays.faulty_edges) {
    const std::size_t count = set.points.size() / 2;
    if (set.kind == LineKind::boundary_edge)
      edges.cracks += count;
    else if (set.kind == LineKind::misoriented_edge)
      edges.misoriented += count;
    else if (set.kind == LineKind::non_manifold_edge)
      edges.nonmanifold += count;
  }
  return edges;
}

void comparison_section(ComparisonState& compared, ViewerState& state, const Interface& interface) {
  if (!comparison_possible(*state.shown)) return;
  if (!compared.on) {
    if (widgets::wide_button("Compare with DB (D)")) state.pending_actions.push_back(Action::toggle_comparison);
    return;
  }
  if (!widgets::section(interface, "DT and DB")) return;
  int layout = compared.layout == ComparisonLayout::side_by_side ? 0
               : compared.layout == ComparisonLayout::split      ? 1
               : compared.db_in_place                            ? 3
                                                                 : 2;
  if (widgets::choice("layout", layout, {"Both", "Split", "DT", "DB"})) {
    compared.layout = layout == 0   ? ComparisonLayout::side_by_side
                      : layout == 1 ? ComparisonLayout::split
                                    : ComparisonLayout::in_place;
    compared.db_in_place = layout != 2;
  }
  counts(compared, state, interface);
  int faces = static_cast<int>(state.scene.back_faces);
  if (widgets::choice("comparison faces", faces, {"Cull (B)", "Two-sided", "Tint"}))
    state.scene.back_faces = static_cast<BackFaces>(faces);
  widgets::toggle("Draw the faulty edges (E)", state.scene.overlays.edges);
  if (widgets::wide_button("Next artefact (N)", widgets::Emphasis::strong))
    state.pending_actions.push_back(Action::next_artefact);
  progress_line(compared, interface);
  db_options(compared, interface);
  if (widgets::wide_button(compared.lesson ? "End the lesson" : "Lesson: why culling shows errors"))
    state.pending_actions.push_back(Action::toggle_lesson);
  if (widgets::wide_button("Leave DB mode (D)")) state.pending_actions.push_back(Action::toggle_comparison);
}

void draw_comparison(const ComparisonState& compared, ViewerState& state, const std::vector<ViewPane>& panes,
                     const Interface& interface, const Area& viewport, float scale) {
  draw_split_line(panes, scale);
  draw_methods(compared, state, panes, interface, viewport, scale);
  draw_artefact_ring(compared, panes, scale);
  draw_culling(state, interface, viewport, scale);
  if (compared.lesson)
    lesson_dialog(compared, state, interface, viewport, scale);
  else if (compared.artefact && compared.made)
    artefact_dialog(compared, state, interface, viewport, scale);
}

}  // namespace odontoscope
