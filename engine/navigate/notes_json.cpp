#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <span>

#include "engine/navigate/notes.h"
#include "engine/navigate/question_json.h"
#include "engine/scene/scene_json.h"
#include "recon/core/read_file.h"
#include "recon/input/json_schema.h"

namespace odontoscope {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view format_name = "odontoscope.tour";
constexpr int format_version = 4, version_without_arrows = 3, version_without_questions = 2, version_without_scenes = 1;
constexpr double farthest_mm = 1e7;

constexpr NameTable<bool, 2> feedback_words{{{"at-once", false}, {"at-end", true}}};

class LessonSchema {
 public:
  explicit LessonSchema(const std::string& name) : name_(name) {
    schema_.document(
        format_name, {version_without_scenes, format_version},
        {lesson_title(schema_, "title", in(lesson_.title)),
         optional(lesson_title(schema_, "model", in(lesson_.model), 4096)), optional(tag(in(lesson_.language))),
         optional(schema_.word("feedback", lesson_.feedback_at_end, feedback_words)), optional(translations()),
         schema_.list("notes", "a note", lesson_.notes,
                      {.most = most_notes, .cause = "too-many-notes", .remedy = "Make two tours of it."},
                      note_fields())},
        {.closed = [this] {
          if (lesson_.notes.empty()) schema_.refuse("no-notes", "the tour has no notes", "Save one from the viewer.");
        }});
  }
  Lesson read(std::string_view bytes) {
    schema_.read(bytes, name_);
    return std::move(lesson_);
  }

 private:
  LessonNote& note() { return lesson_.notes.back(); }
  static std::function<std::string&()> in(std::string& text) {
    return [&text]() -> auto& { return text; };
  }

  /// A place in millimetres.
  template <class Where>
  JsonField place(std::string_view key, Where where) {
    return schema_.numbers(key, 3, [this, where](std::span<const double> xyz) {
      for (const double value : xyz)
        if (std::abs(value) > farthest_mm)
          schema_.refuse("too-large", fmt::format("{} mm lies beyond {} mm", value, farthest_mm), "Check the unit.");
      where() = {xyz[0], xyz[1], xyz[2]};
    });
  }
  JsonField tag(const std::function<std::string&()>& where) {
    return schema_.field(
        "language", JsonNode::Shape::text, {.text = [this, where](const std::string& value) {
          const auto fits = [](char c) { return c == '-' || std::isalnum(static_cast<unsigned char>(c)); };
          if (value.empty() || value.size() > most_language_bytes || !std::all_of(value.begin(), value.end(), fits))
            schema_.refuse("bad-value", "\"language\" is no tag of letters, digits and hyphens",
                           "Write a tag such as \"en\".");
          where() = value;
        }});
  }
  JsonSchema::Fields note_fields() {
    const auto note = last(lesson_.notes);
    return {lesson_title(schema_, "title", of(note, &LessonNote::title)),
            lesson_text(schema_, "text", of(note, &LessonNote::text)),
            optional(schema_.flag("inside", of(note, &LessonNote::inside))),
            camera(),
            optional(schema_.field("scene", JsonNode::Shape::kept,
                                   {.text = [this](const std::string& json) { take_scene(json); }})),
            optional(marks()),
            question_.field(),
            optional(lesson_title(schema_, "tour", of(note, &LessonNote::tour))),
            optional(arrows()),
            optional(lesson_text(schema_, "narration", of(note, &LessonNote::narration)))};
  }
  JsonField camera() {
    const auto camera = of(last(lesson_.notes), &LessonNote::camera);
    JsonSchema::Fields fields =
        optional({schema_.number("field_of_view_deg", of(camera, &Camera::field_of_view_deg)),
                  schema_.number("height_mm", of(camera, &Camera::height_mm)),
                  schema_.number("near_mm", of(camera, &Camera::near_mm)),
                  schema_.field("parallel", JsonNode::Shape::boolean, {.boolean = [camera](bool parallel) {
                                  if (parallel) camera().projection = Camera::Projection::parallel;
                                }})});
    fields.push_back(place("position", of(camera, &Camera::position)));
    fields.push_back(place("target", of(camera, &Camera::target)));
    fields.push_back(place("up", of(camera, &Camera::up)));
    return schema_.object("camera", fields, {.closed = [this, camera] { validate(camera(), name_); }});
  }
  JsonField marks() {
    const auto marks = of(last(lesson_.notes), &LessonNote::marks);
    const auto mark = [marks]() -> LessonPin& { return marks().back(); };
    return schema_.list(
        "marks", "a mark", marks, {.most = most_marks, .cause = "too-many-marks", .remedy = "Make two notes of it."},
        {place("at", of(mark, &LessonPin::at)), optional(lesson_title(schema_, "label", of(mark, &LessonPin::label)))});
  }
  JsonField arrows() {
    const auto arrows = of(last(lesson_.notes), &LessonNote::arrows);
    const auto arrow = [arrows]() -> LessonArrow& { return arrows().back(); };
    return schema_.list("arrows", "an arrow", arrows,
                        {.most = most_arrows, .cause = "too-many-arrows", .remedy = "Make two notes of it."},
                        {place("from", of(arrow, &LessonArrow::from)), place("to", of(arrow, &LessonArrow::to)),
                         optional(lesson_title(schema_, "label", of(arrow, &LessonArrow::label)))},
                        [this, arrow] { check(arrow()); });
  }
  JsonField translations() {
    const auto translation = last(lesson_.translations);
    return schema_.list(
        "translations", "a translation", lesson_.translations,
        {.most = most_translations, .cause = "too-many-texts", .remedy = "Leave some out."},
        {tag(of(translation, &LessonTranslation::language)),
         schema_.rows("texts", "a pair of texts", 2,
                      {.most = most_translated_texts, .cause = "too-many-texts", .remedy = "Leave some out."},
                      [this](std::span<const std::string> pair) {
                        for (const std::string& text : pair) check_lesson_text(schema_, text);
                        lesson_.translations.back().texts.emplace_back(pair[0], pair[1]);
                      })},
        [this] { check_translation(); });
  }
  /// Scenes have a reader of their own.
  void take_scene(const std::string& json) {
    Json scene = Json::parse(json);
    if (scene.is_object()) scene.erase("camera");
    note().scene = scene.dump();
    scene_from_json(
        note().scene, Scene{},
        fmt::format("{}, note {}", name_, lesson_.notes.size()));  // refused now rather than in the middle of a lesson
  }
  void check(const LessonArrow& read) const {
    if (glm::distance(read.from, read.to) < least_arrow_mm)
      schema_.refuse("bad-arrow", "an arrow that ends where it begins",
                     fmt::format("Put its ends at least {} mm apart, or remove it.", least_arrow_mm));
  }
  void check_translation() const {
    const auto& all = lesson_.translations;
    if (std::any_of(all.begin(), all.end() - 1,
                    [&](const LessonTranslation& one) { return one.language == all.back().language; }))
      schema_.refuse("repeated-text", fmt::format("two translations are into \"{}\"", all.back().language),
                     "Make one of them.");
  }

  std::string name_;
  Lesson lesson_;
  JsonSchema schema_{"a tour"};
  QuestionSchema question_{schema_, last(lesson_.notes)};
};

Json json_of(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

}  // namespace

Lesson parse_lesson(std::string_view bytes, const std::string& name) { return LessonSchema(name).read(bytes); }

Lesson read_lesson(const std::string& file) { return parse_lesson(read_file(file, most_lesson_bytes), file); }

namespace {

int version_of(const Lesson& lesson) {
  const auto any = [&](auto&& has) { return std::any_of(lesson.notes.begin(), lesson.notes.end(), has); };
  if (!lesson.translations.empty()) return format_version;
  if (any([](const LessonNote& note) { return !note.arrows.empty() || !note.narration.empty(); }))
    return format_version;
  if (!lesson.language.empty() || lesson.feedback_at_end ||
      any([](const LessonNote& note) { return !note.marks.empty() || note.question || !note.tour.empty(); }))
    return version_without_arrows;
  return any([](const LessonNote& note) { return !note.scene.empty(); }) ? version_without_questions
                                                                         : version_without_scenes;
}

}  // namespace

std::string to_json(const Lesson& lesson) {
  Json json{{"format", format_name}, {"version", version_of(lesson)}, {"title", lesson.title}};
  if (!lesson.model.empty()) json["model"] = lesson.model;
  if (!lesson.language.empty()) json["language"] = lesson.language;
  if (lesson.feedback_at_end) json["feedback"] = "at-end";
  for (const LessonTranslation& one : lesson.translations) {
    json["translations"].push_back({{"language", one.language}, {"texts", Json::array()}});
    for (const auto& [text, words] : one.texts) json["translations"].back()["texts"].push_back({text, words});
  }
  json["notes"] = Json::array();
  for (const LessonNote& note : lesson.notes) {
    const Camera& camera = note.camera;
    Json eye{{"position", json_of(camera.position)},
             {"target", json_of(camera.target)},
             {"up", json_of(camera.up)},
             {"field_of_view_deg", camera.field_of_view_deg},
             {"height_mm", camera.height_mm}};
    if (camera.projection == Camera::Projection::parallel) eye["parallel"] = true;
    if (camera.near_mm > 0) eye["near_mm"] = camera.near_mm;
    json["notes"].push_back({{"title", note.title}, {"text", note.text}, {"inside", note.inside}, {"camera", eye}});
    Json& written = json["notes"].back();
    if (!note.scene.empty()) written["scene"] = Json::parse(note.scene);
    for (const LessonPin& mark : note.marks)
      written["marks"].push_back({{"at", json_of(mark.at)}, {"label", mark.label}});
    for (const LessonArrow& one : note.arrows)
      written["arrows"].push_back({{"from", json_of(one.from)}, {"to", json_of(one.to)}, {"label", one.label}});
    if (!note.narration.empty()) written["narration"] = note.narration;
    if (note.question) written["question"] = json_of(*note.question);
    if (!note.tour.empty()) written["tour"] = note.tour;
  }
  return json.dump(2) + "\n";
}

}  // namespace odontoscope
