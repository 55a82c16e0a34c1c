#pragma once
// The words of an enum: one table for each, kept beside the enum and shared by command line, files and reports.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "recon/core/error.h"

namespace odontoscope {

template <class Value>
struct Named {
  const char* word;
  Value value;
};

template <class Value, std::size_t count>
using NameTable = std::array<Named<Value>, count>;

/// Precondition: the table has the value.
template <class Value, std::size_t count>
constexpr const char* word_of(const NameTable<Value, count>& table, Value value) {
  for (const Named<Value>& one : table)
    if (one.value == value) return one.word;
  return "unknown";
}

template <class Value, std::size_t count>
constexpr std::optional<Value> value_of(const NameTable<Value, count>& table, std::string_view word) {
  for (const Named<Value>& one : table)
    if (one.word == word) return one.value;
  return std::nullopt;
}

/// "cull, show, tint".
template <class Value, std::size_t count>
std::string words_of(const NameTable<Value, count>& table) {
  std::string words;
  for (const Named<Value>& one : table) words += words.empty() ? one.word : std::string(", ") + one.word;
  return words;
}

/// Throws UsageError with the words that there are. `what` has them: "view".
template <class Value, std::size_t count>
Value value_named(const NameTable<Value, count>& table, std::string_view word, std::string_view what) {
  if (const auto value = value_of(table, word)) return *value;
  throw UsageError("there is no " + std::string(what) + " \"" + std::string(word) + '"',
                   "Choose one of " + words_of(table) + ".");
}

}  // namespace odontoscope
