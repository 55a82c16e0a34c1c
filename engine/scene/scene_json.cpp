#include "engine/scene/scene_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "engine/scene/json_colour.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/read_file.h"
#include "recon/input/json_schema.h"

namespace odontoscope {

namespace {

using Json = nlohmann::ordered_json;  // written in the order given

constexpr const char* format_name = "odontoscope.scene";
constexpr int format_version = 1;
constexpr std::size_t most_scene_bytes = 1u << 20;
constexpr float most_emphasis = 4;
constexpr double most_slab = 1e9;
constexpr double most_iso = 1e30;
constexpr int most_side = 16'384;  // most_picture_side in engine/picture/image.h
constexpr std::string_view remedy = "Take a scene saved from the viewer as a pattern.",
                           no_window = "is no range of values, the lower first";
constexpr double least_reach_mm = 1e-9, most_reach_mm = 1e9;

Json to_json(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

/// Adds what is read: a member that is missing leaves `scene` as it is.
class SceneSchema {
 public:
  SceneSchema(Scene& scene, const std::string& file) : scene_(scene), file_(file) {
    schema_.document(
        format_name, {format_version, format_version},
        {camera(), looks(), section(), cap(), volume(), schema_.word("back_faces", scene.back_faces, back_face_modes),
         schema_.flag("wire", scene.wire), schema_.flag("wall_depth", scene.wall_depth),
         schema_.flag("wall_thickness", scene.wall_thickness), colours_of_data(), overlays(), background(), occlusion(),
         headlight(), picture()});
  }
  void read(std::string_view text) { schema_.read(text, file_); }

 private:
  /// What a file says of a structure.
  struct GivenLook {
    std::string name;
    std::optional<Colour> colour;
    std::optional<float> opacity;
    std::optional<bool> visible, as_body;
  };

  JsonField camera();
  JsonField looks();
  void take_look();
  JsonField section();
  JsonField cap();
  JsonField volume();
  JsonField transfer();
  JsonField colours_of_data();
  JsonField overlays();
  JsonField background();
  JsonField occlusion();
  JsonField headlight();
  JsonField picture();

  template <class Where>
  JsonField colour(std::string_view key, Where where) {
    return json_colour(schema_, key, where);
  }
  JsonField colour(std::string_view key, Colour& value) {
    return colour(key, [&value]() -> Colour& { return value; });
  }
  /// [low, high], of which `take` makes sense, or says that there is none.
  JsonField range(std::string_view key, std::function<bool(const ValueWindow&)> take, std::string_view wrong) {
    return schema_.numbers(key, 2, [this, key, take = std::move(take), wrong](std::span<const double> ends) {
      if (!take({ends[0], ends[1]})) bad_value(key, wrong);
    });
  }
  void bad_value(std::string_view key, std::string_view wrong) {
    schema_.refuse("bad-value", fmt::format("\"{}\" {}", key, wrong), remedy);
  }

  Scene& scene_;
  std::string file_;
  GivenLook look_;
  std::size_t looks_ = 0;
  JsonSchema schema_{"a scene", JsonReading::tolerant};
};

JsonField SceneSchema::camera() {
  Camera& camera = scene_.camera;
  return schema_.object("camera",
                        {schema_.word("projection", camera.projection, camera_projections),
                         schema_.vector("position", camera.position), schema_.vector("target", camera.target),
                         schema_.vector("up", camera.up), schema_.number("field_of_view_deg", camera.field_of_view_deg),
                         schema_.number("height_mm", camera.height_mm), schema_.number("near_mm", camera.near_mm)},
                        {.closed = [this] { validate(scene_.camera, file_); }});
}

JsonField SceneSchema::looks() {
  return schema_.list("structures", "a structure", {.most = limits::structures},
                      {schema_.text("name", look_.name),
                       colour(
                           "colour", [this]() -> auto& { return look_.colour; }),
                       schema_.number("opacity", look_.opacity, {.low = 0, .high = 1}),
                       schema_.flag("visible", look_.visible), schema_.flag("as_body", look_.as_body)},
                      {.opened = [this] { look_ = {}; }, .closed = [this] { take_look(); }},
                      {.opened = [this] { looks_ = 0; }});
}

void SceneSchema::take_look() {
  if (look_.name.empty()) schema_.refuse("bad-value", "a structure has no \"name\"", remedy);
  Look* look = scene_.look_of(look_.name);
  if (!look) look = &scene_.looks.emplace_back(Look{look_.name, usual_colour(look_.name, looks_)});
  look->colour = look_.colour.value_or(look->colour);
  look->opacity = look_.opacity.value_or(look->opacity);
  look->visible = look_.visible.value_or(look->visible);
  look->as_body = look_.as_body.value_or(look->as_body);
  ++looks_;
}

JsonField SceneSchema::section() {
  return schema_.object("section", scene_.section,
                        {schema_.vector("point", of(held(scene_.section), &Section::point_mm)),
                         schema_.vector("normal", of(held(scene_.section), &Section::normal))},
                        {.closed = [this] {
                          if (!(glm::length(scene_.section->normal) > 0)) bad_value("normal", "has no length");
                        }});
}

JsonField SceneSchema::cap() {
  CapLook& cap = scene_.cap;
  return schema_.object("cap",
                        {schema_.word("shows", cap.shows, cap_contents), range(
                                                                             "window",
                                                                             [&cap](const ValueWindow& window) {
                                                                               cap.window = window;
                                                                               return window.sensible();
                                                                             },
                                                                             no_window)},
                        {.opened = [&cap] { cap.window.reset(); }});
}

JsonField SceneSchema::transfer() {
  std::vector<TransferPoint>& points = scene_.volume.transfer;
  return schema_.list("transfer", "a point", {.most = most_transfer_points, .cause = "wrong-type"},
                      {schema_.number("value", of(last(points), &TransferPoint::value)),
                       colour("colour", of(last(points), &TransferPoint::colour)),
                       schema_.number("extinction", of(last(points), &TransferPoint::extinction))},
                      {.opened = [&points] { points.emplace_back(); }},
                      {.opened = [&points] { points.clear(); },
                       .closed =
                           [this, &points] {
                             if (!points.empty() && !sensible(points))
                               bad_value("transfer",
                                         "is no transfer function: values ascend, extinctions are not negative");
                           }});
}

JsonField SceneSchema::volume() {
  VolumeLook& look = scene_.volume;
  constexpr double most = 1e6;
  const auto slopes = [&look](const ValueWindow& read) {
    look.slopes = {read.low, read.high};
    return look.slopes.sensible();
  };
  const auto window = [&look](const ValueWindow& read) {
    look.black = read.low;
    look.white = read.high;
    return read.sensible();
  };
  const auto film = [&look](const ValueWindow& read) {
    look.film_mm = {read.low, read.high};
    return std::min(read.low, read.high) >= 0 && std::max(read.low, read.high) <= most;
  };
  return schema_.object(
      "volume",
      {schema_.word("shows", look.shows, volume_shows), schema_.word("cast", look.cast, volume_casts), transfer(),
       range("slopes", slopes, "is no range of slopes, the flatter first"), schema_.flag("lit", look.lit),
       range("window", window, no_window), schema_.number("attenuation", look.attenuation, {.low = 0, .high = most}),
       schema_.number("latitude", look.latitude, {.low = 1 / most, .high = most}),
       schema_.flag("inverted", look.inverted), range("film_mm", film, "is no size of a film"),
       schema_.number("iso", look.iso, {.low = -most_iso, .high = most_iso}), colour("iso_colour", look.iso_colour)});
}

JsonField SceneSchema::colours_of_data() {
  std::optional<DataColours>& colours = scene_.data_colours;
  return schema_.object("data_colours", colours,
                        {schema_.word("of", of(held(colours), &DataColours::of), surface_colourings),
                         schema_.number("reach", of(held(colours), &DataColours::reach))},
                        {.closed = [this, &colours] {
                          if (!(colours->reach > 0 && colours->reach <= most_iso))
                            bad_value("reach", "is no number above 0");
                        }});
}

JsonField SceneSchema::overlays() {
  OverlayChoice& overlays = scene_.overlays;
  return schema_.object("overlays",
                        {schema_.flag("contours", overlays.contours), schema_.flag("edges", overlays.edges),
                         schema_.number("shrink", overlays.shrink, {.low = 0, .high = 1}),
                         schema_.number("slab", overlays.slab, {.low = 0, .high = most_slab, .whole = true})});
}

JsonField SceneSchema::background() {
  Background& background = scene_.background;
  return schema_.object("background", {schema_.word("kind", background.kind, background_kinds),
                                       colour("top", background.top), colour("bottom", background.bottom)});
}

JsonField SceneSchema::occlusion() {
  Occlusion& occlusion = scene_.occlusion;
  return schema_.object("ambient_occlusion",
                        {schema_.flag("on", occlusion.on),
                         schema_.number("strength", occlusion.strength, {.low = 0, .high = most_emphasis}),
                         schema_.number("reach", occlusion.reach, {.low = 0, .high = 1})});
}

JsonField SceneSchema::headlight() {
  return schema_.object("headlight", scene_.headlight,
                        {schema_.number("reach_mm", of(held(scene_.headlight), &Headlight::reach_mm),
                                        {.low = least_reach_mm, .high = most_reach_mm})});
}

JsonField SceneSchema::picture() {
  const auto picture = held(scene_.picture);
  const JsonRange side{.low = 1, .high = most_side, .whole = true};
  return schema_.object(
      "picture", scene_.picture,
      {schema_.number("width", of(picture, &PictureFormat::width), side),
       schema_.number("height", of(picture, &PictureFormat::height), side),
       schema_.number("samples", of(picture, &PictureFormat::samples), {.low = 1, .high = 16, .whole = true})},
      {.closed = [this] {
        const double along = std::sqrt(scene_.picture->samples);
        if (along != std::floor(along)) bad_value("samples", "is none of 1, 4, 9 and 16");
      }});
}

Json camera_json(const Camera& camera) {
  Json json{{"projection", word_of(camera_projections, camera.projection)},
            {"position", to_json(camera.position)},
            {"target", to_json(camera.target)},
            {"up", to_json(camera.up)},
            {"field_of_view_deg", camera.field_of_view_deg},
            {"height_mm", camera.height_mm}};
  if (camera.near_mm > 0) json["near_mm"] = camera.near_mm;
  return json;
}

Json volume_json(const VolumeLook& look) {
  Json transfer = Json::array();
  for (const TransferPoint& point : look.transfer)
    transfer.push_back({{"value", point.value}, {"colour", hex(point.colour)}, {"extinction", point.extinction}});
  return {{"shows", name(look.shows)},
          {"cast", name(look.cast)},
          {"transfer", transfer},
          {"slopes", Json::array({look.slopes.flat, look.slopes.steep})},
          {"lit", look.lit},
          {"window", Json::array({look.black, look.white})},
          {"attenuation", look.attenuation},
          {"latitude", look.latitude},
          {"inverted", look.inverted},
          {"film_mm", Json::array({look.film_mm.x, look.film_mm.y})},
          {"iso", look.iso},
          {"iso_colour", hex(look.iso_colour)}};
}

/// As a person would have typed it: 0.3, not 0.30000001192092896.
double short_number(float value) { return std::stod(fmt::format("{}", value)); }

}  // namespace

std::string to_json(const Scene& scene) {
  Json json{{"format", format_name}, {"version", format_version}, {"camera", camera_json(scene.camera)}};
  json["structures"] = Json::array();
  for (const Look& look : scene.looks)
    json["structures"].push_back({{"name", look.structure},
                                  {"colour", hex(look.colour)},
                                  {"opacity", short_number(look.opacity)},
                                  {"visible", look.visible},
                                  {"as_body", look.as_body}});
  if (scene.section)
    json["section"] = {{"point", to_json(scene.section->point_mm)}, {"normal", to_json(scene.section->normal)}};
  json["cap"] = {{"shows", word_of(cap_contents, scene.cap.shows)},
                 {"window", scene.cap.window ? Json::array({scene.cap.window->low, scene.cap.window->high}) : Json()}};
  if (scene.volume != VolumeLook{}) json["volume"] = volume_json(scene.volume);
  json["back_faces"] = word_of(back_face_modes, scene.back_faces);
  json["wire"] = scene.wire;
  json["overlays"] = {{"contours", scene.overlays.contours},
                      {"edges", scene.overlays.edges},
                      {"slab", scene.overlays.slab ? Json(*scene.overlays.slab) : Json()},
                      {"shrink", short_number(scene.overlays.shrink)}};
  json["background"] = {{"kind", word_of(background_kinds, scene.background.kind)},
                        {"top", hex(scene.background.top)},
                        {"bottom", hex(scene.background.bottom)}};
  json["ambient_occlusion"] = {{"on", scene.occlusion.on},
                               {"strength", short_number(scene.occlusion.strength)},
                               {"reach", short_number(scene.occlusion.reach)}};
  if (scene.headlight) json["headlight"] = {{"reach_mm", scene.headlight->reach_mm}};
  if (scene.wall_depth) json["wall_depth"] = true;
  if (scene.wall_thickness) json["wall_thickness"] = true;
  if (scene.data_colours)
    json["data_colours"] = {{"of", name(scene.data_colours->of)}, {"reach", scene.data_colours->reach}};
  if (scene.picture)
    json["picture"] = {
        {"width", scene.picture->width}, {"height", scene.picture->height}, {"samples", scene.picture->samples}};
  return json.dump(2) + "\n";
}

Scene scene_from_json(const std::string& text, const Scene& start, const std::string& file) {
  Scene scene = start;
  SceneSchema(scene, file).read(text);
  return scene;
}

Scene read_scene(const std::string& file, const Scene& start) {
  return scene_from_json(read_file(file, most_scene_bytes), start, file);
}

}  // namespace odontoscope
