#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/language/language.h"
#include "engine/language/places.h"
#include "recon/core/read_file.h"
#include "recon/input/strict_json.h"

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

enum LanguageNode {
  whole_file,
  format_node,
  version_node,
  tag_node,
  name_node,
  decimal_node,
  group_node,
  texts_node,
  pair_node,
  text_node,
  errors_node,
  error_node,
  error_text_node
};

using Shape = JsonNode::Shape;
constexpr JsonNode::Key file_keys[] = {{"format", format_node, true},   {"version", version_node, true},
                                       {"language", tag_node, true},    {"name", name_node, true},
                                       {"decimal", decimal_node, true}, {"group", group_node, true},
                                       {"texts", texts_node, true},     {"errors", errors_node, false}};
constexpr JsonNode language_nodes[] = {
    {Shape::object, "a language", -1, file_keys},
    {Shape::text, "\"format\""},
    {Shape::number, "\"version\""},
    {Shape::text, "\"language\""},
    {Shape::text, "\"name\""},
    {Shape::text, "\"decimal\""},
    {Shape::text, "\"group\""},
    {Shape::array, "\"texts\"", pair_node},
    {Shape::array, "a pair of texts", text_node},
    {Shape::text, "a text"},
    {Shape::array, "\"errors\"", error_node},
    {Shape::array, "words for an error", error_text_node},
    {Shape::text, "a text"},
};

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

class LanguageReader final : public StrictJson {
 public:
  LanguageReader() : StrictJson(language_nodes) {}

  Language read_language(JsonSource& source) {
    read(source);
    return std::move(language_);
  }

 private:
  void opened(int node) override {
    if (node == pair_node || node == error_node) pair_.clear();
  }
  void number(int node, double value) override {
    if (node == version_node && value != language_version)
      refuse("wrong-version",
             fmt::format("version {} of the format, but this program reads version {}", value, language_version),
             "Use a newer odontoscope, or version 1.");
  }
  void text(int node, const std::string& value) override {
    switch (node) {
      case format_node:
        if (value != language_format)
          refuse("wrong-format", fmt::format("the format is not \"{}\"", language_format),
                 "Check that this is the file you mean.");
        break;
      case tag_node:
        if (!is_tag(value)) refuse("bad-language", "\"language\" is no tag such as \"de\" or \"pt-BR\"", "Correct it.");
        language_.tag = value;
        break;
      case name_node:
        if (!is_plain(value, 60))
          refuse("bad-language", "\"name\" is empty or too long", "Write the language's own name for itself.");
        language_.name = value;
        break;
      case decimal_node:
      case group_node:
        if (!is_plain(value, 4) || value.find_first_of("0123456789\n") != value.npos)
          refuse("bad-language", "a sign between digits is none", "Write \",\" or \".\", or a space.");
        (node == decimal_node ? language_.decimal : language_.group) = value;
        break;
      default:
        if (!is_plain(value, longest_language_text))
          refuse("bad-text",
                 fmt::format("a text is empty, has control characters, or more than {} bytes", longest_language_text),
                 "Correct it.");
        pair_.push_back(value);
    }
  }
  void closed(int node) override {
    if (node == whole_file && language_.decimal == language_.group)
      refuse("bad-language", "\"decimal\" and \"group\" are the same", "Correct one.");
    if (node == error_node) add_error();
    if (node == pair_node) add_pair();
  }
  void add_error() {
    if (pair_.size() != 3 || !is_cause(pair_[0]))
      refuse("bad-text", "words for an error are three texts: its cause, the rule, and what to do", "Correct it.");
    if (language_.errors.size() == most_language_errors)
      refuse("too-many-texts", fmt::format("more than {} errors", most_language_errors),
             "Keep those that the program has.");
    if (!language_.errors.emplace(pair_[0], ErrorWords{pair_[1], pair_[2]}).second)
      refuse("repeated-text", fmt::format("\"{}\" comes twice", pair_[0]), "Leave one out.");
  }
  void add_pair() {
    if (pair_.size() != 2)
      refuse("bad-text", "a pair of texts has two: the English one, and its words in this language", "Correct it.");
    if (names_of_places(pair_[0]) != names_of_places(pair_[1]))
      refuse("bad-text", fmt::format("what stands in braces is not the same in \"{}\" and \"{}\"", pair_[0], pair_[1]),
             "Leave what stands in braces as it is; its place may change.");
    if (language_.texts.size() == most_language_texts)
      refuse("too-many-texts", fmt::format("more than {} texts", most_language_texts),
             "Keep those that the program has.");
    if (!language_.texts.emplace(pair_[0], pair_[1]).second)
      refuse("repeated-text", fmt::format("\"{}\" comes twice", pair_[0]), "Leave one out.");
  }

  Language language_;
  std::vector<std::string> pair_;
};

}  // namespace

Language parse_language(std::string_view bytes, const std::string& name) {
  JsonSource source = JsonSource::from_bytes(bytes, name);
  return LanguageReader().read_language(source);
}

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
