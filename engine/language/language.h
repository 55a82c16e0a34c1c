#pragma once
// The words of viewer, page and lessons in another language, as data: assets/languages holds a file each, others may be
// given by their users.
//
//   {"format":"odontoscope.language","version":1,"language":"de","name":"Deutsch","decimal":",","group":".",
//    "texts":[["Fly inside","Hineinfliegen"],["Step {step} of {steps}","Schritt {step} von {steps}"]]}
//
// "errors", which may be left out, says of the causes of docs/formats.md what rule was broken, and what to do:
//   "errors":[["too-few-points","Eine Kontur hat mindestens drei Punkte.","Entfernen Sie die Kontur."]]
// In the code texts stand in English, and so they are looked up; what has no words in a language is said in English.
// What stands in braces is filled in: both must have the same. web/source/language.js does the same with the same
// files.

#include <cstddef>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recon/core/embedded_file.h"

namespace odontoscope {

/// Of a cause (InputError::cause), in sentences.
struct ErrorWords {
  std::string rule, remedy;
  friend bool operator==(const ErrorWords&, const ErrorWords&) = default;
};

struct Language {
  std::string tag = "en", name = "English", decimal = ".", group = ",";
  std::map<std::string, std::string, std::less<>> texts = {};  // by the English ones

  std::map<std::string, ErrorWords, std::less<>> errors = {};  // by their causes

  using Value = std::pair<std::string_view, std::string>;

  /// What stands for the English text; itself where there is nothing. The pointer lives as long as both.
  const char* of(const char* english) const;
  std::string of(const std::string& english) const;
  /// With what stands in braces filled in.
  std::string told(std::string_view english, std::initializer_list<Value> values) const;

  /// "1.234,5", with a true minus sign.
  std::string number(double value, int digits) const;
  std::string whole(std::size_t value) const;
  /// What was formatted already, by printf or fmt: "0.25 mm", "58,312".
  std::string localised(std::string formatted) const;

  /// What data call a thing: of "canal 2" the word is looked up, of "pulp cavity" both.
  std::string named(const std::string& name) const;
  /// Words that the program put together in English: found again among the texts, and what fills their places likewise;
  /// a {count} is a number. What is not found stays.
  std::string said(const std::string& words) const;

  /// Of an error's whole message, which ends with its cause in brackets; null: it has none, or there are no words for
  /// it.
  const ErrorWords* words_for_error(std::string_view message) const;

  bool english() const { return texts.empty(); }
  friend bool operator==(const Language&, const Language&) = default;
};

inline constexpr std::size_t most_language_file_bytes = 1u << 20, most_language_texts = 5000,
                             longest_language_text = 4000, most_language_errors = 1000;

/// Throws InputError: what strict_json.h lists, and wrong-version, bad-language, bad-text, repeated-text,
/// too-many-texts. docs/formats.md says when.
Language parse_language(std::string_view bytes, const std::string& name);
/// Likewise, and FileError.
Language read_language(const std::string& file);
/// What parse_language reads as the very same.
std::string to_json(const Language& language);

/// In language_files.cpp, written by the build.
std::span<const EmbeddedFile> language_files();
/// English, and those that come with the program.
std::vector<Language> known_languages();
/// "de" or "de-AT" or "de_DE.UTF-8": the known one; English where none is.
Language known_language(std::string_view tag);
bool knows_language(std::string_view tag);
/// A known one's tag, or a file. Throws UsageError, and what read_language throws.
Language language_asked(const std::string& tag_or_file);
/// As LC_ALL, LC_MESSAGES or LANG say.
std::string environment_language();

}  // namespace odontoscope
