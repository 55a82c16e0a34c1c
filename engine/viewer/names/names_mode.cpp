#include "engine/viewer/names/names_mode.h"

#include <imgui.h>

#include <algorithm>

#include "engine/navigate/ride.h"
#include "engine/navigate/screen.h"
#include "engine/ui/drawing.h"
#include "engine/ui/theme.h"
#include "engine/viewer/fly/fly_mode.h"
#include "engine/viewer/names/canals.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

bool NamesMode::names_shown() const { return state_.settings.names && state_.shown && at_.modes.effects().names; }

void NamesMode::leave() {
  names_ = {};
  canal_.reset();
}

void NamesMode::model_shown() { names_.places = named_places(state_.shown->model, state_.shown->scene); }

void NamesMode::forget() {
  names_.told.reset();
  canal_.reset();
}

bool NamesMode::perform(Action action) {
  if (!state_.shown) return false;
  if (action == Action::toggle_names) state_.settings.names = !state_.settings.names;
  if (action == Action::enter_here) enter_canal();
  return action == Action::toggle_names || action == Action::enter_here;
}

void NamesMode::enter_canal() {
  if (!canal_) return;
  FlyMode& fly = at_.modes.get<FlyMode>();
  if (canal_->in_chamber)
    fly.dive(canal_->cavity);
  else
    fly.ride_canal(canal_->cavity, canal_->line);
}

bool NamesMode::tell_name(const Click& click) {
  const bool could = names_shown() && &click.pane == &at_.front();
  const auto name =
      could ? name_hit(names_, state_, click.pane, at_.interface, at_.layout.scale, click.x, click.y) : std::nullopt;
  names_.told = name == names_.told ? std::nullopt : name;
  return name.has_value();
}

bool NamesMode::click(const Click& click) {
  if (tell_name(click)) return true;
  canal_ = canal_at(click.pane, click.x, click.y);
  if (!click.second || !canal_ || canal_->in_chamber) return false;
  enter_canal();
  return true;
}

std::optional<CanalPick> NamesMode::canal_at(const ViewPane& pane, double x, double y) const {
  if (!state_.shown || !state_.shown->flight || pane.db || !at_.modes.effects().from_outside) return std::nullopt;
  constexpr float see_through = 0.9f;  // what is more opaque hides the pulp
  const SightLine sight =
      from_before(sight_line(pane.camera, place_in(pane.area, x, y)), pane.camera, state_.shown->model);
  CanalPickOptions options{.slack_mm = canal_slack_mm(pane.camera, pane.area, at_.layout.scale),
                           .section = state_.scene.section};
  if (const auto hit =
          pick(at_.pickable_of(pane), state_.scene, {sight.origin, sight.direction}, {.least_opacity = see_through}))
    options.sight_mm = hit->distance_mm;
  const auto found = pick_canal(*state_.shown->flight, sight, options);
  if (!found) return std::nullopt;
  // What has no wall in the picture cannot be pointed at, unless a section lays the hollow open.
  const Look* look = state_.scene.look_of(state_.shown->flight->cavities[found->cavity].structure);
  const bool drawn = look && look->visible && look->opacity > 0;
  return drawn || state_.scene.section ? found : std::nullopt;
}

bool NamesMode::hover(const Hover& hover) {
  Pointing& pointing = at_.pointing;
  if (!pointing.at_model() || !at_.modes.click_hint().empty() || !at_.modes.effects().from_outside) return false;
  pointing.canal = canal_at(hover.pane, hover.x, hover.y);
  if (pointing.canal && !pointing.canal->in_chamber) pointing.pointer = Pointer::hand;
  return false;
}

bool NamesMode::put_away(PutAway what) {
  if (what != PutAway::step || (!names_.told && !canal_)) return false;
  if (names_.told)
    names_.told.reset();
  else
    canal_.reset();
  return true;
}

namespace {

/// The canal that was clicked: its line over the picture, its name, and how to get in.
void draw_canal(const ViewPane& pane, const CanalPick& pick, const FlightSpaces& spaces, const Interface& interface,
                float scale) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ClipTo clip(list, pane.area);
  if (!pick.in_chamber) {
    std::vector<ImVec2> line;
    for (const CentrePoint& point : rideable(spaces.cavities[pick.cavity].lines)[pick.line]->points)
      if (const auto place = place_of(pane.camera, {point.at.x, point.at.y, point.at.z}))
        line.push_back(vec(pixel_of(pane.area, *place)));
    list.AddPolyline(line.data(), static_cast<int>(line.size()), theme::mark_outline, 0, 4.5f * scale);
    list.AddPolyline(line.data(), static_cast<int>(line.size()), theme::mark, 0, 2.2f * scale);
  }
  const auto place = place_of(pane.camera, pick.at);
  if (!place) return;
  const ImVec2 at = vec(pixel_of(pane.area, *place));
  draw_dot(list, at, scale);
  const std::string name = interface.say(name_of(pick, spaces)),
                    said = interface.say(pick.in_chamber ? "Enter: fly there" : "double click or Enter: ride");
  const char* told = said.c_str();
  const ImFont *font = interface.bold, *small = interface.small;
  const ImVec2 first = font->CalcTextSizeA(font->FontSize, 1e9f, 0, name.c_str()),
               second = small->CalcTextSizeA(small->FontSize, 1e9f, 0, told);
  const float width = std::max(first.x, second.x), height = first.y + second.y;
  const float most = static_cast<float>(pane.area.left + pane.area.width) - width - 14 * scale;
  const ImVec2 corner(at.x + 22 * scale > most ? at.x - 22 * scale - width : at.x + 22 * scale, at.y - height / 2);
  list.AddRectFilled({corner.x - 9 * scale, corner.y - 6 * scale},
                     {corner.x + width + 9 * scale, corner.y + height + 6 * scale}, theme::rgb(0x14181c, 225),
                     6 * scale);
  list.AddText(font, font->FontSize, corner, theme::mark, name.c_str());
  list.AddText(small, small->FontSize, {corner.x, corner.y + first.y}, theme::text, told);
}

}  // namespace

void NamesMode::draw(DrawLayer layer, const DrawnPane& drawn) {
  if (layer != DrawLayer::marks) return;
  const ViewPane& pane = drawn.pane;
  if (names_shown() && drawn.first) draw_names(names_, state_, pane, at_.interface, at_.layout.scale);
  if (canal_ && !pane.db && !drawn.again && at_.modes.effects().from_outside)
    draw_canal(pane, *canal_, *state_.shown->flight, at_.interface, at_.layout.scale);
}

}  // namespace odontoscope
