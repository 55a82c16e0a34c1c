#include "engine/ui/annotations.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/measure/film_length.h"
#include "engine/navigate/ride.h"
#include "engine/ui/drawing.h"
#include "engine/ui/theme.h"

namespace odontoscope {

namespace {

constexpr double compass_radius = 44, compass_margin = 84, dot_radius = 9;  // interface pixels

struct CompassPoint {
  const char* letter;
  const char* name;
  Action action;
  glm::dvec3 direction;
};

const std::array<CompassPoint, 6>& compass_points() {
  static const AnatomicalFrame tooth;
  static const std::array<CompassPoint, 6> points = {{{"B", "buccal", Action::view_buccal, tooth.buccal},
                                                      {"L", "lingual", Action::view_lingual, -tooth.buccal},
                                                      {"M", "mesial", Action::view_mesial, tooth.mesial},
                                                      {"D", "distal", Action::view_distal, -tooth.mesial},
                                                      {"O", "occlusal", Action::view_occlusal, tooth.occlusal},
                                                      {"A", "apical", Action::view_apical, -tooth.occlusal}}};
  return points;
}

struct PlacedPoint {
  const CompassPoint* point;
  double x, y, depth;  // pixels; towards the eye is positive
};

/// Farthest first.
std::array<PlacedPoint, 6> placed(const ViewPane& pane, float scale) {
  const CameraAxes axes = axes_of(pane.camera);
  const double x = pane.area.left + pane.area.width - scale * compass_margin,
               y = pane.area.top + scale * compass_margin;
  std::array<PlacedPoint, 6> all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const CompassPoint& point = compass_points()[i];
    all[i] = {&point, x + scale * compass_radius * glm::dot(point.direction, axes.right),
              y - scale * compass_radius * glm::dot(point.direction, axes.up),
              glm::dot(point.direction, axes.towards_eye)};
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const PlacedPoint& a, const PlacedPoint& b) { return a.depth < b.depth; });
  return all;
}

/// Words that can be read on any ground.
void outlined(ImDrawList& list, ImFont* font, float size, const ImVec2& place, ImU32 colour, const char* words) {
  for (const auto& [dx, dy] : {std::pair{-1.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, -1.0f}, {0.0f, 1.0f}})
    list.AddText(font, size, {place.x + dx, place.y + dy}, theme::mark_outline, words);
  list.AddText(font, size, place, colour, words);
}

}  // namespace

glm::dvec2 place_in(const Area& area, double x, double y) {
  const double half = area.height / 2;
  return {(x - area.left - area.width / 2) / half, (area.top + half - y) / half};
}

glm::dvec2 pixel_of(const Area& area, const glm::dvec2& place) {
  const double half = area.height / 2;
  return {area.left + area.width / 2 + half * place.x, area.top + half - half * place.y};
}

double handle_reach(const Area& area, float scale) { return 96 * scale / (area.height / 2); }
double handle_tolerance(const Area& area, float scale) { return 14 * scale / (area.height / 2); }

std::optional<Action> compass_hit(const ViewPane& pane, float scale, double x, double y) {
  const auto points = placed(pane, scale);
  for (auto p = points.rbegin(); p != points.rend(); ++p)  // nearest first
    if (std::hypot(x - p->x, y - p->y) <= scale * (dot_radius + 3)) return p->point->action;
  return std::nullopt;
}

void draw_compass(const ViewPane& pane, const Interface& interface, float scale, std::optional<Action> hovered,
                  bool in_flight) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const double x = pane.area.left + pane.area.width - scale * compass_margin,
               y = pane.area.top + scale * compass_margin;
  list.AddCircleFilled(vec(x, y), static_cast<float>(scale * (compass_radius + 20)),
                       theme::rgb(0x14181c, hovered ? 150 : 110), 64);
  std::string words;
  auto points = placed(pane, scale);
  if (in_flight) std::reverse(points.begin(), points.end());  // what lies ahead on top of what lies behind
  for (const PlacedPoint& p : points) {
    const bool lit = hovered == p.point->action, nearest = p.depth > 0.92;
    const double opacity = lit ? 1 : 0.35 + 0.65 * (0.5 + 0.5 * (in_flight ? -p.depth : p.depth));
    const bool positive = p.point->action == Action::view_buccal || p.point->action == Action::view_mesial ||
                          p.point->action == Action::view_occlusal;
    const ImU32 colour = faded(positive ? theme::accent : theme::rgb(0x8fa0ae), opacity);
    list.AddLine(vec(x, y), vec(p.x, p.y), faded(colour, 0.8), 1.6f * scale);
    list.AddCircleFilled(vec(p.x, p.y), static_cast<float>(scale * (lit ? dot_radius + 2 : dot_radius)),
                         lit ? theme::mark : colour, 24);
    const float size = interface.small->FontSize;
    const ImVec2 extent = interface.small->CalcTextSizeA(size, 1e9f, 0, p.point->letter);
    list.AddText(interface.small, size, vec(p.x - extent.x / 2, p.y - extent.y / 2),
                 faded(theme::rgb(0x10151a), std::max(opacity, 0.7)), p.point->letter);
    if (lit || (nearest && !hovered && !in_flight)) words = p.point->name;
    if (in_flight && !hovered && p.depth < -0.92)
      words = std::string("towards ") + p.point->name;  // inside, where one looks matters, not from where
  }
  if (words.empty()) return;
  words = interface.say(words);
  const ImVec2 extent = interface.bold->CalcTextSizeA(interface.bold->FontSize, 1e9f, 0, words.c_str());
  outlined(list, interface.bold, interface.bold->FontSize, vec(x - extent.x / 2, y + scale * (compass_radius + 26)),
           theme::text, words.c_str());
}

ScaleBar scale_bar(const ViewPane& pane, double most_pixels) {
  const double mm_per_pixel =
      half_height_at(pane.camera, depth_of(pane.camera, pane.camera.target)) / (pane.area.height / 2);
  const double most = mm_per_pixel * most_pixels;
  double length = std::pow(10, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0})
    if (factor * length <= most) {
      length *= factor;
      break;
    }
  const std::string words = length >= 1000   ? fmt::format("{:g} m", length / 1000)
                            : length >= 0.01 ? fmt::format("{:g} mm", length)
                                             : fmt::format("{:g} \xCE\xBCm", length * 1000);
  return {length / mm_per_pixel, words};
}

void draw_scale_bar(const ViewPane& pane, const Interface& interface, float scale) {
  const ScaleBar bar = scale_bar(pane, 160 * scale);
  // In perspective what is nearer is larger.
  const std::string words =
      pane.camera.projection == Camera::Projection::perspective ? bar.words + " at the middle" : bar.words;
  const std::string said = interface.say(words);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const double left = pane.area.left + 24 * scale, right = left + bar.pixels,
               y = pane.area.top + pane.area.height - 26 * scale, tick = 5 * scale;
  const std::pair<float, ImU32> strokes[] = {{4.5f * scale, theme::mark_outline}, {2.0f * scale, theme::text}};
  for (const auto& [width, colour] : strokes) {
    list.AddLine(vec(left, y), vec(right, y), colour, width);
    list.AddLine(vec(left, y - tick), vec(left, y + tick), colour, width);
    list.AddLine(vec(right, y - tick), vec(right, y + tick), colour, width);
  }
  outlined(list, interface.bold, interface.bold->FontSize, vec(left + 2 * scale, y - 26 * scale), theme::text,
           said.c_str());
}

void draw_section_handle(const ViewPane& pane, const Section& section, float scale, std::optional<SectionGrip> lit) {
  const auto handle = section_handle(section, pane.camera, handle_reach(pane.area, scale));
  if (!handle) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect(vec(pane.area.left, pane.area.top),
                    vec(pane.area.left + pane.area.width, pane.area.top + pane.area.height));
  std::vector<ImVec2> outline;
  for (const glm::dvec2& place : handle->outline) outline.push_back(vec(pixel_of(pane.area, place)));
  const ImVec2 knob = vec(pixel_of(pane.area, handle->knob)), tip = vec(pixel_of(pane.area, handle->tip));
  const auto colour = [&](SectionGrip grip) { return lit == grip ? theme::text : theme::mark; };
  list.AddPolyline(outline.data(), static_cast<int>(outline.size()), theme::mark_outline, ImDrawFlags_Closed,
                   4 * scale);
  list.AddPolyline(outline.data(), static_cast<int>(outline.size()), faded(theme::mark, 0.85), ImDrawFlags_Closed,
                   1.8f * scale);
  list.AddLine(knob, tip, theme::mark_outline, 5 * scale);
  list.AddLine(knob, tip, faded(theme::mark, handle->tip_faces_eye ? 1 : 0.6), 2.4f * scale);
  for (const auto& [place, grip] : {std::pair{tip, SectionGrip::turn}, {knob, SectionGrip::slide}}) {
    const float radius = (lit == grip ? 10.0f : 8.0f) * scale;
    list.AddCircleFilled(place, radius + 1.6f * scale, theme::mark_outline, 32);
    if (grip == SectionGrip::turn)
      list.AddCircleFilled(place, radius, colour(grip), 32);
    else
      list.AddRectFilled({place.x - 0.8f * radius, place.y - 0.8f * radius},
                         {place.x + 0.8f * radius, place.y + 0.8f * radius}, colour(grip), 2 * scale);
  }
  list.PopClipRect();
}

namespace {

void draw_dot(ImDrawList& list, const ImVec2& place, float scale) {
  list.AddCircleFilled(place, 6.5f * scale, theme::mark_outline, 24);
  list.AddCircleFilled(place, 4.5f * scale, theme::mark, 24);
}

void draw_length(const ViewPane& pane, const glm::dvec3& from, const glm::dvec3& to, const std::string& english,
                 const Interface& interface, float scale) {
  const std::string words = interface.say(english);
  const auto a = place_of(pane.camera, from), b = place_of(pane.camera, to);
  if (!a || !b) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 start = vec(pixel_of(pane.area, *a)), end = vec(pixel_of(pane.area, *b));
  list.AddLine(start, end, theme::mark_outline, 5 * scale);
  list.AddLine(start, end, theme::mark, 2.2f * scale);
  draw_dot(list, start, scale);
  draw_dot(list, end, scale);
  ImFont* font = interface.bold;
  const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, 0, words.c_str());
  const ImVec2 corner((start.x + end.x) / 2 + 12 * scale, (start.y + end.y) / 2 - extent.y / 2);
  list.AddRectFilled({corner.x - 8 * scale, corner.y - 5 * scale},
                     {corner.x + extent.x + 8 * scale, corner.y + extent.y + 5 * scale}, theme::rgb(0x14181c, 225),
                     6 * scale);
  list.AddText(font, font->FontSize, corner, theme::mark, words.c_str());
}

}  // namespace

void draw_place(const ViewPane& pane, const glm::dvec3& place_mm, float scale) {
  const auto place = place_of(pane.camera, place_mm);
  if (!place) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect(vec(pane.area.left, pane.area.top),
                    vec(pane.area.left + pane.area.width, pane.area.top + pane.area.height));
  const ImVec2 middle = vec(pixel_of(pane.area, *place));
  list.AddCircle(middle, 16 * scale, theme::mark_outline, 48, 5 * scale);
  list.AddCircle(middle, 16 * scale, theme::amber, 48, 2.4f * scale);
  list.PopClipRect();
}

void draw_measured(const ViewPane& pane, const ViewerState& state, const Interface& interface, float scale) {
  const Measured& measured = state.measured;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect(vec(pane.area.left, pane.area.top),
                    vec(pane.area.left + pane.area.width, pane.area.top + pane.area.height));
  if (measured.ends.size() == 2) {
    const std::array ends{measured.ends[0].point_mm, measured.ends[1].point_mm};
    const std::string words =
        state.film() ? fmt::format("{:.2f} mm on the film",
                                   length_on_film(ends, pane.camera, state.shown->model.bounds_mm.centre()))
                     : fmt::format("{:.2f} mm", distance_between_mm(measured.ends[0], measured.ends[1]));
    draw_length(pane, ends[0], ends[1], words, interface, scale);
  } else if (measured.wall_at && measured.wall) {
    draw_length(pane, measured.wall_at->point_mm, measured.wall->opposite_mm,
                fmt::format("{:.2f} mm", measured.wall->along_normal_mm), interface, scale);
  } else if (measured.wall_at || !measured.ends.empty()) {
    const auto place = place_of(pane.camera, measured.wall_at ? measured.wall_at->point_mm : measured.ends[0].point_mm);
    if (place) draw_dot(list, vec(pixel_of(pane.area, *place)), scale);
  }
  list.PopClipRect();
}

std::string name_of(const CanalPick& pick, const FlightSpaces& spaces) {
  return pick.in_chamber ? "pulp chamber" : rideable(spaces.cavities[pick.cavity].lines)[pick.line]->name;
}

void draw_canal(const ViewPane& pane, const ViewerState& state, const Interface& interface, float scale) {
  if (!state.canal) return;
  const CanalPick& pick = *state.canal;
  const FlightSpaces& spaces = *state.shown->flight;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect(vec(pane.area.left, pane.area.top),
                    vec(pane.area.left + pane.area.width, pane.area.top + pane.area.height));
  if (!pick.in_chamber) {
    std::vector<ImVec2> line;
    for (const CentrePoint& point : rideable(spaces.cavities[pick.cavity].lines)[pick.line]->points)
      if (const auto place = place_of(pane.camera, {point.at.x, point.at.y, point.at.z}))
        line.push_back(vec(pixel_of(pane.area, *place)));
    list.AddPolyline(line.data(), static_cast<int>(line.size()), theme::mark_outline, 0, 4.5f * scale);
    list.AddPolyline(line.data(), static_cast<int>(line.size()), theme::mark, 0, 2.2f * scale);
  }
  if (const auto place = place_of(pane.camera, pick.at)) {
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
  list.PopClipRect();
}

void draw_readout(const ViewPane& pane, const ViewerState& state, const Interface& interface, float scale) {
  std::string words;
  if (const auto& hit = state.under_pointer) {
    const glm::dvec3& p = hit->point_mm;
    words =
        fmt::format("{}{}   {:.2f}  {:.2f}  {:.2f} mm", hit->structure, hit->triangle ? "" : ", cut", p.x, p.y, p.z);
  }
  if (const auto& canal = state.canal_under_pointer)
    words = fmt::format("{}   {}", name_of(*canal, *state.shown->flight), words);
  words = interface.say(words);
  ImFont* font = interface.small;
  const double right = pane.area.left + pane.area.width - 20 * scale,
               bottom = pane.area.top + pane.area.height - 34 * scale;
  const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, 0, words.c_str());
  outlined(*ImGui::GetBackgroundDrawList(), font, font->FontSize, vec(right - extent.x, bottom), theme::text,
           words.c_str());
  if (state.tool == Tool::look) return;
  const bool second = state.tool == Tool::distance && state.measured.ends.size() == 1;
  const char* asked = state.tool == Tool::thickness
                          ? "Click a surface to measure the wall behind it. Enter: at the cross"
                      : second ? "Click the second point. Enter: at the cross"
                               : "Click the first point. Enter: at the cross";
  const std::string said = interface.say(asked);
  const char* told = said.c_str();
  font = interface.bold;
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e9f, 0, told);
  const ImVec2 corner = vec(pane.area.left + (pane.area.width - size.x) / 2, pane.area.top + 22 * scale);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 middle = vec(pane.area.left + pane.area.width / 2, pane.area.top + pane.area.height / 2);
  for (const float thick : {4.0f, 1.6f})
    for (const ImVec2& arm : {ImVec2(9 * scale, 0), ImVec2(0, 9 * scale)})
      list.AddLine({middle.x - arm.x, middle.y - arm.y}, {middle.x + arm.x, middle.y + arm.y},
                   thick > 2 ? theme::mark_outline : theme::mark, thick * scale);
  list.AddRectFilled({corner.x - 14 * scale, corner.y - 8 * scale},
                     {corner.x + size.x + 14 * scale, corner.y + size.y + 8 * scale}, theme::rgb(0x14181c, 225),
                     8 * scale);
  list.AddText(font, font->FontSize, corner, theme::mark, told);
}

}  // namespace odontoscope
