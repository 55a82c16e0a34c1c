#pragma once
// Reading JSON against a fixed schema, as it streams by: nothing is stored but what the reader keeps.
//
// A reader describes its format as a table of nodes and gets one call for each value that is where it belongs. All else
// is refused here with file and line: unparsable text, values of the wrong type, missing, repeated and unknown keys.
// Keys that begin with "x-" are notes of other programs: ignored wherever an object is, with all that they hold.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "recon/core/error.h"
#include "recon/input/json_source.h"

namespace odontoscope {

/// A value of the format: what it is and what it may hold.
struct JsonNode {
  enum class Shape { object, array, number, count, text, boolean, ignored };
  struct Key {
    std::string_view name;
    int node;
    bool required;
  };
  Shape shape;
  std::string_view what;           // for messages: "a point", "\"z\""
  int element = -1;                // of an array: the node of each element
  std::span<const Key> keys = {};  // of an object: at most 32
};

class StrictJson {
 public:
  virtual ~StrictJson() = default;

  /// Reads all of `source`; node 0 is the whole document. Throws InputError (unparsable, wrong-format, wrong-type,
  /// missing-key, repeated-key, unknown-key, not-finite, too-deep, too-large, file-too-large) or FileError.
  void read(JsonSource& source);

 protected:
  explicit StrictJson(std::span<const JsonNode> nodes) : nodes_(nodes) {}

  /// An object or array begins or ends; a value was read. `node` is its index in the table.
  virtual void opened(int /*node*/) {}
  virtual void closed(int /*node*/) {}
  virtual void number(int /*node*/, double /*value*/) {}
  virtual void count(int /*node*/, std::uint64_t /*value*/) {}
  virtual void text(int /*node*/, const std::string& /*value*/) {}
  virtual void boolean(int /*node*/, bool /*value*/) {}
  /// Adds what the reader knows of the place: slice, contour, point.
  virtual void add_place(Place& /*place*/) const {}

  /// Where the reader is now.
  Place place() const;
  [[noreturn]] void refuse(std::string_view cause, std::string_view wrong, std::string_view remedy) const;

 private:
  friend struct JsonEvents;
  struct Frame {
    int node;
    std::uint32_t keys_seen;
  };

  int expected() const;
  bool skips_value();
  const JsonNode& rule(int node) const { return nodes_[static_cast<std::size_t>(node)]; }
  void open(JsonNode::Shape shape);
  void close();
  void key(const std::string& name);
  void take_number(double value);
  void take_count(std::uint64_t value);
  void take_text(const std::string& value);
  void take_boolean(bool value);
  void take_null();
  [[noreturn]] void wrong_type(int node, std::string_view found) const;
  [[noreturn]] void unknown_key(const JsonNode& object, const std::string& name) const;
  [[noreturn]] void unparsable(const std::string& token, const char* detail, bool overflow) const;

  std::span<const JsonNode> nodes_;
  JsonSource* source_ = nullptr;
  std::vector<Frame> open_;
  int after_key_ = -1;
  bool skipping_ = false;          // the value at hand belongs to an ignored key
  std::size_t skipped_depth_ = 0;  // containers open in it
};

}  // namespace odontoscope
