#include "engine/language/language.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "engine/language/places.h"
#include "recon/core/error.h"
#include "recon/core/lower_case.h"

namespace odontoscope {

namespace {

constexpr std::string_view minus = "\xE2\x88\x92";

bool is_number(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.back())) != 0 &&
         text.find_first_not_of("0123456789.,") == text.npos;
}

/// What fills the places of `pattern` so that it becomes `text`, each as short as can be; a {count} is a number.
std::optional<std::vector<std::pair<std::string, std::string>>> fillings(std::string_view pattern,
                                                                         std::string_view text) {
  std::vector<std::pair<std::string, std::string>> found;
  std::size_t at = 0, from = 0;
  const std::vector<TextPlace> places = places_in(pattern);
  for (std::size_t i = 0; i <= places.size(); ++i) {
    const std::size_t end = i < places.size() ? places[i].begin : pattern.size();
    const std::string_view literal = pattern.substr(from, end - from);
    std::size_t here = at;
    if (i == 0) {
      if (!text.starts_with(literal)) return {};
    } else {
      const bool last = i == places.size();
      here = literal.empty() && last ? text.size()
             : last                  ? (text.ends_with(literal) ? text.size() - literal.size() : text.npos)
                                     : text.find(literal, at + 1);
      if (here == text.npos || here <= at) return {};
      if (places[i - 1].name == "count" && !is_number(text.substr(at, here - at))) return {};
      found.emplace_back(places[i - 1].name, text.substr(at, here - at));
    }
    at = here + literal.size();
    if (i < places.size()) from = places[i].end;
  }
  return at == text.size() ? std::optional(found) : std::nullopt;
}

template <class Values>
std::string filled(std::string_view text, const Values& values) {
  std::string made;
  std::size_t from = 0;
  for (const TextPlace& place : places_in(text)) {
    made += text.substr(from, place.begin - from);
    const auto value =
        std::find_if(values.begin(), values.end(), [&](const auto& one) { return one.first == place.name; });
    made += value == values.end() ? std::string(text.substr(place.begin, place.end - place.begin)) : value->second;
    from = place.end;
  }
  return made += text.substr(from);
}

}  // namespace

const char* Language::of(const char* english) const {
  const auto found = texts.find(std::string_view(english));
  return found == texts.end() ? english : found->second.c_str();
}

std::string Language::of(const std::string& english) const {
  const auto found = texts.find(english);
  return found == texts.end() ? english : found->second;
}

std::string Language::told(std::string_view english, std::initializer_list<Value> values) const {
  const auto found = texts.find(english);
  return filled(found == texts.end() ? english : std::string_view(found->second), values);
}

std::string Language::number(double value, int digits) const {
  std::string text = localised(fmt::format("{:.{}f}", std::abs(value), digits));
  const std::size_t whole = std::min(text.find(decimal), text.size());
  for (std::size_t at = whole; at > 3; at -= 3) text.insert(at - 3, group);
  return value < 0 && text.find_first_of("123456789") != text.npos ? std::string(minus) + text : text;
}

std::string Language::whole(std::size_t value) const { return number(static_cast<double>(value), 0); }

std::string Language::localised(std::string formatted) const {
  if (english()) return formatted;
  std::string made;
  for (std::size_t i = 0; i < formatted.size(); ++i) {
    const auto digit = [&](std::size_t at) {
      return at < formatted.size() && std::isdigit(static_cast<unsigned char>(formatted[at])) != 0;
    };
    const bool within = i > 0 && digit(i - 1) && digit(i + 1);
    if (within && formatted[i] == '.')
      made += decimal;
    else if (within && formatted[i] == ',' && digit(i + 2) && digit(i + 3) && !digit(i + 4))
      made += group;
    else
      made += formatted[i];
  }
  return made;
}

std::string Language::named(const std::string& english) const {
  constexpr std::string_view cavity = " cavity";
  if (const auto known = texts.find(english); known != texts.end()) return known->second;
  const std::size_t space = english.rfind(' ');
  if (space != english.npos && is_number(std::string_view(english).substr(space + 1)))
    if (const auto known = texts.find(std::string_view(english).substr(0, space)); known != texts.end())
      return known->second + english.substr(space);
  if (english.size() > cavity.size() && english.ends_with(cavity))
    return named(english.substr(0, english.size() - cavity.size())) + ": " + of("cavity");
  return english;
}

std::string Language::said(const std::string& words) const {
  if (english()) return words;
  if (const auto known = texts.find(words); known != texts.end()) return known->second;
  if (is_number(words)) return localised(words);
  std::pair<std::string_view, std::vector<std::pair<std::string, std::string>>> best;
  std::string_view form;
  for (const auto& [text, translated] : texts) {
    if (text.size() <= form.size() || !has_words_to_find(text)) continue;
    if (auto found = fillings(text, words)) {
      best = {translated, std::move(*found)};
      form = text;
    }
  }
  if (!form.empty()) {
    for (auto& [key, value] : best.second) value = said(value);
    return filled(best.first, best.second);
  }
  if (words.size() > 1 && words.ends_with('.')) {
    const std::string clause = words.substr(0, words.size() - 1), said_so = said(clause);
    if (said_so != clause) return said_so + ".";
  }
  for (const std::string_view between : {"   ", "  ", " \xE2\x86\x92 ", ". ", "; ", ", ", ": "}) {
    const std::size_t at = words.find(between);
    if (at != words.npos)
      return said(words.substr(0, at)) + std::string(between) + said(words.substr(at + between.size()));
  }
  return named(words);
}

const ErrorWords* Language::words_for_error(std::string_view message) const {
  const std::size_t open = message.rfind('[');
  if (open == message.npos || !message.ends_with(']')) return nullptr;
  const auto found = errors.find(message.substr(open + 1, message.size() - open - 2));
  return found == errors.end() ? nullptr : &found->second;
}

std::vector<Language> known_languages() {
  std::vector<Language> known(1);
  for (const EmbeddedFile& file : language_files()) known.push_back(parse_language(file.bytes, std::string(file.name)));
  return known;
}

namespace {

/// "de-at" of "de_AT.UTF-8".
std::string plain_tag(std::string_view tag) {
  std::string plain = lower_case(std::string(tag.substr(0, tag.find_first_of(".@"))));
  std::replace(plain.begin(), plain.end(), '_', '-');
  return plain;
}

std::optional<Language> language_for(std::string_view tag) {
  const std::string wanted = plain_tag(tag), first = wanted.substr(0, wanted.find('-'));
  std::vector<Language> known = known_languages();
  for (const std::string& called : {wanted, first})
    for (Language& language : known)
      if (lower_case(language.tag) == called) return std::move(language);
  return {};
}

}  // namespace

Language known_language(std::string_view tag) { return language_for(tag).value_or(Language{}); }

bool knows_language(std::string_view tag) { return language_for(tag).has_value(); }

Language language_asked(const std::string& tag_or_file) {
  if (auto known = language_for(tag_or_file)) return std::move(*known);
  if (lower_case(tag_or_file).ends_with(".json")) return read_language(tag_or_file);
  std::string tags;
  for (const Language& language : known_languages()) tags += (tags.empty() ? "" : ", ") + language.tag;
  throw UsageError(fmt::format("--language {}: no such language is known", tag_or_file),
                   fmt::format("Choose one of {}, or name a file of another (docs/formats.md)", tags));
}

std::string environment_language() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
    if (const char* said = std::getenv(name); said && *said) return said;
  return "en";
}

}  // namespace odontoscope
