#include "engine/navigate/question_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace odontoscope {

namespace {

/// Keys that a kind of question needs, and those that it may have beside "ask" and "explain".
struct KindRule {
  LessonQuestion::Kind kind;
  std::array<std::string_view, 2> needed, allowed;
};
constexpr KindRule kind_rules[] = {{LessonQuestion::Kind::click, {"structure"}, {"part"}},
                                   {LessonQuestion::Kind::choice, {"choices", "answer"}, {}},
                                   {LessonQuestion::Kind::number, {"answer"}, {"within", "unit"}}};
constexpr std::array<std::string_view, 6> kind_dependent{"structure", "part", "choices", "answer", "within", "unit"};

bool plain(const std::string& text, bool lines) {
  return std::none_of(text.begin(), text.end(), [&](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && !(lines && c == '\n')) || c == 0x7f;
  });
}

void check_title(const JsonSchema& schema, const std::string& text, std::size_t most) {
  if (text.size() > most || !plain(text, false))
    schema.refuse("bad-title", fmt::format("a title or name is longer than {} bytes or has control characters", most),
                  "Shorten it.");
}

}  // namespace

void check_lesson_text(const JsonSchema& schema, const std::string& text) {
  if (text.size() > most_text_bytes || !plain(text, true))
    schema.refuse("bad-text", fmt::format("a text is longer than {} bytes or has control characters", most_text_bytes),
                  "Shorten it, or make two notes of it.");
}

JsonField lesson_title(JsonSchema& schema, std::string_view key, const std::function<std::string&()>& where,
                       std::size_t most) {
  return schema.field(key, JsonNode::Shape::text, {.text = [&schema, where, most](const std::string& value) {
                        check_title(schema, value, most);
                        where() = value;
                      }});
}

JsonField lesson_text(JsonSchema& schema, std::string_view key, const std::function<std::string&()>& where) {
  return schema.field(key, JsonNode::Shape::text, {.text = [&schema, where](const std::string& value) {
                        check_lesson_text(schema, value);
                        where() = value;
                      }});
}

JsonField QuestionSchema::field() {
  using Q = LessonQuestion;
  const JsonRange answers{.low = -largest_answer, .high = largest_answer, .cause = "too-large"};
  JsonSchema::Fields fields = optional({
      lesson_text(schema_, "explain", member("explain", &Q::explain)),
      lesson_title(schema_, "structure", member("structure", &Q::structure)),
      lesson_title(schema_, "part", member("part", &Q::part)),
      schema_.texts("choices", "a choice", {.most = most_choices, .cause = "bad-question", .remedy = "Offer fewer."},
                    [this](const std::string& choice) {
                      check_title(schema_, choice, most_title_bytes);
                      asked().choices.push_back(choice);
                    },
                    {.opened = [this] { seen_.insert("choices"); }}),
      schema_.number("answer", member("answer", &Q::answer), answers),
      schema_.number("within", member("within", &Q::within), answers),
      lesson_title(schema_, "unit", member("unit", &Q::unit), most_unit_bytes),
  });
  fields.push_back(
      schema_.field("kind", JsonNode::Shape::text, {.text = [this](const std::string& word) { take_kind(word); }}));
  fields.push_back(lesson_text(schema_, "ask", member("ask", &Q::ask)));
  return optional(schema_.object("question", fields,
                                 {.opened =
                                      [this] {
                                        note_().question.emplace();
                                        seen_.clear();
                                      },
                                  .closed = [this] { check(); }}));
}

void QuestionSchema::take_kind(const std::string& word) {
  const auto kind = value_of(question_kinds, word);
  if (!kind)
    schema_.refuse("bad-question", fmt::format("a question's kind is \"{}\"", word.substr(0, most_unit_bytes)),
                   fmt::format("Write one of {}.", words_of(question_kinds)));
  asked().kind = *kind;
}

/// All of it was read.
void QuestionSchema::check() const {
  const char* kind = word_of(question_kinds, asked().kind);
  const KindRule& rule = *std::find_if(std::begin(kind_rules), std::end(kind_rules),
                                       [&](const KindRule& one) { return one.kind == asked().kind; });
  const auto has = [](const auto& keys, std::string_view key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  for (const std::string_view key : kind_dependent) {
    const bool needed = has(rule.needed, key);
    if (needed && !seen_.contains(key))
      schema_.refuse("missing-key", fmt::format("a question of kind \"{}\" has no \"{}\"", kind, key),
                     fmt::format("Add \"{}\".", key));
    if (!needed && !has(rule.allowed, key) && seen_.contains(key))
      schema_.refuse("unknown-key", fmt::format("a question of kind \"{}\" has no key \"{}\"", kind, key),
                     "Remove it, or correct the kind.");
  }
  if (const std::string fault = fault_of(asked()); !fault.empty())
    schema_.refuse("bad-question", "a question that cannot be answered", fault);
}

nlohmann::ordered_json json_of(const LessonQuestion& question) {
  nlohmann::ordered_json json{{"kind", word_of(question_kinds, question.kind)}, {"ask", question.ask}};
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

}  // namespace odontoscope
