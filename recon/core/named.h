#pragma once
// The words of an enum: one table for each, kept beside the enum and shared by command line, files and reports.

#include <array>
#include <cstddef>

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

}  // namespace odontoscope
