#include "engine/app/scene_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "engine/app/plain_input.h"
#include "engine/picture/image.h"
#include "engine/scene/fit_visible.h"
#include "engine/scene/scene_json.h"
#include "recon/core/error.h"

namespace odontoscope::app {
namespace {

double number_in(std::string_view text, std::string_view option) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number))
    throw UsageError(fmt::format("{}: \"{}\" is no number", option, text), "Give one such as 2.5.");
  return number;
}

Look& look_called(Scene& scene, std::string_view structure, std::string_view option) {
  if (Look* look = scene.look_of(structure)) return *look;
  std::vector<std::string> names;
  for (const Look& look : scene.looks) names.push_back(look.structure);
  throw UsageError(fmt::format("{}: there is no structure \"{}\"", option, structure),
                   fmt::format("There are: {}.", fmt::join(names, ", ")));
}

/// "S=VALUE"; a structure's name may hold a "=", a value may not.
std::pair<std::string, std::string> name_and_value(const std::string& text, std::string_view option) {
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0)
    throw UsageError(fmt::format("{} {}: say which structure", option, text),
                     fmt::format("For example {} enamel=VALUE", option));
  return {text.substr(0, sign), text.substr(sign + 1)};
}

std::pair<std::string, float> opacity_in(const std::string& text) {
  const auto [structure, value] = name_and_value(text, "--opacity");
  const double opacity = number_in(value, "--opacity");
  if (opacity < 0 || opacity > 1)
    throw UsageError(fmt::format("--opacity {}: not between 0 and 1", text),
                     "From 0, clear, to 1, solid: --opacity enamel=0.3");
  return {structure, static_cast<float>(opacity)};
}

void change_looks(const SceneWords& words, Scene& scene) {
  for (const std::string& structure : words.hide) look_called(scene, structure, "--hide").visible = false;
  for (const std::string& text : words.opacity) {
    const auto [structure, opacity] = opacity_in(text);
    look_called(scene, structure, "--opacity").opacity = opacity;
  }
  for (const std::string& text : words.colour) {
    const auto [structure, value] = name_and_value(text, "--colour");
    look_called(scene, structure, "--colour").colour = colour_from_hex(value);
  }
}

Background background_from(const std::string& text) {
  Background background;
  if (text == "transparent")
    background.kind = Background::Kind::transparent;
  else if (text == "white")
    background = {Background::Kind::plain, {1, 1, 1}, {1, 1, 1}};
  else if (text == "black")
    background = {Background::Kind::plain, {0, 0, 0}, {0, 0, 0}};
  else if (const std::size_t comma = text.find(','); comma != std::string::npos)
    background = {Background::Kind::gradient, colour_from_hex(text.substr(0, comma)),
                  colour_from_hex(text.substr(comma + 1))};
  else
    background = {Background::Kind::plain, colour_from_hex(text), colour_from_hex(text)};
  return background;
}

BackFaces culling_from(const std::string& text) {
  if (text == "on") return BackFaces::cull;
  if (text == "off") return BackFaces::show;
  if (text == "tint") return BackFaces::tint;
  throw UsageError(fmt::format("--cull {}: that is no way to treat faces seen from behind", text),
                   "Choose on, off or tint.");
}

constexpr std::string_view ct_word = "ct";

/// "material", "plain", "ct", "ct=LOW,HIGH".
CapLook cap_from(const std::string& text) {
  if (text == "material") return {};
  if (text == "plain") return {CapLook::Shows::plain, {}};
  CapLook cap{CapLook::Shows::ct, {}};
  if (text == ct_word) return cap;
  const std::size_t start = ct_word.size() + 1, comma = text.find(',');
  if (!text.starts_with("ct=") || comma == std::string::npos)
    throw UsageError(fmt::format("--cap {}: a cap cannot show that", text),
                     "Choose material, plain, ct, or ct=LOW,HIGH with the values that are black and white: ct=60,220.");
  cap.window = ValueWindow{number_in(std::string_view(text).substr(start, comma - start), "--cap"),
                           number_in(std::string_view(text).substr(comma + 1), "--cap")};
  if (!cap.window->sensible())
    throw UsageError(fmt::format("--cap {}: that is no range of values", text),
                     "Give the value that is black, then a higher one that is white: ct=60,220.");
  return cap;
}

void choose_cap(const SceneWords& words, const ValueGrid* values, Scene& scene) {
  if (!words.cap.empty()) scene.cap = cap_from(words.cap);
  if (values || scene.cap.shows != CapLook::Shows::ct) return;
  if (!words.cap.empty())
    throw UsageError(fmt::format("--cap {}: only a volume has CT values", words.cap),
                     "Give the volume that the model was made from, with --iso.");
  throw UsageError(fmt::format("{} shows CT values on the cap, and only a volume has them", words.scene_file),
                   "Give the volume that the model was made from, with --iso, or add --cap material.");
}

/// How clear what surrounds the tetrahedra becomes, so that they can be seen.
constexpr float around_tetrahedra = 0.12f;

constexpr std::string_view tetrahedra_word = "tetrahedra";

/// The slab in "tetrahedra=N"; none in "tetrahedra".
std::optional<std::size_t> slab_in(const std::string& text) {
  if (text.size() == tetrahedra_word.size()) return std::nullopt;
  std::size_t slab = 0;
  const char* const end = text.data() + text.size();
  if (text[tetrahedra_word.size()] != '=' ||
      std::from_chars(text.data() + tetrahedra_word.size() + 1, end, slab).ptr != end || text.back() == '=')
    throw UsageError(fmt::format("--overlay {}: that is no number of a slab", text),
                     "Count slabs from 0: --overlay tetrahedra=12");
  return slab;
}

void refuse_unknown_overlay(const std::string& text) {
  if (text == "contours" || text == "edges") return;
  if (text.starts_with(tetrahedra_word))
    slab_in(text);
  else
    throw UsageError(fmt::format("--overlay {}: there is no such overlay", text),
                     "Choose contours, edges or tetrahedra[=SLAB].");
}

void show_slab(const std::string& text, const OverlaySource& source, Scene& scene) {
  if (source.slabs() == 0)
    throw UsageError(fmt::format("--overlay {}: a mesh has no tetrahedra", text),
                     "Give the contour stack, or the volume, that it was made from.");
  const std::size_t slab = slab_in(text).value_or(source.slabs() / 2);
  if (slab >= source.slabs())
    throw UsageError(fmt::format("--overlay {}: there is no such slab", text),
                     fmt::format("The slabs are counted from 0 to {}.", source.slabs() - 1));
  scene.overlays.slab = slab;
  for (Look& look : scene.looks) look.opacity = std::min(look.opacity, around_tetrahedra);
}

void add_overlays(const SceneWords& words, const OverlaySource& source, Scene& scene) {
  for (const std::string& text : words.overlays) {
    if (text == "contours") {
      if (source.contours.slices.empty())
        throw UsageError("--overlay contours: a mesh has no contours",
                         "Give the contour stack, or the volume, that it was made from.");
      scene.overlays.contours = true;
    } else if (text == "edges") {
      scene.overlays.edges = true;
    } else {
      show_slab(text, source, scene);
    }
  }
}

void place_camera(const SceneWords& words, const odontoscope::Model& model, double aspect, Scene& scene) {
  const bool given = !words.camera_file.empty() || !words.scene_file.empty();
  if (!words.camera_file.empty()) scene.camera = read_scene(words.camera_file, scene).camera;
  const auto projection = words.parallel ? Camera::Projection::parallel : scene.camera.projection;
  const NamedView view = words.view.empty() ? NamedView::three_quarter : view_named(words.view);
  if (!words.view.empty() || (!given && !words.hide.empty()))
    scene.camera = fit_without(words.hide, view, model, aspect, projection);
  scene.camera.projection = projection;
  // Nearer rather than with a longer lens; a parallel camera has only its height.
  scene.camera.position = scene.camera.target + (scene.camera.position - scene.camera.target) / words.zoom;
  scene.camera.height_mm /= words.zoom;
}

struct NamedDirection {
  std::string_view name;
  glm::dvec3 direction;
};

const std::array<NamedDirection, 15>& named_directions() {
  static const AnatomicalFrame tooth;
  static const std::array<NamedDirection, 15> all = {{{"x", {1, 0, 0}},
                                                      {"+x", {1, 0, 0}},
                                                      {"-x", {-1, 0, 0}},
                                                      {"y", {0, 1, 0}},
                                                      {"+y", {0, 1, 0}},
                                                      {"-y", {0, -1, 0}},
                                                      {"z", {0, 0, 1}},
                                                      {"+z", {0, 0, 1}},
                                                      {"-z", {0, 0, -1}},
                                                      {"buccal", tooth.buccal},
                                                      {"lingual", -tooth.buccal},
                                                      {"mesial", tooth.mesial},
                                                      {"distal", -tooth.mesial},
                                                      {"occlusal", tooth.occlusal},
                                                      {"apical", -tooth.occlusal}}};
  return all;
}

glm::dvec3 direction_in(const std::string& text) {
  for (const NamedDirection& named : named_directions())
    if (text == named.name) return named.direction;
  glm::dvec3 direction(0);
  std::size_t from = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t comma = axis < 2 ? text.find(',', from) : text.size();
    if (comma == std::string::npos)
      throw UsageError(
          fmt::format("--section {}: that is no direction", text),
          "Give +x, -x, +y, -y, +z, -z, buccal, lingual, mesial, distal, occlusal, apical, or three numbers: 1,1,0.");
    direction[axis] = number_in(std::string_view(text).substr(from, comma - from), "--section");
    from = comma + 1;
  }
  if (!(glm::length(direction) > 0))
    throw UsageError(fmt::format("--section {}: that points nowhere", text), "Give a direction, such as 1,1,0.");
  return glm::normalize(direction);
}

}  // namespace

Section section_from(const std::string& text, const odontoscope::Model& model) {
  const std::size_t at = text.find('@');
  Section section;
  section.normal = direction_in(text.substr(0, at));
  section.point_mm = model.bounds_mm.centre();
  if (at == std::string::npos) return section;
  const double place = number_in(std::string_view(text).substr(at + 1), "--section");
  // "-x@2.5" is the plane x = 2.5: for the six axes the place is a coordinate, whichever side is cut away.
  const glm::dvec3 n = section.normal;
  const bool against_axis = std::min({n.x, n.y, n.z}) == -1;
  section.point_mm = (against_axis ? -place : place) * n;
  return section;
}

Scene scene_from(const SceneWords& words, const odontoscope::Model& model, const OverlaySource& overlays,
                 const ValueGrid* values, PixelSize size) {
  const double aspect = static_cast<double>(size.width) / size.height;
  Scene scene = usual_scene(model, aspect);
  if (!words.scene_file.empty()) scene = read_scene(words.scene_file, scene);
  place_camera(words, model, aspect, scene);
  add_overlays(words, overlays, scene);
  change_looks(words, scene);
  if (!words.section.empty()) scene.section = section_from(words.section, model);
  choose_cap(words, values, scene);
  if (!words.back_faces.empty()) scene.back_faces = culling_from(words.back_faces);
  if (!words.background.empty()) scene.background = background_from(words.background);
  if (words.occlusion) {
    scene.occlusion.on = *words.occlusion > 0;
    scene.occlusion.strength = static_cast<float>(*words.occlusion);
  }
  if (words.wire) scene.wire = true;
  if (words.wall_depth) scene.wall_depth = true;
  if (words.wall_thickness) scene.wall_thickness = true;
  return scene;
}

void refuse_senseless(const SceneWords& words) {
  if (!words.view.empty()) view_named(words.view);
  if (!words.section.empty()) direction_in(words.section.substr(0, words.section.find('@')));
  if (!words.cap.empty()) cap_from(words.cap);
  if (!words.back_faces.empty()) culling_from(words.back_faces);
  for (const std::string& text : words.overlays) refuse_unknown_overlay(text);
  if (!words.background.empty()) background_from(words.background);
  for (const std::string& text : words.opacity) opacity_in(text);
  for (const std::string& text : words.colour) colour_from_hex(name_and_value(text, "--colour").second);
  for (const std::string& file : {words.scene_file, words.camera_file}) {
    refuse_pipe(file);
    if (!file.empty()) read_scene(file, Scene{});
  }
}

void refuse_unknown_structures(const SceneWords& words, const ContourStack& stack) {
  std::set<std::string> known;
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) known.insert(contour.structure);
  Scene scene;
  for (const std::string& structure : known) scene.looks.push_back({.structure = structure, .colour = {}});
  const auto check = [&](const std::string& structure, std::string_view option) {
    constexpr std::string_view cavity = " cavity";
    const bool hollow =
        structure.ends_with(cavity) && known.contains(structure.substr(0, structure.size() - cavity.size()));
    if (!hollow) look_called(scene, structure, option);
  };
  for (const std::string& structure : words.hide) check(structure, "--hide");
  for (const std::string& text : words.opacity) check(name_and_value(text, "--opacity").first, "--opacity");
  for (const std::string& text : words.colour) check(name_and_value(text, "--colour").first, "--colour");
}

PictureFormat picture_format(const std::string& size, std::optional<int> samples, const std::string& scene_file,
                             PixelSize usual) {
  PictureFormat format{.width = usual.width, .height = usual.height};
  if (!scene_file.empty()) format = read_scene(scene_file, Scene{}).picture.value_or(format);
  if (!size.empty()) {
    const PixelSize told = size_from(size);
    format.width = told.width;
    format.height = told.height;
  }
  if (samples) format.samples = *samples;
  return format;
}

int side_of(const PictureFormat& format) {
  int side = 1;
  while (side * side < format.samples) ++side;
  return side;
}

PixelSize size_from(const std::string& text) {
  PixelSize size;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  const bool both = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x' &&
                    std::from_chars(width.ptr + 1, end, size.height).ptr == end;
  if (!both || std::min(size.width, size.height) < 1 || std::max(size.width, size.height) > most_picture_side)
    throw UsageError(fmt::format("--size {}: that is no size of a picture", text),
                     fmt::format("Give width and height in pixels, 1 to {}: 1200x900.", most_picture_side));
  return size;
}

}  // namespace odontoscope::app
