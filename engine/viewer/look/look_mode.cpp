#include "engine/viewer/look/look_mode.h"

#include <imgui.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "engine/navigate/moves.h"
#include "engine/navigate/screen.h"
#include "engine/navigate/section_handle.h"
#include "engine/navigate/thickness_colours.h"
#include "engine/scene/fit_visible.h"
#include "engine/ui/dialog.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/fly/on_wall.h"
#include "engine/viewer/look/annotations.h"
#include "engine/viewer/look/look_panel.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

namespace {

constexpr double turn_over_height_deg = 200;  // for a drag as long as the picture is high
constexpr double notch_factor = 1.16, key_factor = 1.2, key_turn_deg = 10, key_pan = 0.08;

BackFaces after(BackFaces mode) {
  switch (mode) {
    case BackFaces::cull:
      return BackFaces::show;
    case BackFaces::show:
      return BackFaces::tint;
    case BackFaces::tint:
      break;
  }
  return BackFaces::cull;
}

}  // namespace

void LookMode::leave() {
  looked_at_.reset();
  section_put_away_.reset();
}

void LookMode::take_requests() {
  if (const auto place = std::exchange(look_at_, {})) lead_to(*place);
}

/// From where one looks now, a few millimetres of the model round the place.
void LookMode::lead_to(const glm::dvec3& place) {
  if (!state_.shown || !at_.modes.effects().from_outside) return;
  constexpr double seen = 0.4;  // half the picture's height, over the radius of the model
  Camera goal = at_.camera_goal();
  goal.position += place - goal.target;
  goal.target = place;
  const double half = half_height_at(goal, depth_of(goal, place)), wanted = seen * state_.shown->model.radius_mm;
  at_.go_to(within_reach(zoom(goal, half / wanted, place), state_.shown->model));
  looked_at_ = place;
}

bool LookMode::perform(Action action) {
  if (!state_.shown) return false;
  Scene& scene = state_.scene;
  const Camera goal = at_.camera_goal();
  const double aspect = at_.front().area.aspect();
  if (const auto view = view_of(action)) {
    at_.go_to(fit_without(hidden_in(scene), *view, state_.shown->model, aspect, goal.projection));
    return true;
  }
  switch (action) {
    case Action::fit:
      at_.go_to(fit_without(hidden_in(scene), goal, state_.shown->model, aspect));
      return true;
    case Action::toggle_projection:
      toggle_projection();
      return true;
    case Action::next_back_faces:
      scene.back_faces = after(scene.back_faces);
      return true;
    case Action::toggle_wire:
      scene.wire = !scene.wire;
      return true;
    case Action::toggle_wall_thickness:
      toggle_wall_thickness();
      return true;
    case Action::toggle_section:
      toggle_section();
      return true;
    case Action::flip_section:
      if (scene.section) scene.section->normal = -scene.section->normal;
      return true;
    default:
      return false;
  }
}

void LookMode::toggle_projection() {
  const Camera goal = at_.camera_goal();
  const bool parallel = goal.projection == Camera::Projection::parallel;
  at_.jump_to(with_projection(goal, parallel ? Camera::Projection::perspective : Camera::Projection::parallel));
  state_.settings.projection = state_.scene.camera.projection;
}

void LookMode::toggle_wall_thickness() {
  if (!tells_thickness(state_.shown->model))
    notice("Of this model no thickness is known: it has no cavity, or one that is open.");
  else
    state_.scene.wall_thickness = !state_.scene.wall_thickness;
}

void LookMode::toggle_section() {
  // The half towards the eye goes: one sees into the other.
  const AnatomicalFrame tooth;
  const glm::dvec3 eye = axes_of(state_.scene.camera).towards_eye;
  glm::dvec3 normal = tooth.buccal;
  for (const glm::dvec3& side : {-tooth.buccal, tooth.mesial, -tooth.mesial})
    if (glm::dot(side, eye) > glm::dot(normal, eye)) normal = side;
  odontoscope::toggle_section(state_.scene.section, section_put_away_,
                              {state_.shown->model.bounds_mm.centre(), normal});
}

bool LookMode::handle_shown() const { return state_.scene.section && at_.modes.effects().section_handle; }

std::optional<int> LookMode::grip_at(const Hover& hover) const {
  if (!handle_shown()) return {};
  const Area& area = hover.pane.area;
  const float scale = at_.layout.scale;
  const auto handle = section_handle(*state_.scene.section, hover.pane.camera, handle_reach(area, scale));
  if (!handle) return {};
  const auto grip = odontoscope::grip_at(*handle, place_in(area, hover.x, hover.y), handle_tolerance(area, scale));
  return grip ? std::optional(static_cast<int>(*grip)) : std::nullopt;
}

std::optional<Drag> LookMode::press(const Press& press) {
  const glm::dvec3 anchor = at_.anchor_at(press.pane, press.x, press.y);
  if (press.button != MouseButton::left || press.with.shift)
    return Drag{.move = [this, anchor](const DragMove& drag) {
      at_.set_camera(pan(state_.scene.camera, drag.from, drag.to, anchor));
    }};
  if (const auto part = grip_at({press.pane, press.x, press.y})) {
    const auto move = [this, grip = static_cast<SectionGrip>(*part)](const DragMove& drag) {
      auto& section = state_.scene.section;
      if (section)
        section = dragged(*section, grip, state_.scene.camera, handle_reach(drag.pane.area, at_.layout.scale),
                          drag.from, drag.to, state_.shown->model);
    };
    return Drag{.move = move, .may_be_click = false, .grip = Grip{this, *part}};
  }
  return Drag{.move = [this](const DragMove& drag) {
    const glm::dvec2 degrees = 0.5 * turn_over_height_deg * (drag.to - drag.from);
    const Camera camera = state_.scene.camera;
    at_.set_camera(orbit(camera, {degrees.x, -degrees.y, camera.target}));
  }};
}

bool LookMode::click(const Click& click) {
  if (!click.second) return false;
  if (const auto hit = at_.hit_at(click.pane, click.x, click.y))
    at_.go_to(centred_on(state_.scene.camera, hit->point_mm));
  return true;
}

bool LookMode::handle(const Event& event) {
  if (!state_.shown) return false;
  if (const auto* wheel = std::get_if<Scrolled>(&event)) {
    scroll(wheel->along);
    return true;
  }
  if (const auto* key = std::get_if<KeyChanged>(&event)) return on_arrow(*key);
  const auto* text = std::get_if<TextTyped>(&event);
  return text && on_letter(text->character);
}

void LookMode::scroll(double notches) {
  const Pointing& hand = at_.pointing;
  const glm::dvec3 anchor = at_.anchor_at(*at_.pane_at(hand.x, hand.y), hand.x, hand.y);
  at_.set_camera(zoom(state_.scene.camera, std::pow(notch_factor, notches), anchor));
}

bool LookMode::on_arrow(const KeyChanged& key) {
  if (!key.down || at_.interface.wants_text() || !at_.modes.effects().from_outside) return false;
  glm::dvec2 direction{0};
  if (key.key == Key::left)
    direction = {-1, 0};
  else if (key.key == Key::right)
    direction = {1, 0};
  else if (key.key == Key::up)
    direction = {0, 1};
  else if (key.key == Key::down)
    direction = {0, -1};
  else
    return false;
  const Camera& camera = state_.scene.camera;
  if (key.with.shift)
    at_.set_camera(pan(camera, {0, 0}, key_pan * direction, camera.target));
  else
    at_.set_camera(orbit(camera, {key_turn_deg * direction.x, -key_turn_deg * direction.y, camera.target}));
  return true;
}

bool LookMode::on_letter(char32_t character) {
  const bool nearer = character == U'+' || character == U'=';
  if (!nearer && character != U'-') return false;
  const Camera& camera = state_.scene.camera;
  at_.set_camera(zoom(camera, nearer ? key_factor : 1 / key_factor, camera.target));
  return true;
}

bool LookMode::put_away(PutAway what) {
  if (what != PutAway::mark || !looked_at_) return false;
  looked_at_.reset();
  return true;
}

void LookMode::draw(DrawLayer layer, const DrawnPane& drawn) {
  const ViewPane& pane = drawn.pane;
  const float scale = at_.layout.scale;
  const bool from_outside = at_.modes.effects().from_outside;
  if (layer == DrawLayer::marks && drawn.first && from_outside)  // in a canal, nothing lies at one depth
    draw_scale_bar(pane, at_.interface, scale);
  if (layer == DrawLayer::marks && drawn.first) draw_thickness_legend(pane, state_, at_.interface, scale);
  if (layer != DrawLayer::front) return;
  if (looked_at_) draw_place(pane, *looked_at_, scale);
  if (drawn.last) {  // cameras are linked: one of each will do
    draw_readout(pane, at_.pointing, state_, at_.modes.click_hint(), at_.interface, scale);
    draw_compass(pane, at_.interface, scale, at_.pointing.compass, !from_outside);
  }
  if (drawn.again || !handle_shown()) return;
  const auto& held = at_.pointing.held;
  const auto grip = held && held->drag.grip ? held->drag.grip : at_.pointing.grip;
  const bool lit = grip && grip->of == this;
  draw_section_handle(pane, *state_.scene.section, scale,
                      lit ? std::optional(static_cast<SectionGrip>(grip->part)) : std::nullopt);
}

bool LookMode::draw_dialog() {
  if (state_.shown) return false;
  const Dialog dialog("empty", at_.layout.viewport, 420);
  dialog_title(at_.interface, "Nothing to look at yet");
  widgets::remark(at_.interface, "Drop a contour stack, a mesh or a volume here.");
  if (widgets::wide_button("Show the sample molar", widgets::Emphasis::strong)) state_.to_load = LoadRequest{};
  if (widgets::wide_button("Open\xE2\x80\xA6")) state_.pending_actions.push_back(Action::open_file);
  return true;
}

std::vector<PanelSection> LookMode::panel() {
  const bool good = mark_of(state_.shown->certificate.verdict) == Certificate::Mark::good;
  const auto report = [this] {
    if (const auto place = report_section(*state_.shown, at_.interface)) look_at(*place);
  };
  const auto structures = [this] { structures_section(state_, at_.modes.effects().remember_looks, at_.interface); };
  return {{good ? SectionPlace::report : SectionPlace::faults, report},
          {SectionPlace::structures, structures},
          {SectionPlace::section, [this] { section_section(state_, at_.interface); }},
          {SectionPlace::view, [this] { camera_section(state_, at_.interface); }},
          {SectionPlace::faces, [this] { faces_section(state_, at_.interface); }},
          {SectionPlace::overlays, [this] { overlays_section(state_, at_.interface); }}};
}

}  // namespace odontoscope
