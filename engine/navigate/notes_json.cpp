#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/navigate/notes.h"
#include "engine/scene/scene_json.h"
#include "recon/core/read_file.h"
#include "recon/input/strict_json.h"

namespace odontoscope {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view format_name = "odontoscope.tour";
constexpr int format_version = 4, version_without_arrows = 3, version_without_questions = 2, version_without_scenes = 1;
constexpr double farthest_mm = 1e7;

enum Node {
  document,
  format,
  version,
  title,
  model,
  notes,
  note,
  note_title,
  note_text,
  note_inside,
  note_scene,
  camera,
  position,
  target,
  up,
  coordinate,
  angle,
  height,
  near,
  parallel,
  language,
  feedback,
  note_tour,
  marks,
  mark,
  mark_at,
  mark_label,
  question,
  kind,
  ask,
  explain,
  structure,
  part,
  choices,
  a_choice,
  answer,
  within,
  unit,
  arrows,
  arrow,
  arrow_from,
  arrow_to,
  arrow_label,
  narration,
  translations,
  translation,
  tongue,
  translated_texts,
  translated_pair,
  translated_text
};

using Shape = JsonNode::Shape;
constexpr JsonNode::Key document_keys[] = {{"format", format, true},      {"version", version, true},
                                           {"title", title, true},        {"model", model, false},
                                           {"notes", notes, true},        {"language", language, false},
                                           {"feedback", feedback, false}, {"translations", translations, false}};
constexpr JsonNode::Key note_keys[] = {{"title", note_title, true},    {"text", note_text, true},
                                       {"inside", note_inside, false}, {"camera", camera, true},
                                       {"scene", note_scene, false},   {"marks", marks, false},
                                       {"question", question, false},  {"tour", note_tour, false},
                                       {"arrows", arrows, false},      {"narration", narration, false}};
constexpr JsonNode::Key camera_keys[] = {
    {"position", position, true},        {"target", target, true},     {"up", up, true},
    {"field_of_view_deg", angle, false}, {"height_mm", height, false}, {"near_mm", near, false},
    {"parallel", parallel, false}};
constexpr JsonNode::Key mark_keys[] = {{"at", mark_at, true}, {"label", mark_label, false}};
constexpr JsonNode::Key translation_keys[] = {{"language", tongue, true}, {"texts", translated_texts, true}};
constexpr JsonNode::Key arrow_keys[] = {
    {"from", arrow_from, true}, {"to", arrow_to, true}, {"label", arrow_label, false}};
constexpr JsonNode::Key question_keys[] = {
    {"kind", kind, true},  {"ask", ask, true},          {"explain", explain, false}, {"structure", structure, false},
    {"part", part, false}, {"choices", choices, false}, {"answer", answer, false},   {"within", within, false},
    {"unit", unit, false}};
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
    {Shape::text, "\"language\""},
    {Shape::text, "\"feedback\""},
    {Shape::text, "\"tour\""},
    {Shape::array, "\"marks\"", mark},
    {Shape::object, "a mark", -1, mark_keys},
    {Shape::array, "\"at\"", coordinate},
    {Shape::text, "\"label\""},
    {Shape::object, "a question", -1, question_keys},
    {Shape::text, "\"kind\""},
    {Shape::text, "\"ask\""},
    {Shape::text, "\"explain\""},
    {Shape::text, "\"structure\""},
    {Shape::text, "\"part\""},
    {Shape::array, "\"choices\"", a_choice},
    {Shape::text, "a choice"},
    {Shape::number, "\"answer\""},
    {Shape::number, "\"within\""},
    {Shape::text, "\"unit\""},
    {Shape::array, "\"arrows\"", arrow},
    {Shape::object, "an arrow", -1, arrow_keys},
    {Shape::array, "\"from\"", coordinate},
    {Shape::array, "\"to\"", coordinate},
    {Shape::text, "\"label\""},
    {Shape::text, "\"narration\""},
    {Shape::array, "\"translations\"", translation},
    {Shape::object, "a translation", -1, translation_keys},
    {Shape::text, "\"language\""},
    {Shape::array, "\"texts\"", translated_pair},
    {Shape::array, "a pair of texts", translated_text},
    {Shape::text, "a text"},
};

/// Keys that a kind of question needs, and those that it may have beside "ask" and "explain".
struct KindRule {
  std::string_view name;
  LessonQuestion::Kind kind;
  std::vector<Node> needed, allowed;
};
const std::array<KindRule, 3>& kind_rules() {
  static const std::array<KindRule, 3> rules = {{{"click", LessonQuestion::Kind::click, {structure}, {part}},
                                                 {"choice", LessonQuestion::Kind::choice, {choices, answer}, {}},
                                                 {"number", LessonQuestion::Kind::number, {answer}, {within, unit}}}};
  return rules;
}
constexpr Node kind_dependent[] = {structure, part, choices, answer, within, unit};

bool plain(const std::string& text, bool lines) {
  return std::none_of(text.begin(), text.end(), [&](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && !(lines && c == '\n')) || c == 0x7f;
  });
}

class LessonReader final : public StrictJson {
 public:
  LessonReader() : StrictJson(nodes) {}

  Lesson read_lesson(JsonSource& source) {
    read(source);
    if (tour_.notes.empty()) refuse("no-notes", "the tour has no notes", "Save one from the viewer.");
    return std::move(tour_);
  }

 private:
  void opened(int node) override {
    if (node == note) {
      if (tour_.notes.size() == most_notes)
        refuse("too-many-notes", fmt::format("more than {} notes", most_notes), "Make two tours of it.");
      tour_.notes.emplace_back();
    }
    if (node == mark) {
      if (tour_.notes.back().marks.size() == most_marks)
        refuse("too-many-marks", fmt::format("a note with more than {} marks", most_marks), "Make two notes of it.");
      tour_.notes.back().marks.emplace_back();
    }
    if (node == translation) {
      if (tour_.translations.size() == most_translations)
        refuse("too-many-texts", fmt::format("more than {} translations", most_translations), "Leave some out.");
      tour_.translations.emplace_back();
    }
    if (node == translated_pair) open_pair();
    if (node == arrow) {
      if (tour_.notes.back().arrows.size() == most_arrows)
        refuse("too-many-arrows", fmt::format("a note with more than {} arrows", most_arrows), "Make two notes of it.");
      tour_.notes.back().arrows.emplace_back();
    }
    if (node == question) {
      tour_.notes.back().question.emplace();
      seen_.clear();
      kind_ = nullptr;
    }
    if (node == choices) seen_.insert(choices);
    if (is_place(node)) {
      vector_ = node;
      coordinates_ = 0;
    }
  }
  void closed(int node) override {
    if (is_place(node) && coordinates_ != 3) refuse("wrong-type", "a place has three coordinates", "Write [x, y, z].");
    if (node == camera) validate(tour_.notes.back().camera, place().file);
    if (node == question) check_question();
    if (node == arrow) check_arrow();
    if (node == translated_pair && pair_.size() != 2) refuse_pair();
    if (node == translated_pair) tour_.translations.back().texts.emplace_back(pair_[0], pair_[1]);
    if (node == translation) check_translation();
  }
  static bool is_place(int node) {
    return node == position || node == target || node == up || node == mark_at || node == arrow_from ||
           node == arrow_to;
  }
  glm::dvec3& place_read() {
    LessonNote& note = tour_.notes.back();
    if (vector_ == mark_at) return note.marks.back().at;
    if (vector_ == arrow_from) return note.arrows.back().from;
    if (vector_ == arrow_to) return note.arrows.back().to;
    return vector_ == position ? note.camera.position : vector_ == target ? note.camera.target : note.camera.up;
  }
  void number(int node, double value) override {
    if (node == version) {
      if (value != std::floor(value) || value < version_without_scenes || value > format_version)
        refuse("wrong-version",
               fmt::format("version {} of the format, but this program reads versions {} to {}", value,
                           version_without_scenes, format_version),
               "Write the file anew with a matching program.");
      return;
    }
    if (node == answer || node == within) {
      if (std::abs(value) > largest_answer)
        refuse("too-large", fmt::format("an answer of {} lies beyond {}", value, largest_answer),
               "Ask for it in a larger unit.");
      seen_.insert(node);
      (node == answer ? tour_.notes.back().question->answer : tour_.notes.back().question->within) = value;
      return;
    }
    Camera& camera = tour_.notes.back().camera;
    if (node == angle)
      camera.field_of_view_deg = value;
    else if (node == height)
      camera.height_mm = value;
    else if (node == near)
      camera.near_mm = value;
    else {
      if (coordinates_ == 3) refuse("wrong-type", "a place has three coordinates, this one more", "Write [x, y, z].");
      if (std::abs(value) > farthest_mm)
        refuse("too-large", fmt::format("{} mm lies beyond {} mm", value, farthest_mm), "Check the unit.");
      place_read()[coordinates_++] = value;
    }
  }
  void boolean(int node, bool value) override {
    if (node == note_inside)
      tour_.notes.back().inside = value;
    else if (value)
      tour_.notes.back().camera.projection = Camera::Projection::parallel;
  }
  void text(int node, const std::string& value) override {
    switch (node) {
      case format:
        if (value != format_name)
          refuse("wrong-format", fmt::format("the format is not \"{}\"", format_name),
                 "Check that this is the file you mean.");
        return;
      case title:
        tour_.title = checked_title(value);
        return;
      case model:
        tour_.model = checked_title(value, 4096);
        return;
      case note_title:
        tour_.notes.back().title = checked_title(value);
        return;
      case note_text:
        tour_.notes.back().text = checked_text(value);
        return;
      case note_tour:
        tour_.notes.back().tour = checked_title(value);
        return;
      case mark_label:
        tour_.notes.back().marks.back().label = checked_title(value);
        return;
      case arrow_label:
        tour_.notes.back().arrows.back().label = checked_title(value);
        return;
      case narration:
        tour_.notes.back().narration = checked_text(value);
        return;
      case language:
        tour_.language = checked_tag(value);
        return;
      case tongue:
        tour_.translations.back().language = checked_tag(value);
        return;
      case translated_text:
        if (pair_.size() == 2) refuse_pair();
        pair_.push_back(checked_text(value));
        return;
      case feedback:
        if (value != "at-once" && value != "at-end")
          refuse("bad-value", "\"feedback\" is neither \"at-once\" nor \"at-end\"", "Write one of the two.");
        tour_.feedback_at_end = value == "at-end";
        return;
      default:
        question_text(node, value);
        return;
    }
  }
  void question_text(int node, const std::string& value) {
    LessonQuestion& asked = *tour_.notes.back().question;
    seen_.insert(node);
    switch (node) {
      case kind:
        for (const KindRule& rule : kind_rules())
          if (rule.name == value) kind_ = &rule;
        if (!kind_)
          refuse("bad-question", fmt::format("a question's kind is \"{}\"", value.substr(0, most_unit_bytes)),
                 "Write \"click\", \"choice\" or \"number\".");
        asked.kind = kind_->kind;
        return;
      case ask:
        asked.ask = checked_text(value);
        return;
      case explain:
        asked.explain = checked_text(value);
        return;
      case structure:
        asked.structure = checked_title(value);
        return;
      case part:
        asked.part = checked_title(value);
        return;
      case unit:
        asked.unit = checked_title(value, most_unit_bytes);
        return;
      default:
        break;
    }
    if (asked.choices.size() == most_choices)
      refuse("bad-question", fmt::format("a question with more than {} choices", most_choices), "Offer fewer.");
    asked.choices.push_back(checked_title(value));
  }
  /// All of it was read.
  void check_question() const {
    const LessonQuestion& asked = *tour_.notes.back().question;
    const auto name = [](Node key) { return nodes[key].what; };
    for (const Node key : kind_dependent) {
      const bool needed = std::count(kind_->needed.begin(), kind_->needed.end(), key) > 0,
                 allowed = std::count(kind_->allowed.begin(), kind_->allowed.end(), key) > 0;
      if (needed && !seen_.contains(key))
        refuse("missing-key", fmt::format("a question of kind \"{}\" has no {}", kind_->name, name(key)),
               fmt::format("Add {}.", name(key)));
      if (!needed && !allowed && seen_.contains(key))
        refuse("unknown-key", fmt::format("a question of kind \"{}\" has no key {}", kind_->name, name(key)),
               "Remove it, or correct the kind.");
    }
    if (const std::string fault = fault_of(asked); !fault.empty())
      refuse("bad-question", "a question that cannot be answered", fault);
  }
  void open_pair() {
    if (tour_.translations.back().texts.size() == most_translated_texts)
      refuse("too-many-texts", fmt::format("more than {} texts", most_translated_texts), "Leave some out.");
    pair_.clear();
  }
  [[noreturn]] void refuse_pair() const {
    refuse("bad-text", "a pair of texts has two: that of the lesson, and its words in this language", "Correct it.");
  }
  void check_translation() const {
    const auto& all = tour_.translations;
    if (std::any_of(all.begin(), all.end() - 1,
                    [&](const LessonTranslation& one) { return one.language == all.back().language; }))
      refuse("repeated-text", fmt::format("two translations are into \"{}\"", all.back().language),
             "Make one of them.");
  }
  std::string checked_tag(const std::string& value) const {
    if (value.empty() || value.size() > most_language_bytes || !std::all_of(value.begin(), value.end(), [](char c) {
          return c == '-' || std::isalnum(static_cast<unsigned char>(c));
        }))
      refuse("bad-value", "\"language\" is no tag of letters, digits and hyphens", "Write a tag such as \"en\".");
    return value;
  }
  void check_arrow() const {
    const LessonArrow& read = tour_.notes.back().arrows.back();
    if (glm::distance(read.from, read.to) < least_arrow_mm)
      refuse("bad-arrow", "an arrow that ends where it begins",
             fmt::format("Put its ends at least {} mm apart, or remove it.", least_arrow_mm));
  }
  std::string checked_text(const std::string& value) const {
    if (value.size() > most_text_bytes || !plain(value, true))
      refuse("bad-text", fmt::format("a text is longer than {} bytes or has control characters", most_text_bytes),
             "Shorten it, or make two notes of it.");
    return value;
  }
  std::string checked_title(const std::string& value, std::size_t most = most_title_bytes) const {
    if (value.size() > most || !plain(value, false))
      refuse("bad-title", fmt::format("a title or name is longer than {} bytes or has control characters", most),
             "Shorten it.");
    return value;
  }
  void add_place(Place&) const override {}

  Lesson tour_;
  const KindRule* kind_ = nullptr;  // of the question that is read,
  std::set<int> seen_;              // and its keys
  std::vector<std::string> pair_;   // of texts
  int vector_ = position;
  glm::length_t coordinates_ = 0;
};

Json json_of(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

/// Scenes have a reader of their own. `bytes` are known to be a lesson, and nowhere nested deeply.
void take_scenes(std::string_view bytes, const std::string& name, Lesson& lesson) {
  const Json json = Json::parse(bytes, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) throw InternalError("a tour that was read cannot be read again");
  for (std::size_t i = 0; i < lesson.notes.size(); ++i) {
    const Json& note = json["notes"][i];
    const auto found = note.find("scene");
    if (found == note.end()) continue;
    Json scene = *found;
    if (scene.is_object()) scene.erase("camera");
    lesson.notes[i].scene = scene.dump();
    scene_from_json(lesson.notes[i].scene, Scene{},
                    fmt::format("{}, note {}", name, i + 1));  // refused now rather than in the middle of a lesson
  }
}

}  // namespace

Lesson parse_lesson(std::string_view bytes, const std::string& name) {
  JsonSource source = JsonSource::from_bytes(bytes, name);
  Lesson lesson = LessonReader().read_lesson(source);
  take_scenes(bytes, name, lesson);
  return lesson;
}

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

Json json_of(const LessonQuestion& question) {
  const KindRule& rule = *std::find_if(kind_rules().begin(), kind_rules().end(),
                                       [&](const KindRule& one) { return one.kind == question.kind; });
  Json json{{"kind", rule.name}, {"ask", question.ask}};
  switch (question.kind) {
    case LessonQuestion::Kind::click:
      json["structure"] = question.structure;
      if (!question.part.empty()) json["part"] = question.part;
      break;
    case LessonQuestion::Kind::choice:
      json["choices"] = question.choices;
      json["answer"] = static_cast<int>(question.answer);
      break;
    case LessonQuestion::Kind::number:
      json["answer"] = question.answer;
      json["within"] = question.within;
      if (!question.unit.empty()) json["unit"] = question.unit;
      break;
  }
  if (!question.explain.empty()) json["explain"] = question.explain;
  return json;
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
