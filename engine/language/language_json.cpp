#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "engine/language/language.h"
#include "engine/language/places.h"
#include "recon/core/read_file.h"
#include "recon/input/json_schema.h"

namespace odontoscope {

std::vector<TextPlace> places_in(std::string_view text) {
  std::vector<TextPlace> places;
  for (std::size_t at = text.find('{'); at != text.npos; at = text.find('{', at + 1)) {
    const std::size_t end =
        text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_", at + 1);
    if (end != text.npos && end > at + 1 && text[end] == '}')
      places.push_back({at, end + 1, std::string(text.substr(at + 1, end - at - 1))});
  }
  return places;
}

bool has_words_to_find(std::string_view text) {
  const std::vector<TextPlace> places = places_in(text);
  std::size_t rest = text.size();
  for (const TextPlace& place : places) rest -= place.end - place.begin;
  return !places.empty() && rest > 2;
}

namespace {

constexpr std::string_view language_format = "odontoscope.language";
constexpr int language_version = 1;

std::vector<std::string> names_of_places(std::string_view text) {
  std::vector<std::string> names;
  for (const TextPlace& place : places_in(text)) names.push_back(place.name);
  std::sort(names.begin(), names.end());
  return names;
}

bool is_tag(const std::string& tag) {
  return !tag.empty() && tag.size() <= 35 && std::all_of(tag.begin(), tag.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  });
}

bool is_cause(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
}

bool is_plain(const std::string& text, std::size_t longest) {
  return !text.empty() && text.size() <= longest && std::none_of(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f;
  });
}

/// Between digits.
bool is_sign(const std::string& text) { return is_plain(text, 4) && text.find_first_of("0123456789\n") == text.npos; }

class LanguageSchema {
 public:
  LanguageSchema() {
    const JsonLength texts{
        .most = most_language_texts, .cause = "too-many-texts", .remedy = "Keep those that the program has."},
        errors{.most = most_language_errors, .cause = "too-many-texts", .remedy = "Keep those that the program has."};
    schema_.document(
        language_format, {language_version, language_version},
        {text("language", language_.tag, is_tag, "is no tag such as \"de\" or \"pt-BR\""),
         text(
             "name", language_.name, [](const std::string& name) { return is_plain(name, 60); },
             "is not the language's own name for itself, of at most 60 bytes"),
         text("decimal", language_.decimal, is_sign, "is no sign between digits, such as \",\", \".\" or a space"),
         text("group", language_.group, is_sign, "is no sign between digits, such as \",\", \".\" or a space"),
         schema_.rows("texts", "a pair of texts (the English one, and its words in this language)", 2, texts,
                      [this](std::span<const std::string> pair) { add_pair(pair); }),
         optional(schema_.rows("errors", "words for an error (its cause, the rule, and what to do)", 3, errors,
                               [this](std::span<const std::string> words) { add_error(words); }))},
        {.closed = [this] {
          if (language_.decimal == language_.group)
            schema_.refuse("bad-language", "\"decimal\" and \"group\" are the same", "Correct one.");
        }});
  }
  Language read(std::string_view bytes, const std::string& name) {
    schema_.read(bytes, name);
    return std::move(language_);
  }

 private:
  JsonField text(std::string_view key, std::string& where, bool (*fits)(const std::string&), std::string_view wrong) {
    return schema_.field(key, JsonNode::Shape::text,
                         {.text = [this, key, &where, fits, wrong](const std::string& value) {
                           if (!fits(value))
                             schema_.refuse("bad-language", fmt::format("\"{}\" {}", key, wrong), "Correct it.");
                           where = value;
                         }});
  }
  void check(std::span<const std::string> texts) const {
    for (const std::string& text : texts)
      if (!is_plain(text, longest_language_text))
        schema_.refuse(
            "bad-text",
            fmt::format("a text is empty, has control characters, or more than {} bytes", longest_language_text),
            "Correct it.");
  }
  void add_error(std::span<const std::string> words) {
    check(words);
    if (!is_cause(words[0]))
      schema_.refuse("bad-text", fmt::format("\"{}\" is no cause of an error", words[0]), "Correct it.");
    if (!language_.errors.emplace(words[0], ErrorWords{words[1], words[2]}).second) refuse_repeated(words[0]);
  }
  void add_pair(std::span<const std::string> pair) {
    check(pair);
    if (names_of_places(pair[0]) != names_of_places(pair[1]))
      schema_.refuse("bad-text",
                     fmt::format("what stands in braces is not the same in \"{}\" and \"{}\"", pair[0], pair[1]),
                     "Leave what stands in braces as it is; its place may change.");
    if (!language_.texts.emplace(pair[0], pair[1]).second) refuse_repeated(pair[0]);
  }
  [[noreturn]] void refuse_repeated(const std::string& text) const {
    schema_.refuse("repeated-text", fmt::format("\"{}\" comes twice", text), "Leave one out.");
  }

  Language language_;
  JsonSchema schema_{"a language"};
};

}  // namespace

Language parse_language(std::string_view bytes, const std::string& name) { return LanguageSchema().read(bytes, name); }

Language read_language(const std::string& file) {
  return parse_language(read_file(file, most_language_file_bytes), file);
}

std::string to_json(const Language& language) {
  nlohmann::ordered_json texts = nlohmann::ordered_json::array();
  for (const auto& [english, words] : language.texts) texts.push_back({english, words});
  nlohmann::ordered_json json{{"format", language_format},
                              {"version", language_version},
                              {"language", language.tag},
                              {"name", language.name},
                              {"decimal", language.decimal},
                              {"group", language.group},
                              {"texts", texts}};
  for (const auto& [cause, words] : language.errors) json["errors"].push_back({cause, words.rule, words.remedy});
  return json.dump();
}

}  // namespace odontoscope
