#include "engine/headset_viewer/headset_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "engine/measure/wall_thickness.h"
#include "engine/navigate/ride.h"
#include "engine/navigate/thickness_colours.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/fly/fly_annotations.h"
#include "engine/viewer/fly/on_wall.h"

namespace odontoscope {

namespace {

using widgets::scaled;

void ask(Visit& visit, VisitAction action) { visit.pending_actions.push_back(action); }

void button(Visit& visit, const char* words, VisitAction action, widgets::Emphasis emphasis = widgets::Emphasis::none) {
  if (widgets::wide_button(words, emphasis)) ask(visit, action);
}

void two_buttons(Visit& visit, const char* left, VisitAction on_left, const char* right, VisitAction on_right) {
  if (!ImGui::BeginTable("two", 2)) return;
  ImGui::TableNextColumn();
  button(visit, left, on_left);
  ImGui::TableNextColumn();
  button(visit, right, on_right);
  ImGui::EndTable();
}

/// Words in the panel's own size: what is small on a desk cannot be read here.
void say(const std::string& words) {
  ImGui::PushStyleColor(ImGuiCol_Text, theme::quiet);
  widgets::wrapped(words);
  ImGui::PopStyleColor();
}

void structures(Visit& visit) {
  for (Look& look : visit.scene.looks) {
    ImGui::PushID(look.structure.c_str());
    widgets::eye("eye", look.visible);
    ImGui::SameLine(0, scaled(8));
    ImGui::BeginGroup();
    double percent = 100.0 * look.opacity;
    if (widgets::slider(look.structure.c_str(), percent, 0, 100, "%.0f %%"))
      look.opacity = static_cast<float>(percent / 100);
    ImGui::EndGroup();
    ImGui::PopID();
  }
}

void section_rows(Visit& visit) {
  bool on = visit.scene.section.has_value();
  if (widgets::toggle("Cut it open", on)) ask(visit, VisitAction::toggle_section);
  if (visit.scene.section) button(visit, "Cut away the other side", VisitAction::flip_section);
}

void grey_values(Visit& visit) {
  int shows = static_cast<int>(visit.scene.volume.shows);
  if (widgets::choice("volume shows", shows, {"Surfaces", "Volume", "Both"}))
    show_as(static_cast<VolumeLook::Shows>(shows), visit.scene);
}

void outside(Visit& visit, const VisitWorld& world, const HeadsetPanelWords& words, const Interface& interface) {
  if (!words.certificate.empty()) widgets::marked(interface, words.mark, words.certificate);
  structures(visit);
  int method = visit.chosen.db ? 1 : 0;
  if (words.db_possible && widgets::choice("method", method, {"DT", "DB"}))
    ask(visit, method == 1 ? VisitAction::show_db : VisitAction::show_dt);
  if (words.db_possible && visit.chosen.db && !words.db.empty()) say(words.db);
  if (words.volume_possible) grey_values(visit);
  int faces = static_cast<int>(visit.scene.back_faces);
  if (widgets::choice("back faces", faces, {"Cull", "Two-sided", "Tint"}))
    visit.scene.back_faces = static_cast<BackFaces>(faces);
  section_rows(visit);
  if (tells_thickness(world.model)) widgets::toggle("Thickness of the wall", visit.scene.wall_thickness);
  if (visit.scene.wall_thickness) say(thickness_in_words(world.model));
  button(visit, visit.stage.magnification == 1 ? "Enlarge it" : "True size", VisitAction::change_size);
  if (!world.cavities.empty()) button(visit, "Go inside", VisitAction::enter, widgets::Emphasis::strong);
}

/// What walls tell, and what colours of thickness mean.
void on_wall(Visit& visit, const Model& model) {
  if (!tells_thickness(model)) {
    bool depth = visit.chosen.on_wall == WallNumber::depth;
    if (widgets::toggle("Depth on the walls", depth))
      visit.chosen.on_wall = depth ? WallNumber::depth : WallNumber::none;
    return;
  }
  say("On the walls");
  int chosen = static_cast<int>(visit.chosen.on_wall);
  if (widgets::choice("on the wall", chosen, {"Nothing", "Depth", "Thickness"}))
    visit.chosen.on_wall = static_cast<WallNumber>(chosen);
  if (visit.chosen.on_wall == WallNumber::thickness) say(thickness_in_words(model));
}

void where(Visit& visit, const VisitWorld& world, const HeadsetPanelWords& words) {
  const FlightSpace& space = world.cavities[*visit.cavity];
  const std::optional<CanalPlace> place = canal_place(space.lines, visit.eye_mm);
  widgets::wrapped(where_in_words(words.title, space, place));
  if (place) say(measured_in_words(space, *place));
  say(fmt::format("Everything is {:.0f} times enlarged.", visit.stage.magnification));
  widgets::toggle("Names", visit.chosen.labels);
  on_wall(visit, world.model);
  int travel = static_cast<int>(visit.chosen.travel);
  say("The trigger");
  if (widgets::choice("travel", travel, {"glides there", "leaps there"}))
    visit.chosen.travel = static_cast<Travel>(travel);
}

/// The ride's controls, and every line that one can be led along.
void canals(Visit& visit, const VisitWorld& world) {
  if (world.cavities.empty()) {
    say("This model has no cavity to be led through.");
    return;
  }
  const FlightSpace& space = world.cavities[visit.cavity.value_or(0)];
  const auto lines = rideable(space.lines);
  if (visit.tour.ride) {
    const Ride& tour = *visit.tour.ride;
    widgets::text(lines[tour.line]->name);
    ImGui::ProgressBar(static_cast<float>((tour.along - tour.track.points.front().along) /
                                          (tour.track.points.back().along - tour.track.points.front().along)),
                       {-1, scaled(12)}, "");
    button(visit, tour.playing ? "Stop here" : "Go on", VisitAction::tour_play, widgets::Emphasis::strong);
    two_buttons(visit, tour.back ? "Forwards" : "Backwards", VisitAction::tour_back, "Leave it here",
                VisitAction::end_tour);
    widgets::slider("Pace", visit.tour.speed_factor, 0.1, 1, "%.1f");
  } else {
    say(lines.empty() ? "No centre line was found here." : "Choose one to be led along it.");
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const CentreLine& line = *lines[i];
    const double length = line.length_to_wall();
    if (widgets::wide_button(fmt::format("{}   {:.1f} mm", line.name, length).c_str(),
                             widgets::strong_if(visit.tour.ride && visit.tour.ride->line == i)))
      visit.tour.asked = i;
  }
}

void measure(Visit& visit, const Interface& interface) {
  int tool = static_cast<int>(visit.chosen.tool);
  say("The trigger, on the tooth:");
  if (widgets::choice(
          "tool", tool,
          {visit.cavity ? (visit.chosen.travel == Travel::leap ? "Leaps" : "Glides") : "Enters, names", "Measures"}))
    visit.chosen.tool = static_cast<HandTool>(tool);
  if (visit.chosen.tool == HandTool::distance)
    say("Pull it at one place and at another: the straight way between them.");
  if (visit.marks.ends.size() == 2) {
    ImGui::PushFont(interface.large);
    widgets::text(fmt::format("{:.2f} mm", distance_between_mm(visit.marks.ends[0], visit.marks.ends[1])));
    ImGui::PopFont();
    say(fmt::format("from {} to {}", visit.marks.ends[0].structure, visit.marks.ends[1].structure));
  }
  if (visit.marks.named) say("Pointed at: " + visit.marks.named->structure);
  if (visit.marks.named || !visit.marks.ends.empty()) button(visit, "Forget the marks", VisitAction::forget_marks);
}

void help(Visit& visit) {
  if (visit.cavity) {
    say(visit.tour.ride
            ? "Trigger: stop, go on. Stick: forth, back; right hand: turn.\nMenu: this panel. Menu, held: out again."
        : visit.chosen.travel == Travel::leap
            ? "Trigger: point at a place; let go: you are there.\nStick: turn.\nMenu: this "
              "panel. Menu, held: out again."
            : "Trigger: glide where the hand points.\nStick: ahead, back; right hand: "
              "turn.\nMenu: this panel. Menu, held: out again.");
  } else {
    say("Trigger on the pulp: go in; elsewhere: what is this?\nGrab: carry it, with both hands scale it. Grab this "
        "panel to move it.\nStick: turn it, bring it nearer.\nMenu: this panel. Menu, held: true size.");
  }
  say("Sit or stand as you like; there is no floor. The headset's own recentre puts everything before you again. Not "
      "well? Close your eyes, take it off.");
  button(visit, "Leave the headset", VisitAction::leave_headset);
}

}  // namespace

void draw_headset_panel(Visit& visit, HeadsetPage& page, const VisitWorld& world, const HeadsetPanelWords& words,
                        const Interface& interface, float width, float height) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({width, height});
  ImGui::Begin(
      "room panel", nullptr,
      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove);
  ImGui::PushFont(interface.large);
  widgets::text(words.title);
  ImGui::PopFont();
  int chosen = static_cast<int>(page);
  if (widgets::choice("page", chosen, {visit.cavity ? "Here" : "Tooth", "Canals", "Measure", "Help"}))
    page = static_cast<HeadsetPage>(chosen);
  if (visit.cavity) button(visit, "Out again", VisitAction::leave);  // above what may be longer than the panel
  ImGui::Dummy({0, scaled(2)});
  switch (page) {
    case HeadsetPage::tooth:
      if (visit.cavity)
        where(visit, world, words);
      else
        outside(visit, world, words, interface);
      break;
    case HeadsetPage::canals:
      canals(visit, world);
      break;
    case HeadsetPage::measure:
      measure(visit, interface);
      break;
    case HeadsetPage::help:
      help(visit);
      break;
  }
  ImGui::End();
}

}  // namespace odontoscope
