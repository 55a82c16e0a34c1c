#include "engine/navigate/notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/scene/scene_json.h"
#include "recon/core/read_file.h"
#include "recon/input/strict_json.h"

namespace odontoscope {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view format_name = "odontoscope.tour";
constexpr int format_version = 2, version_without_scenes = 1;
constexpr double farthest_mm = 1e7;

enum Node {
  document, format, version, title, model, notes, note, note_title, note_text, note_inside, note_scene,
  camera, position, target, up, coordinate, angle, height, near, parallel
};

using Shape = JsonNode::Shape;
constexpr JsonNode::Key document_keys[] = {{"format", format, true}, {"version", version, true}, {"title", title, true}, {"model", model, false}, {"notes", notes, true}};
constexpr JsonNode::Key note_keys[] = {{"title", note_title, true}, {"text", note_text, true}, {"inside", note_inside, false},
                                       {"camera", camera, true},    {"scene", note_scene, false}};
constexpr JsonNode::Key camera_keys[] = {{"position", position, true}, {"target", target, true},   {"up", up, true},
                                         {"field_of_view_deg", angle, false}, {"height_mm", height, false}, {"near_mm", near, false}, {"parallel", parallel, false}};
constexpr JsonNode nodes[] = {
    {Shape::object, "a tour", -1, document_keys},
    {Shape::text, "\"format\""},
    {Shape::number, "\"version\""},
    {Shape::text, "\"title\""},
    {Shape::text, "\"model\""},
    {Shape::array, "\"notes\"", note},
    {Shape::object, "a note", -1, note_keys},
    {Shape::text, "\"title\""},
    {Shape::text, "\"text\""},
    {Shape::boolean, "\"inside\""},
    {Shape::ignored, "\"scene\""},
    {Shape::object, "a camera", -1, camera_keys},
    {Shape::array, "\"position\"", coordinate},
    {Shape::array, "\"target\"", coordinate},
    {Shape::array, "\"up\"", coordinate},
    {Shape::number, "a coordinate"},
    {Shape::number, "\"field_of_view_deg\""},
    {Shape::number, "\"height_mm\""},
    {Shape::number, "\"near_mm\""},
    {Shape::boolean, "\"parallel\""},
};

bool plain(const std::string& text, bool lines) {
  return std::none_of(text.begin(), text.end(), [&](char c) { return (static_cast<unsigned char>(c) < 0x20 && !(lines && c == '\n')) || c == 0x7f; });
}

class TourReader final : public StrictJson {
 public:
  TourReader() : StrictJson(nodes) {}

  TourNotes read_tour(JsonSource& source) {
    read(source);
    if (tour_.notes.empty()) refuse("no-notes", "the tour has no notes", "Save one from the viewer.");
    return std::move(tour_);
  }

 private:
  void opened(int node) override {
    if (node == note) {
      if (tour_.notes.size() == most_notes) refuse("too-many-notes", fmt::format("more than {} notes", most_notes), "Make two tours of it.");
      tour_.notes.emplace_back();
    }
    if (node == position || node == target || node == up) {
      vector_ = node;
      coordinates_ = 0;
    }
  }
  void closed(int node) override {
    if ((node == position || node == target || node == up) && coordinates_ != 3) refuse("wrong-type", "a place has three coordinates", "Write [x, y, z].");
    if (node == camera) validate(tour_.notes.back().camera, place().file);
  }
  void number(int node, double value) override {
    if (node == version) {
      if (value != format_version && value != version_without_scenes)
        refuse("wrong-version", fmt::format("version {} of the format, but this program reads versions {} and {}", value, version_without_scenes, format_version),
               "Write the file anew with a matching program.");
      return;
    }
    Camera& camera = tour_.notes.back().camera;
    if (node == angle) camera.field_of_view_deg = value;
    else if (node == height) camera.height_mm = value;
    else if (node == near) camera.near_mm = value;
    else {
      if (coordinates_ == 3) refuse("wrong-type", "a place has three coordinates, this one more", "Write [x, y, z].");
      if (std::abs(value) > farthest_mm) refuse("too-large", fmt::format("{} mm lies beyond {} mm", value, farthest_mm), "Check the unit.");
      (vector_ == position ? camera.position : vector_ == target ? camera.target : camera.up)[coordinates_++] = value;
    }
  }
  void boolean(int node, bool value) override {
    if (node == note_inside) tour_.notes.back().inside = value;
    else if (value) tour_.notes.back().camera.projection = Camera::Projection::parallel;
  }
  void text(int node, const std::string& value) override {
    switch (node) {
      case format:
        if (value != format_name) refuse("wrong-format", fmt::format("the format is not \"{}\"", format_name), "Check that this is the file you mean.");
        return;
      case title: tour_.title = checked_title(value); return;
      case model: tour_.model = checked_title(value, 4096); return;
      case note_title: tour_.notes.back().title = checked_title(value); return;
      default: break;
    }
    if (value.size() > most_text_bytes || !plain(value, true))
      refuse("bad-text", fmt::format("a text is longer than {} bytes or has control characters", most_text_bytes), "Shorten it, or make two notes of it.");
    tour_.notes.back().text = value;
  }
  std::string checked_title(const std::string& value, std::size_t most = most_title_bytes) const {
    if (value.size() > most || !plain(value, false))
      refuse("bad-title", fmt::format("a title or name is longer than {} bytes or has control characters", most), "Shorten it.");
    return value;
  }
  void add_place(Place&) const override {}

  TourNotes tour_;
  int vector_ = position;
  glm::length_t coordinates_ = 0;
};

Json json_of(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

/// Scenes have a reader of their own. `bytes` are known to be a tour, and nowhere nested deeply.
void take_scenes(std::string_view bytes, const std::string& name, TourNotes& tour) {
  const Json json = Json::parse(bytes, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) throw InternalError("a tour that was read cannot be read again");
  for (std::size_t i = 0; i < tour.notes.size(); ++i) {
    const Json& note = json["notes"][i];
    const auto found = note.find("scene");
    if (found == note.end()) continue;
    Json scene = *found;
    if (scene.is_object()) scene.erase("camera");
    tour.notes[i].scene = scene.dump();
    scene_from_json(tour.notes[i].scene, Scene{}, fmt::format("{}, note {}", name, i + 1));   // refused now rather than in the middle of a lesson
  }
}

}  // namespace

TourNotes parse_tour(std::string_view bytes, const std::string& name) {
  JsonSource source = JsonSource::from_bytes(bytes, name);
  TourNotes tour = TourReader().read_tour(source);
  take_scenes(bytes, name, tour);
  return tour;
}

TourNote note_of(const Scene& scene, bool inside) {
  TourNote note;
  note.camera = scene.camera;
  if (inside) note.camera.near_mm = 0;
  note.inside = inside;
  Json json = Json::parse(to_json(scene));
  json.erase("camera");
  note.scene = json.dump();
  return note;
}

Scene TourNote::scene_over(const Scene& now, const Scene& usual) const {
  Scene result = now;
  if (!scene.empty()) {
    Scene start = usual;
    start.section.reset();   // a scene that has none does not speak of it
    if (!inside) start.headlight.reset();
    start.overlays.slab.reset();
    result = scene_from_json(scene, start, "note");
  }
  result.camera = camera;
  return result;
}

TourNotes read_tour(const std::string& file) { return parse_tour(read_file(file, most_tour_bytes), file); }

std::string to_json(const TourNotes& tour) {
  const bool plain = std::all_of(tour.notes.begin(), tour.notes.end(), [](const TourNote& note) { return note.scene.empty(); });
  Json json{{"format", format_name}, {"version", plain ? version_without_scenes : format_version}, {"title", tour.title}};
  if (!tour.model.empty()) json["model"] = tour.model;
  json["notes"] = Json::array();
  for (const TourNote& note : tour.notes) {
    const Camera& camera = note.camera;
    Json eye{{"position", json_of(camera.position)}, {"target", json_of(camera.target)}, {"up", json_of(camera.up)},
             {"field_of_view_deg", camera.field_of_view_deg}, {"height_mm", camera.height_mm}};
    if (camera.projection == Camera::Projection::parallel) eye["parallel"] = true;
    if (camera.near_mm > 0) eye["near_mm"] = camera.near_mm;
    json["notes"].push_back({{"title", note.title}, {"text", note.text}, {"inside", note.inside}, {"camera", eye}});
    if (!note.scene.empty()) json["notes"].back()["scene"] = Json::parse(note.scene);
  }
  return json.dump(2) + "\n";
}

bool named_like_a_tour(std::string_view file) {
  return file.size() > tour_ending.size() && std::equal(tour_ending.begin(), tour_ending.end(), file.end() - static_cast<std::ptrdiff_t>(tour_ending.size()),
                                                        [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? static_cast<char>(b - 'A' + 'a') : b); });
}

}  // namespace odontoscope
