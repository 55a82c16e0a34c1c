#include "engine/viewer/fly/fly_annotations.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/navigate/screen.h"
#include "engine/ui/drawing.h"
#include "engine/ui/theme.h"
#include "engine/viewer/fly/inset.h"
#include "engine/viewer/fly/on_wall.h"

namespace odontoscope {

/// Clear in the middle, dark at the rim, by rings of triangles whose corners are shaded.
void draw_vignette(const Area& viewport, double strength) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  constexpr int around = 48;
  const double x = viewport.left + viewport.width / 2, y = viewport.top + viewport.height / 2;
  const double outer = 0.5 * std::hypot(viewport.width, viewport.height), inner = outer * (0.80 - 0.42 * strength);
  const auto rim =
                 theme::rgb(0x000000, static_cast<unsigned>(std::lround(255 * std::clamp(1.25 * strength, 0.0, 1.0)))),
             clear = theme::rgb(0x000000, 0);
  const ImVec2 white = ImGui::GetDrawListSharedData() ? ImGui::GetFontTexUvWhitePixel() : ImVec2(0, 0);
  list.PushClipRect(vec(viewport.left, viewport.top),
                    vec(viewport.left + viewport.width, viewport.top + viewport.height));
  list.PrimReserve(6 * around, 2 * around);
  const unsigned first = list._VtxCurrentIdx;
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * i / around;
    list.PrimWriteVtx(vec(x + inner * std::cos(angle), y + inner * std::sin(angle)), white, clear);
    list.PrimWriteVtx(vec(x + 1.02 * outer * std::cos(angle), y + 1.02 * outer * std::sin(angle)), white, rim);
  }
  for (unsigned i = 0; i < around; ++i) {
    const unsigned a = first + 2 * i, b = first + 2 * ((i + 1) % around);
    for (const unsigned corner : {a, a + 1, b, b, a + 1, b + 1}) list.PrimWriteIdx(static_cast<ImDrawIdx>(corner));
  }
  list.PopClipRect();
}

namespace {

constexpr double slice_height = 150;  // interface pixels

/// A label as it is drawn: a pill of words beside its place.
struct DrawnLabel {
  const FlightLabel* label;
  ImVec2 dot, low, high;
  double opacity;
};

bool overlap(const Area& a, const Area& b) {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height && b.top < a.top + a.height;
}

bool within(const Area& box, const Area& whole) {
  return box.left >= whole.left && box.top >= whole.top && box.left + box.width <= whole.left + whole.width &&
         box.top + box.height <= whole.top + whole.height;
}

/// Nearest first, beside their places at the right, or where there is no room at the left; one that would lie over
/// another or over the small pictures is left out.
std::vector<DrawnLabel> drawn_labels(const FlyState& fly, const ViewerState& state, const ViewPane& pane,
                                     const Interface& interface, float scale) {
  const FlightSpaces& spaces = *state.shown->flight;
  const Walls& walls = fly.cavity ? spaces.cavities[*fly.cavity].walls : spaces.outside;
  const double slack = (fly.cavity ? 3 : 6) * spaces.rules.clearance, far = 1.2 * state.shown->model.radius_mm;
  Area pictures = fly.habits.inset ? inset_area(pane, scale) : Area{};
  const double slice = pictures.width > 0 ? slice_height * scale + 8 * scale : 0;
  pictures.top -= slice;
  pictures.height += slice;
  const double beside_compass = 176 * scale;
  const Area compass{pane.area.left + pane.area.width - beside_compass, pane.area.top, beside_compass, beside_compass};
  const double farthest_depth = 0.5 * state.shown->model.radius_mm;  // beyond, numbers would crowd
  const WallNumber on_wall = told_on_wall(state.settings.comfort);
  std::vector<DrawnLabel> drawn;
  for (const SeenLabel& seen : seen_labels(fly.labels, pane.camera, pane.area.aspect(), walls, slack)) {
    const FlightLabel& label = fly.labels[seen.label];
    const bool number = label.number != WallNumber::none;
    if (number && (label.number != on_wall || seen.distance > farthest_depth)) continue;
    const glm::dvec2 at = pixel_of(pane.area, seen.place);
    const ImFont* font = number ? interface.small : interface.bold;
    const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, 0, interface.say(label.words).c_str());
    const float width = extent.x + (number ? 10 : 18) * scale, height = extent.y + (number ? 4 : 10) * scale;
    const ImVec2 right = vec(at.x + 12 * scale, at.y - height / 2), left{right.x - 24 * scale - width, right.y};
    const auto fits = [&](const ImVec2& low) {
      const Area box{low.x, low.y, width, height};
      const auto over = [&](const DrawnLabel& other) {
        return overlap(box, {other.low.x, other.low.y, other.high.x - other.low.x, other.high.y - other.low.y});
      };
      return within(box, pane.area) && !overlap(box, pictures) && !overlap(box, compass) &&
             std::none_of(drawn.begin(), drawn.end(), over);
    };
    if (!fits(right) && !fits(left)) continue;
    const ImVec2 low = fits(right) ? right : left;
    drawn.push_back({&label,
                     vec(at.x, at.y),
                     low,
                     {low.x + width, low.y + height},
                     std::clamp(1.15 - 0.6 * seen.distance / far, 0.45, 1.0)});
  }
  return drawn;
}

void draw_labels(const FlyState& fly, const ViewerState& state, const ViewPane& pane, const Interface& interface,
                 float scale) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const auto drawn = drawn_labels(fly, state, pane, interface, scale);
  for (auto label = drawn.rbegin(); label != drawn.rend(); ++label) {
    if (label->label->number != WallNumber::none) {
      list.AddRectFilled(label->low, label->high, faded(theme::rgb(0x14181c, 150), label->opacity), 4 * scale);
      list.AddText(interface.small, interface.small->FontSize, {label->low.x + 5 * scale, label->low.y + 2 * scale},
                   faded(theme::text, label->opacity), interface.say(label->label->words).c_str());
      continue;
    }
    const bool rides = label->label->line.has_value();
    const ImU32 ground = theme::rgb(0x14181c, 205), ink = rides ? theme::mark : theme::text;
    const float side = label->low.x > label->dot.x ? label->low.x + 2 * scale : label->high.x - 2 * scale;
    list.AddLine(label->dot, {side, (label->low.y + label->high.y) / 2}, faded(ink, label->opacity), 1.4f * scale);
    list.AddCircleFilled(label->dot, 5.0f * scale, faded(theme::mark_outline, label->opacity), 20);
    list.AddCircleFilled(label->dot, 3.4f * scale, faded(ink, label->opacity), 20);
    list.AddRectFilled(label->low, label->high, faded(ground, label->opacity), 6 * scale);
    list.AddText(interface.bold, interface.bold->FontSize, {label->low.x + 9 * scale, label->low.y + 5 * scale},
                 faded(ink, label->opacity), interface.say(label->label->words).c_str());
  }
}

/// The buttons that matter now, for who has the gamepad in hand.
std::string gamepad_hint(const FlyState& fly) {
  if (!fly.cavity) return "A: into the pulp   X: through the wall   B: back   Start: all buttons";
  const char* ride = fly.ride && fly.ride->playing ? "stop" : fly.ride ? "go on" : "ride";
  return fmt::format("A: {}   Y: next canal   X: through the wall   B: back to outside   Start: all buttons", ride);
}

/// Breadcrumb and figures, at the upper left of the picture.
void draw_words(const FlyState& fly, const ViewerState& state, const ViewPane& pane, const Interface& interface,
                float scale) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const std::string where = interface.say(where_in_words(fly, state)),
                    measured = interface.say(measured_in_words(fly, state)),
                    pad = interface.say(state.pad_in_hand ? gamepad_hint(fly) : "");
  const float wrap =
      std::max(120.0f * scale, static_cast<float>(pane.area.width) - 200 * scale);  // the compass is at the right
  const ImVec2 first = interface.bold->CalcTextSizeA(interface.bold->FontSize, 1e9f, wrap, where.c_str());
  const ImVec2 second = measured.empty()
                            ? ImVec2(0, 0)
                            : interface.small->CalcTextSizeA(interface.small->FontSize, 1e9f, wrap, measured.c_str());
  const ImVec2 third =
      pad.empty() ? ImVec2(0, 0) : interface.small->CalcTextSizeA(interface.small->FontSize, 1e9f, wrap, pad.c_str());
  const ImVec2 low = vec(pane.area.left + 16 * scale, pane.area.top + 16 * scale);
  const ImVec2 high{low.x + std::max({first.x, second.x, third.x}) + 24 * scale,
                    low.y + first.y + second.y + third.y +
                        static_cast<float>(14 + (measured.empty() ? 0 : 4) + (pad.empty() ? 0 : 4)) * scale};
  list.AddRectFilled(low, high, theme::rgb(0x14181c, 190), 8 * scale);
  list.AddText(interface.bold, interface.bold->FontSize, {low.x + 12 * scale, low.y + 7 * scale}, theme::text,
               where.c_str(), nullptr, wrap);
  const ImVec2 below{low.x + 12 * scale, low.y + first.y + 11 * scale};
  if (!measured.empty())
    list.AddText(interface.small, interface.small->FontSize, below, theme::mark, measured.c_str(), nullptr, wrap);
  if (!pad.empty())
    list.AddText(interface.small, interface.small->FontSize, {low.x + 12 * scale, high.y - third.y - 7 * scale},
                 theme::text, pad.c_str(), nullptr, wrap);
}

/// Where the eye is in the small picture, where it looks, and how it came there.
void draw_inset(const FlyState& fly, const ViewerState& state, const ViewPane& pane, const Interface& interface,
                float scale) {
  const Area area = inset_area(pane, scale);
  if (area.width < 1) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const Camera camera = inset_camera(state.shown->model, fly.habits.inset_from, area);
  const auto pixel = [&](const glm::dvec3& place) {
    const auto at = place_of(camera, place);
    const glm::dvec2 p = pixel_of(area, at.value_or(glm::dvec2(0)));
    return vec(p.x, p.y);
  };
  const ImVec2 low = vec(area.left, area.top), high = vec(area.left + area.width, area.top + area.height);
  list.AddRect(low, high, theme::line, 0, 0, 1.5f * scale);
  list.PushClipRect(low, high);
  if (fly.cavity) {
    for (const CentreLine* line : rideable(state.shown->flight->cavities[*fly.cavity].lines)) {
      std::vector<ImVec2> points;
      for (const CentrePoint& point : line->points) points.push_back(pixel({point.at.x, point.at.y, point.at.z}));
      list.AddPolyline(points.data(), static_cast<int>(points.size()), faded(theme::accent, 0.55), 0, 1.2f * scale);
    }
  }
  std::vector<ImVec2> trail;
  for (const glm::dvec3& place : fly.trail) trail.push_back(pixel(place));
  trail.push_back(pixel(fly.flight.eye));
  list.AddPolyline(trail.data(), static_cast<int>(trail.size()), faded(theme::mark, 0.8), 0, 1.8f * scale);
  const CameraAxes axes = axes_of(camera);
  const glm::dvec2 ahead(glm::dot(fly.flight.view_direction, axes.right),
                         -glm::dot(fly.flight.view_direction, axes.up));
  const ImVec2 eye = pixel(fly.flight.eye);
  const float reach = 24 * scale;
  const ImVec2 tip{eye.x + static_cast<float>(ahead.x) * reach, eye.y + static_cast<float>(ahead.y) * reach};
  list.AddLine(eye, tip, theme::mark_outline, 5 * scale);
  list.AddLine(eye, tip, theme::mark, 2.6f * scale);
  list.AddCircleFilled(eye, 6.5f * scale, theme::mark_outline, 24);
  list.AddCircleFilled(eye, 4.8f * scale, theme::mark, 24);
  list.PopClipRect();
  const std::string from = interface.say(std::string("from ") + name(fly.habits.inset_from) + "   V: another side");
  list.AddText(interface.small, interface.small->FontSize, {low.x + 8 * scale, low.y + 5 * scale}, theme::quiet,
               from.c_str());
}

/// The slice at the eye's height with its contours, seen from occlusal, and the eye in it.
void draw_slice(const FlyState& fly, const ViewerState& state, const ViewPane& pane, const Interface& interface,
                float scale) {
  const std::vector<Slice>& slices = state.shown->overlays.contours.slices;
  const Area below = inset_area(pane, scale);
  if (slices.empty() || below.width < 1) return;
  const Area area{below.left, below.top - slice_height * scale - 8 * scale, below.width, slice_height * scale};
  if (area.top < pane.area.top + 170 * scale) return;  // the compass is there
  const glm::dvec3 eye = fly.flight.eye;
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < slices.size(); ++i)
    if (std::abs(slices[i].z - eye.z) < std::abs(slices[nearest].z - eye.z)) nearest = i;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 low = vec(area.left, area.top), high = vec(area.left + area.width, area.top + area.height);
  list.AddRectFilled(low, high, theme::rgb(0x14181c, 235));
  list.AddRect(low, high, theme::line, 0, 0, 1.5f * scale);
  const Box& bounds = state.shown->model.bounds_mm;
  const glm::dvec3 middle = bounds.centre(), extent = bounds.high - bounds.low;
  const double per_mm = 0.86 * std::min(area.width / extent.x, (area.height - 18 * scale) / extent.y);
  // As in the file: x to the right, y, towards buccal, up.
  const auto pixel = [&](double x, double y) {
    return vec(area.left + area.width / 2 + per_mm * (x - middle.x),
               area.top + 9 * scale + area.height / 2 - per_mm * (y - middle.y));
  };
  list.PushClipRect(low, high);
  for (const Contour& contour : slices[nearest].contours) {
    std::vector<ImVec2> points;
    for (const Point2& point : contour.points) points.push_back(pixel(point.x, point.y));
    const Look* look = fly.scene_before.look_of(contour.structure);
    const Colour colour = look ? look->colour : usual_colour(contour.structure, 0);
    const auto byte = [](float value) {
      return static_cast<unsigned>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
    };
    const ImU32 ink = theme::rgb(byte(colour.red) << 16 | byte(colour.green) << 8 | byte(colour.blue));
    list.AddPolyline(points.data(), static_cast<int>(points.size()), ink, ImDrawFlags_Closed, 1.5f * scale);
  }
  const ImVec2 at = pixel(eye.x, eye.y);
  const ImVec2 tip{at.x + static_cast<float>(fly.flight.view_direction.x) * 18 * scale,
                   at.y - static_cast<float>(fly.flight.view_direction.y) * 18 * scale};
  list.AddLine(at, tip, theme::mark, 2.2f * scale);
  list.AddCircleFilled(at, 5.5f * scale, theme::mark_outline, 24);
  list.AddCircleFilled(at, 4 * scale, theme::mark, 24);
  list.PopClipRect();
  const std::string words =
      interface.say(fmt::format("slice {} of {}, z {:.2f} mm", nearest + 1, slices.size(), slices[nearest].z));
  list.AddText(interface.small, interface.small->FontSize, {low.x + 8 * scale, low.y + 5 * scale}, theme::quiet,
               words.c_str());
}

constexpr const char* then = " \xE2\x86\x92 ";

}  // namespace

std::string where_in_words(const std::string& title, const FlightSpace& space, const std::optional<CanalPlace>& place) {
  std::string words = title;
  if (!place) return words + then + space.structure;
  const CentreLine& line = *rideable(space.lines)[place->line];
  const bool in_chamber = space.lines.has_chamber && place->depth < 0;
  if (space.lines.has_chamber) words += std::string(then) + "pulp chamber";
  return in_chamber ? words : words + then + line.name;
}

std::string where_in_words(const FlyState& fly, const ViewerState& state) {
  if (!fly.cavity) return state.shown->title + then + "outside";
  return where_in_words(state.shown->title, state.shown->flight->cavities[*fly.cavity], fly.place);
}

std::string measured_in_words(const FlightSpace& space, const CanalPlace& place) {
  const bool canal = place.line < space.lines.canals.size();
  const std::string& name = rideable(space.lines)[place.line]->name;
  if (space.lines.has_chamber && place.depth < 0)
    return canal ? fmt::format("{:.2f} mm wide here; {:.2f} mm to the orifice of {}", place.width, -place.depth, name)
                 : fmt::format("{:.2f} mm wide here", place.width);
  return fmt::format("{:.2f} mm {}; {:.2f} mm wide here; {:.2f} mm to the {}", place.depth,
                     canal ? "past the orifice" : "from its start", place.width, place.to_end, canal ? "apex" : "end");
}

std::string measured_in_words(const FlyState& fly, const ViewerState& state) {
  return fly.place ? measured_in_words(state.shown->flight->cavities[*fly.cavity], *fly.place) : std::string();
}

std::optional<std::size_t> label_hit(const FlyState& fly, const ViewerState& state, const ViewPane& pane,
                                     const Interface& interface, float scale, double x, double y) {
  if (!fly.habits.labels) return std::nullopt;
  for (const DrawnLabel& drawn : drawn_labels(fly, state, pane, interface, scale))
    if (drawn.label->line && x >= std::min(drawn.dot.x - 8 * scale, drawn.low.x) &&
        x <= std::max(drawn.dot.x + 8 * scale, drawn.high.x) && y >= drawn.low.y && y <= drawn.high.y)
      return drawn.label->line;
  return std::nullopt;
}

void draw_flight(const FlyState& fly, const ViewerState& state, const ViewPane& pane, const Interface& interface,
                 float scale) {
  if (fly.habits.labels) draw_labels(fly, state, pane, interface, scale);
  draw_words(fly, state, pane, interface, scale);
  if (!fly.habits.inset) return;
  draw_inset(fly, state, pane, interface, scale);
  draw_slice(fly, state, pane, interface, scale);
}

}  // namespace odontoscope
