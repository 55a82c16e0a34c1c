#pragma once
// The question of a note, as it stands in a lesson's file (see notes.h).

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <string_view>

#include "engine/navigate/notes.h"
#include "recon/input/json_schema.h"

namespace odontoscope {

/// A text of one line; bad-title for one that is too long or has control characters. `where` as in json_schema.h.
JsonField lesson_title(JsonSchema& schema, std::string_view key, const std::function<std::string&()>& where,
                       std::size_t most = most_title_bytes);
/// A text of several lines; else bad-text.
JsonField lesson_text(JsonSchema& schema, std::string_view key, const std::function<std::string&()>& where);
/// Refuses what is no such text.
void check_lesson_text(const JsonSchema& schema, const std::string& text);

class QuestionSchema {
 public:
  /// `note` gives the note at hand. Both must outlive what the schema reads.
  QuestionSchema(JsonSchema& schema, std::function<LessonNote&()> note) : schema_(schema), note_(std::move(note)) {}
  /// "question". Errors: bad-question, and missing-key and unknown-key of what its kind needs and does not have.
  JsonField field();

 private:
  LessonQuestion& asked() const { return *note_().question; }
  /// A member of the question, and a key that is there once it is asked for.
  template <class Value>
  auto member(std::string_view key, Value LessonQuestion::*value) {
    return [this, key, value]() -> Value& {
      seen_.insert(key);
      return asked().*value;
    };
  }
  void take_kind(const std::string& word);
  void check() const;

  JsonSchema& schema_;
  std::function<LessonNote&()> note_;
  std::set<std::string_view> seen_;  // keys of the question that is read
};

nlohmann::ordered_json json_of(const LessonQuestion& question);

}  // namespace odontoscope
