#include "engine/viewer/look/annotations.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/navigate/screen.h"
#include "engine/ui/drawing.h"
#include "engine/ui/theme.h"
#include "engine/viewer/names/canals.h"

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

}  // namespace

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

void draw_readout(const ViewPane& pane, const Pointing& pointing, const ViewerState& state, const std::string& hint,
                  const Interface& interface, float scale) {
  std::string words;
  if (const auto& hit = pointing.hit) {
    const glm::dvec3& p = hit->point_mm;
    words =
        fmt::format("{}{}   {:.2f}  {:.2f}  {:.2f} mm", hit->structure, hit->triangle ? "" : ", cut", p.x, p.y, p.z);
  }
  if (const auto& canal = pointing.canal) words = fmt::format("{}   {}", name_of(*canal, *state.shown->flight), words);
  words = interface.say(words);
  ImFont* font = interface.small;
  const double right = pane.area.left + pane.area.width - 20 * scale,
               bottom = pane.area.top + pane.area.height - 34 * scale;
  const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, 0, words.c_str());
  outlined(*ImGui::GetBackgroundDrawList(), font, font->FontSize, vec(right - extent.x, bottom), theme::text,
           words.c_str());
  if (hint.empty()) return;
  const std::string said = interface.say(hint);
  const char* told = said.c_str();
  font = interface.bold;
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e9f, 0, told);
  const ImVec2 corner = vec(pane.area.left + (pane.area.width - size.x) / 2, pane.area.top + 22 * scale);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  draw_cross(pane.area, scale);
  list.AddRectFilled({corner.x - 14 * scale, corner.y - 8 * scale},
                     {corner.x + size.x + 14 * scale, corner.y + size.y + 8 * scale}, theme::rgb(0x14181c, 225),
                     8 * scale);
  list.AddText(font, font->FontSize, corner, theme::mark, told);
}

}  // namespace odontoscope
