#include "engine/viewer/names/structure_labels.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/navigate/screen.h"
#include "engine/ui/drawing.h"
#include "engine/ui/theme.h"
#include "recon/core/lower_case.h"

namespace odontoscope {

namespace {

constexpr std::size_t most_places = 160;
constexpr std::array levels = {0.72, 0.3, 0.62,
                               0.5,  0.2, 0.85};        // how high each structure's place lies, in its own height
constexpr double level_spread = 0.12, near_cut = 0.04;  // of the structure's, of the model's height
constexpr float opaque = 0.95f;
constexpr double told_width = 300, label_gap = 90, label_edge = 14, label_row = 32;  // interface pixels
constexpr double compass_width = 170, compass_height = 190;

bool of_cavity(const ModelPart& part, const Scene& usual) {
  const Look* look = usual.look_of(part.structure);
  return part.cavity && !(look && look->as_body);
}

NamedPlaces places_of(const ModelPart& part, const Model& model, std::size_t index) {
  NamedPlaces named{.structure = part.structure,
                    .places = {},
                    .everywhere = {},
                    .low = glm::dvec3(1e300),
                    .high = glm::dvec3(-1e300)};
  const auto at = [&](std::size_t i) { return model.origin_mm + glm::dvec3(part.positions[i]) / metres_per_mm; };
  for (std::size_t i = 0; i < part.positions.size(); ++i) {
    named.low = glm::min(named.low, at(i));
    named.high = glm::max(named.high, at(i));
  }
  const double height = named.high.z - named.low.z, level = named.low.z + levels[index % levels.size()] * height;
  const std::size_t step = std::max<std::size_t>(1, part.positions.size() / (24 * most_places));
  for (std::size_t i = 0; i < part.positions.size(); i += step) {
    named.everywhere.push_back(at(i));
    if (std::abs(named.everywhere.back().z - level) < level_spread * height && named.places.size() < most_places)
      named.places.push_back(named.everywhere.back());
  }
  if (named.places.empty()) named.places.push_back(0.5 * (named.low + named.high));
  return named;
}

bool within(const NamedPlaces& inner, const NamedPlaces& outer) {
  return glm::all(glm::greaterThanEqual(inner.low, outer.low)) && glm::all(glm::lessThanEqual(inner.high, outer.high));
}

/// Is it hidden in something opaque? Only without a section.
bool covered(const NamedPlaces& named, const StructureNames& names, const ViewerState& state) {
  const auto depth = depth_in_tooth(named.structure);
  return std::any_of(names.places.begin(), names.places.end(), [&](const NamedPlaces& other) {
    const Look* look = state.scene.look_of(other.structure);
    const auto outer = depth_in_tooth(other.structure);
    return &other != &named && look && look->visible && look->opacity > opaque && depth && outer && *outer < *depth &&
           within(named, other);
  });
}

/// Where a cut shows the structure there; of others what is left.
std::vector<glm::dvec3> candidates(const NamedPlaces& named, const StructureNames& names, const ViewerState& state) {
  if (!state.scene.section) return covered(named, names, state) ? std::vector<glm::dvec3>{} : named.places;
  const glm::dvec3 normal = glm::normalize(state.scene.section->normal);
  const auto off = [&](const glm::dvec3& p) { return glm::dot(p - state.scene.section->point_mm, normal); };
  const double reach = near_cut * 2 * state.shown->model.radius_mm;
  std::vector<glm::dvec3> kept;
  std::copy_if(named.everywhere.begin(), named.everywhere.end(), std::back_inserter(kept),
               [&](const glm::dvec3& p) { return off(p) < 0 && off(p) > -reach; });
  if (kept.empty())
    std::copy_if(named.places.begin(), named.places.end(), std::back_inserter(kept),
                 [&](const glm::dvec3& p) { return off(p) < 0; });
  return kept;
}

/// The one farthest to that side of the picture.
std::optional<glm::dvec2> outermost(const std::vector<glm::dvec3>& places, bool right, const ViewPane& pane) {
  std::optional<glm::dvec2> best;
  for (const glm::dvec3& place : places) {
    const auto seen = place_of(pane.camera, place);
    if (!seen) continue;
    const glm::dvec2 at = pixel_of(pane.area, *seen);
    if (!best || (right ? at.x > best->x : at.x < best->x)) best = at;
  }
  return best && pane.shown().holds(best->x, best->y) ? best : std::nullopt;
}

std::string words_for(const std::string& structure) {
  constexpr std::string_view ending = " cavity";
  return structure.ends_with(ending) ? structure.substr(0, structure.size() - ending.size()) + ": cavity" : structure;
}

}  // namespace

std::vector<NamedPlaces> named_places(const Model& model, const Scene& usual) {
  std::vector<NamedPlaces> named;
  for (const ModelPart& part : model.parts)
    if (!part.positions.empty() && !of_cavity(part, usual)) named.push_back(places_of(part, model, named.size()));
  return named;
}

std::vector<DrawnName> drawn_names(const StructureNames& names, const ViewerState& state, const ViewPane& pane,
                                   const Interface& interface, float scale) {
  std::vector<DrawnName> drawn;
  for (std::size_t i = 0; i < names.places.size(); ++i) {
    const Look* look = state.scene.look_of(names.places[i].structure);
    if (!look || !look->visible || !(look->opacity > 0)) continue;
    if (const auto at = outermost(candidates(names.places[i], names, state), i % 2 == 0, pane))
      drawn.push_back({i, *at, {}});
  }
  // From top to bottom, so that lines do not cross.
  std::stable_sort(drawn.begin(), drawn.end(),
                   [](const DrawnName& a, const DrawnName& b) { return a.place.y < b.place.y; });
  std::array<double, 2> free_from{pane.area.top, pane.area.top};
  for (DrawnName& name : drawn) {
    const bool right = name.which % 2 == 0;
    const ImVec2 extent = interface.bold->CalcTextSizeA(
        interface.bold->FontSize, 1e9f, 0, interface.say(words_for(names.places[name.which].structure)).c_str());
    const double width = extent.x + 20 * scale, height = extent.y + 10 * scale,
                 left_end = pane.area.left + label_edge * scale,
                 right_end = pane.area.left + pane.area.width - label_edge * scale;
    const double x = right ? std::min(name.place.x + label_gap * scale, right_end - width)
                           : std::max(name.place.x - label_gap * scale - width, left_end);
    double least = pane.area.top + label_edge * scale;
    if (x + width > right_end - compass_width * scale) least += compass_height * scale;
    const double y = std::max({name.place.y - 24 * scale, least, free_from[right]});
    name.box = {x, std::min(y, pane.area.top + pane.area.height - height - 60 * scale), width, height};
    free_from[right] = name.box.top + label_row * scale;
  }
  return drawn;
}

void draw_names(const StructureNames& names, const ViewerState& state, const ViewPane& pane, const Interface& interface,
                float scale) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 low = vec(pane.area.left, pane.area.top),
               high = vec(pane.area.left + pane.area.width, pane.area.top + pane.area.height);
  list.PushClipRect(low, high);
  for (const DrawnName& name : drawn_names(names, state, pane, interface, scale)) {
    const NamedPlaces& named = names.places[name.which];
    const Area& box = name.box;
    const double side = name.which % 2 == 0 ? box.left : box.left + box.width;
    const ImVec2 end = vec(side, box.top + box.height / 2), at = vec(name.place);
    list.AddLine(at, end, theme::mark_outline, 3.2f * scale);
    list.AddLine(at, end, theme::text, 1.4f * scale);
    list.AddCircleFilled(at, 4.6f * scale, theme::mark_outline, 20);
    list.AddCircleFilled(at, 3.0f * scale, theme::text, 20);
    const bool told = names.told == name.which;
    const std::string sentences = told ? interface.say(std::string(told_of(named.structure))) : std::string();
    const float wrap = static_cast<float>(told_width * scale);
    const ImVec2 below = sentences.empty()
                             ? ImVec2(0, 0)
                             : interface.small->CalcTextSizeA(interface.small->FontSize, 1e9f, wrap, sentences.data(),
                                                              sentences.data() + sentences.size());
    const double width = std::max(box.width, sentences.empty() ? 0.0 : below.x + 20.0 * scale);
    const double left =
        std::clamp(box.left, pane.area.left + 4 * scale,
                   std::max(pane.area.left + 4 * scale, pane.area.left + pane.area.width - width - 4 * scale));
    list.AddRectFilled(vec(left, box.top),
                       vec(left + width, box.top + box.height + (sentences.empty() ? 0 : below.y + 8 * scale)),
                       theme::rgb(0x14181c, sentences.empty() ? 215 : 240), 6 * scale);
    list.AddText(interface.bold, interface.bold->FontSize, vec(left + 10 * scale, box.top + 5 * scale), theme::text,
                 interface.say(words_for(named.structure)).c_str());
    if (!sentences.empty())
      list.AddText(interface.small, interface.small->FontSize, vec(left + 10 * scale, box.top + box.height),
                   theme::text, sentences.data(), sentences.data() + sentences.size(), wrap);
  }
  list.PopClipRect();
}

std::optional<std::size_t> name_hit(const StructureNames& names, const ViewerState& state, const ViewPane& pane,
                                    const Interface& interface, float scale, double x, double y) {
  for (const DrawnName& name : drawn_names(names, state, pane, interface, scale))
    if (name.box.holds(x, y)) return name.which;
  return std::nullopt;
}

std::string_view told_of(std::string_view structure) {
  struct Told {
    std::string_view name, words;
  };
  static constexpr std::array known = {
      Told{"cavity",
           "The space that dentine walls in: the pulp chamber in the crown and the canals down the roots. In a living "
           "tooth the pulp fills it. C flies inside; click a canal to ride along it."},
      Told{"enamel",
           "The hard cap of the crown, almost wholly mineral, and translucent like frosted glass. It is thickest over "
           "the cusps and thins out to an edge at the neck of the tooth."},
      Told{"dentin",
           "The body of the tooth, under the enamel in the crown and under the cementum in the root. Fine tubules "
           "cross it from the pulp outwards, and it walls chamber and canals in."},
      Told{"pulp",
           "The soft tissue inside, with nerves and vessels: a chamber in the crown, with a horn below each cusp, and "
           "canals down the roots to the opening at the tip. C flies inside; click a canal to ride along it."},
      Told{"cement",
           "A thin layer like bone that covers the root. Fibres anchored in it hold the tooth in its socket."},
      Told{"bone", "The jaw's bone, with a socket for each root. Fibres run from its wall to the root's cementum."},
      Told{"tooth",
           "All hard tissue of the tooth as one solid. Inside lie the pulp chamber, in the crown, and a canal or more "
           "in each root."},
  };
  const std::string lower = lower_case(std::string(structure));
  for (const Told& one : known)
    if (lower.find(one.name) != std::string::npos) return one.words;
  return {};
}

}  // namespace odontoscope
