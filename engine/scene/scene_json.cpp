#include "engine/scene/scene_json.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <tuple>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/read_file.h"

namespace odontoscope {

namespace {

using Json = nlohmann::ordered_json;  // written in the order given
using Parsed = nlohmann::json;        // finds a key among many in no time

constexpr const char* format_name = "odontoscope.scene";
constexpr int format_version = 1;
constexpr std::size_t most_scene_bytes = 1u << 20;
constexpr float most_emphasis = 4;
constexpr double most_slab = 1e9;
constexpr double most_iso = 1e30;
constexpr int most_side = 16'384;  // most_picture_side in engine/picture/image.h
constexpr double least_reach_mm = 1e-9, most_reach_mm = 1e9;

Json to_json(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

const char* name(Background::Kind kind) {
  switch (kind) {
    case Background::Kind::plain:
      return "plain";
    case Background::Kind::gradient:
      return "gradient";
    case Background::Kind::transparent:
      return "transparent";
  }
  return "unknown";
}

const char* name(CapLook::Shows shows) {
  switch (shows) {
    case CapLook::Shows::plain:
      return "plain";
    case CapLook::Shows::ct:
      return "ct";
    default:
      return "material";
  }
}

/// Reads members of one object; each call leaves `value` alone if the member is missing.
class Reader {
 public:
  Reader(const Parsed& object, std::string path, const std::string& file)
      : object_(object), path_(std::move(path)), file_(file) {
    if (!object.is_object()) refuse("wrong-type", path_, "is no object");
  }

  const Parsed* member(const char* key) const {
    const auto found = object_.find(key);
    return found == object_.end() || found->is_null() ? nullptr : &*found;
  }

  void read(const char* key, bool& value) const {
    if (const Parsed* json = member(key)) {
      if (!json->is_boolean()) refuse("wrong-type", key, "is neither true nor false");
      value = json->get<bool>();
    }
  }

  void read(const char* key, double& value) const {
    if (const Parsed* json = member(key)) value = number(*json, key);
  }

  void read(const char* key, float& value, float low, float high) const {
    double wide = value;
    read(key, wide);
    if (wide < low || wide > high) refuse("bad-value", key, fmt::format("is not between {} and {}", low, high));
    value = static_cast<float>(wide);
  }

  void read(const char* key, glm::dvec3& value) const {
    if (const Parsed* json = member(key)) {
      if (!json->is_array() || json->size() != 3) refuse("wrong-type", key, "is no list of three numbers");
      value = {number((*json)[0], key), number((*json)[1], key), number((*json)[2], key)};
    }
  }

  void read(const char* key, ValueWindow& value) const {
    if (const Parsed* json = member(key)) {
      if (!json->is_array() || json->size() != 2) refuse("wrong-type", key, "is no list of two numbers");
      value = {number((*json)[0], key), number((*json)[1], key)};
    }
  }

  void read(const char* key, std::string& value) const {
    if (const Parsed* json = member(key)) {
      if (!json->is_string()) refuse("wrong-type", key, "is no text");
      value = json->get<std::string>();
    }
  }

  void read(const char* key, Colour& value) const {
    std::string text;
    read(key, text);
    if (text.empty()) return;
    try {
      value = colour_from_hex(text);
    } catch (const UsageError& error) {
      refuse("bad-value", key, error.what());
    }
  }

  /// One of a few words, `named` of which gives the value or throws UsageError.
  template <class Value, class Named>
  void read_word(const char* key, Value& value, Named named) const {
    std::string text;
    read(key, text);
    if (text.empty()) return;
    try {
      value = named(text);
    } catch (const UsageError& error) {
      refuse("bad-value", key, error.what());
    }
  }

  [[noreturn]] void refuse(std::string_view cause, std::string_view key, std::string_view wrong) const {
    Place place;
    place.file = file_;
    throw InputError(cause, place,
                     fmt::format("\"{}\" {}", path_.empty() ? key : fmt::format("{}.{}", path_, key), wrong),
                     "A scene that the viewer saves (Ctrl S) shows the form");
  }

 private:
  double number(const Parsed& json, const char* key) const {
    if (!json.is_number()) refuse("wrong-type", key, "is no number");
    const double value = json.get<double>();
    if (!std::isfinite(value)) refuse("not-finite", key, "is not finite");
    return value;
  }

  const Parsed& object_;
  std::string path_;
  const std::string& file_;
};

Camera::Projection projection_named(std::string_view wanted) {
  if (wanted == "perspective") return Camera::Projection::perspective;
  if (wanted == "parallel") return Camera::Projection::parallel;
  throw UsageError(fmt::format("there is no projection \"{}\"", wanted), "Choose perspective or parallel.");
}

Background::Kind background_named(std::string_view wanted) {
  for (const auto kind : {Background::Kind::plain, Background::Kind::gradient, Background::Kind::transparent})
    if (wanted == name(kind)) return kind;
  throw UsageError(fmt::format("there is no background \"{}\"", wanted), "Choose plain, gradient or transparent.");
}

void read_camera(const Reader& scene, const std::string& file, Camera& camera) {
  const Parsed* json = scene.member("camera");
  if (!json) return;
  const Reader reader(*json, "camera", file);
  reader.read_word("projection", camera.projection, projection_named);
  reader.read("position", camera.position);
  reader.read("target", camera.target);
  reader.read("up", camera.up);
  reader.read("field_of_view_deg", camera.field_of_view_deg);
  reader.read("height_mm", camera.height_mm);
  reader.read("near_mm", camera.near_mm);
  validate(camera, file);
}

void read_looks(const Reader& scene, const std::string& file, Scene& result) {
  const Parsed* json = scene.member("structures");
  if (!json) return;
  if (!json->is_array()) scene.refuse("wrong-type", "structures", "is no list");
  if (json->size() > limits::structures)
    scene.refuse("bad-value", "structures", fmt::format("are more than {}", limits::structures));
  for (std::size_t i = 0; i < json->size(); ++i) {
    const Reader reader((*json)[i], fmt::format("structures[{}]", i), file);
    std::string structure;
    reader.read("name", structure);
    if (structure.empty()) reader.refuse("bad-value", "name", "is missing");
    Look* look = result.look_of(structure);
    if (!look) look = &result.looks.emplace_back(Look{structure, usual_colour(structure, i)});
    reader.read("colour", look->colour);
    reader.read("opacity", look->opacity, 0, 1);
    reader.read("visible", look->visible);
    reader.read("as_body", look->as_body);
  }
}

void read_section(const Reader& scene, const std::string& file, Scene& result) {
  const Parsed* json = scene.member("section");
  if (!json) return;
  const Reader reader(*json, "section", file);
  Section section;
  reader.read("point", section.point_mm);
  reader.read("normal", section.normal);
  if (!(glm::length(section.normal) > 0)) reader.refuse("bad-value", "normal", "has no length");
  result.section = section;
}

CapLook::Shows cap_named(std::string_view wanted) {
  for (const auto shows : {CapLook::Shows::material, CapLook::Shows::plain, CapLook::Shows::ct})
    if (wanted == name(shows)) return shows;
  throw UsageError(fmt::format("a cap cannot show \"{}\"", wanted), "Choose material, plain or ct.");
}

void read_cap(const Reader& scene, const std::string& file, CapLook& cap) {
  const Parsed* json = scene.member("cap");
  if (!json) return;
  const Reader reader(*json, "cap", file);
  reader.read_word("shows", cap.shows, cap_named);
  cap.window.reset();
  if (!reader.member("window")) return;
  ValueWindow window;
  reader.read("window", window);
  if (!window.sensible()) reader.refuse("bad-value", "window", "is no range of values, the lower first");
  cap.window = window;
}

void read_transfer(const Reader& volume, const std::string& file, std::vector<TransferPoint>& transfer) {
  const Parsed* json = volume.member("transfer");
  if (!json) return;
  if (!json->is_array() || json->size() > most_transfer_points)
    volume.refuse("wrong-type", "transfer", fmt::format("is no list of at most {} points", most_transfer_points));
  transfer.clear();
  for (std::size_t i = 0; i < json->size(); ++i) {
    const Reader reader((*json)[i], fmt::format("volume.transfer[{}]", i), file);
    TransferPoint& point = transfer.emplace_back();
    reader.read("value", point.value);
    reader.read("colour", point.colour);
    reader.read("extinction", point.extinction);
  }
  if (!transfer.empty() && !sensible(transfer))
    volume.refuse("bad-value", "transfer", "is no transfer function: values ascend, extinctions are not negative");
}

void read_volume_look(const Reader& scene, const std::string& file, VolumeLook& look) {
  const Parsed* json = scene.member("volume");
  if (!json) return;
  const Reader reader(*json, "volume", file);
  reader.read_word("shows", look.shows, shows_named);
  reader.read_word("cast", look.cast, cast_named);
  read_transfer(reader, file, look.transfer);
  ValueWindow slopes{look.slopes.flat, look.slopes.steep};
  reader.read("slopes", slopes);
  look.slopes = {slopes.low, slopes.high};
  if (!look.slopes.sensible()) reader.refuse("bad-value", "slopes", "is no range of slopes, the flatter first");
  reader.read("lit", look.lit);
  ValueWindow window{look.black, look.white};
  reader.read("window", window);
  if (!window.sensible()) reader.refuse("bad-value", "window", "is no range of values, the lower first");
  look.black = window.low;
  look.white = window.high;
  constexpr double most = 1e6;
  reader.read("attenuation", look.attenuation);
  if (!(look.attenuation >= 0 && look.attenuation <= most))
    reader.refuse("bad-value", "attenuation", "is no sensible attenuation");
  reader.read("latitude", look.latitude);
  if (!(look.latitude > 1 / most && look.latitude <= most))
    reader.refuse("bad-value", "latitude", "is no sensible latitude");
  reader.read("inverted", look.inverted);
  ValueWindow film{look.film_mm.x, look.film_mm.y};
  reader.read("film_mm", film);
  look.film_mm = {film.low, film.high};
  if (!(std::min(film.low, film.high) >= 0 && std::max(film.low, film.high) <= most))
    reader.refuse("bad-value", "film_mm", "is no size of a film");
  reader.read("iso", look.iso);
  if (!(std::abs(look.iso) <= most_iso)) reader.refuse("bad-value", "iso", "is no sensible value");
  reader.read("iso_colour", look.iso_colour);
}

void read_surroundings(const Reader& scene, const std::string& file, Scene& result) {
  if (const Parsed* json = scene.member("background")) {
    const Reader reader(*json, "background", file);
    reader.read_word("kind", result.background.kind, background_named);
    reader.read("top", result.background.top);
    reader.read("bottom", result.background.bottom);
  }
  if (const Parsed* json = scene.member("ambient_occlusion")) {
    const Reader reader(*json, "ambient_occlusion", file);
    reader.read("on", result.occlusion.on);
    reader.read("strength", result.occlusion.strength, 0, most_emphasis);
    reader.read("reach", result.occlusion.reach, 0, 1);
  }
  if (const Parsed* json = scene.member("headlight")) {
    const Reader reader(*json, "headlight", file);
    Headlight headlight;
    reader.read("reach_mm", headlight.reach_mm);
    if (!(headlight.reach_mm >= least_reach_mm && headlight.reach_mm <= most_reach_mm))
      reader.refuse("bad-value", "reach_mm", "is no sensible distance");
    result.headlight = headlight;
  }
}

void read_data_colours(const Reader& scene, const std::string& file, std::optional<DataColours>& colours) {
  const Parsed* json = scene.member("data_colours");
  if (!json) return;
  const Reader reader(*json, "data_colours", file);
  DataColours read;
  reader.read_word("of", read.of, data_colours_named);
  reader.read("reach", read.reach);
  if (!(read.reach > 0 && read.reach <= most_iso)) reader.refuse("bad-value", "reach", "is no number above 0");
  colours = read;
}

void read_picture(const Reader& scene, const std::string& file, std::optional<PictureFormat>& picture) {
  const Parsed* json = scene.member("picture");
  if (!json) return;
  const Reader reader(*json, "picture", file);
  PictureFormat format;
  for (const auto& [key, value, most] : {std::tuple{"width", &format.width, most_side},
                                         {"height", &format.height, most_side},
                                         {"samples", &format.samples, 16}}) {
    double number = *value;
    reader.read(key, number);
    if (number < 1 || number > most || number != std::floor(number))
      reader.refuse("bad-value", key, fmt::format("is no whole number from 1 to {}", most));
    *value = static_cast<int>(number);
  }
  const double side = std::sqrt(format.samples);
  if (side != std::floor(side)) reader.refuse("bad-value", "samples", "is none of 1, 4, 9 and 16");
  picture = format;
}

void read_overlays(const Reader& scene, const std::string& file, OverlayChoice& overlays) {
  const Parsed* json = scene.member("overlays");
  if (!json) return;
  const Reader reader(*json, "overlays", file);
  reader.read("contours", overlays.contours);
  reader.read("edges", overlays.edges);
  reader.read("shrink", overlays.shrink, 0, 1);
  if (!reader.member("slab")) return;
  double slab = -1;
  reader.read("slab", slab);
  if (slab < 0 || slab > most_slab || slab != std::floor(slab))
    reader.refuse("bad-value", "slab", "is no number of a slab");
  overlays.slab = static_cast<std::size_t>(slab);
}

Json camera_json(const Camera& camera) {
  Json json{{"projection", camera.projection == Camera::Projection::parallel ? "parallel" : "perspective"},
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

const char* name(BackFaces mode) {
  switch (mode) {
    case BackFaces::cull:
      return "cull";
    case BackFaces::show:
      return "show";
    case BackFaces::tint:
      return "tint";
  }
  return "unknown";
}

BackFaces back_faces_named(std::string_view wanted) {
  for (const auto mode : {BackFaces::cull, BackFaces::show, BackFaces::tint})
    if (wanted == name(mode)) return mode;
  throw UsageError(fmt::format("there is no way \"{}\" to draw back faces", wanted), "Choose cull, show or tint.");
}

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
  json["cap"] = {{"shows", name(scene.cap.shows)},
                 {"window", scene.cap.window ? Json::array({scene.cap.window->low, scene.cap.window->high}) : Json()}};
  if (scene.volume != VolumeLook{}) json["volume"] = volume_json(scene.volume);
  json["back_faces"] = name(scene.back_faces);
  json["wire"] = scene.wire;
  json["overlays"] = {{"contours", scene.overlays.contours},
                      {"edges", scene.overlays.edges},
                      {"slab", scene.overlays.slab ? Json(*scene.overlays.slab) : Json()},
                      {"shrink", short_number(scene.overlays.shrink)}};
  json["background"] = {{"kind", name(scene.background.kind)},
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
  const Parsed json = Parsed::parse(text, nullptr, /*allow_exceptions=*/false);
  Place place;
  place.file = file;
  if (json.is_discarded())
    throw InputError("unparsable", place, "this is no JSON", "Save a scene from the viewer as a pattern.");
  const Reader reader(json, "", file);
  std::string format;
  double version = 0;
  reader.read("format", format);
  reader.read("version", version);
  if (format != format_name) reader.refuse("wrong-format", "format", fmt::format("is not \"{}\"", format_name));
  if (version != format_version) reader.refuse("wrong-version", "version", fmt::format("is not {}", format_version));
  Scene scene = start;
  read_camera(reader, file, scene.camera);
  read_looks(reader, file, scene);
  read_section(reader, file, scene);
  read_cap(reader, file, scene.cap);
  read_volume_look(reader, file, scene.volume);
  reader.read_word("back_faces", scene.back_faces, back_faces_named);
  reader.read("wire", scene.wire);
  reader.read("wall_depth", scene.wall_depth);
  reader.read("wall_thickness", scene.wall_thickness);
  read_data_colours(reader, file, scene.data_colours);
  read_overlays(reader, file, scene.overlays);
  read_surroundings(reader, file, scene);
  read_picture(reader, file, scene.picture);
  return scene;
}

Scene read_scene(const std::string& file, const Scene& start) {
  return scene_from_json(read_file(file, most_scene_bytes), start, file);
}

}  // namespace odontoscope
