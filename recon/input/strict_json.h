#pragma once
// Reading JSON against a fixed schema, as it streams by: nothing is stored but what the reader keeps.
//
// A reader describes its format as a table of nodes and gets one call for each value that is where it belongs. All else
// is refused here with file and line: unparsable text, values of the wrong type, missing, repeated and unknown keys.
// Keys that begin with "x-" are notes of other programs: ignored wherever an object is, with all that they hold.
// json_schema.h builds such tables from declarations; what is read by the million has a reader of its own.

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
  /// A map is an object whose keys are anyone's; what is kept is handed on as the JSON that it is.
  enum class Shape { object, map, array, number, count, text, boolean, kept, ignored };
  struct Key {
    std::string_view name;
    int node;
    bool required;
  };
  Shape shape;
  std::string_view what;           // for messages: "a point", "\"z\""
  int element = -1;                // of an array or a map: the node of each element
  std::span<const Key> keys = {};  // of an object: at most 32
};

/// Strict: as above. Tolerant: unknown keys are ignored, null is a key that is not there, and of a key that comes twice
/// the last counts. Forgiving: so too, but for null, and values of the wrong type are left out, the first with a
/// complaint.
enum class JsonReading { strict, tolerant, forgiving };

class StrictJson {
 public:
  virtual ~StrictJson() = default;

  /// Reads all of `source`; node 0 is the whole document. Throws InputError (unparsable, wrong-format, wrong-type,
  /// missing-key, repeated-key, unknown-key, not-finite, too-deep, too-large, file-too-large) or FileError.
  void read(JsonSource& source);

 protected:
  explicit StrictJson(std::span<const JsonNode> nodes, JsonReading reading = JsonReading::strict)
      : nodes_(nodes), reading_(reading) {}
  /// The table, before anything is read; it must outlive the reader.
  void describe(std::span<const JsonNode> nodes) { nodes_ = nodes; }

  /// An object or array begins or ends; a value was read. `node` is its index in the table.
  virtual void opened(int /*node*/) {}
  virtual void closed(int /*node*/) {}
  virtual void number(int /*node*/, double /*value*/) {}
  virtual void count(int /*node*/, std::uint64_t /*value*/) {}
  virtual void text(int /*node*/, const std::string& /*value*/) {}
  virtual void boolean(int /*node*/, bool /*value*/) {}
  /// The value that follows belongs to this key of a map.
  virtual void named(int /*node*/, const std::string& /*key*/) {}
  /// A value that is kept, without blanks.
  virtual void kept(int /*node*/, const std::string& /*json*/) {}
  /// Adds what the reader knows of the place: slice, contour, point.
  virtual void add_place(Place& /*place*/) const {}

  /// Where the reader is now.
  Place place() const;
  [[noreturn]] void refuse(std::string_view cause, std::string_view wrong, std::string_view remedy) const;
  /// Refuses a value, or, forgiving, remembers the first such complaint; the caller then leaves the value out.
  void fault(std::string_view cause, std::string_view wrong, std::string_view remedy);
  JsonReading reading() const { return reading_; }
  const std::string& complaint() const { return complaint_; }

 private:
  friend struct JsonEvents;
  struct Frame {
    int node;
    std::uint32_t keys_seen;
  };

  int expected() const;
  bool skips_value();
  bool keeps_value() const;
  void keep(std::string_view token);
  const JsonNode& rule(int node) const { return nodes_[static_cast<std::size_t>(node)]; }
  void open(JsonNode::Shape shape);
  void close(char bracket);
  void key(const std::string& name);
  void take_number(double value);
  void take_count(std::uint64_t value);
  void take_text(const std::string& value);
  void take_boolean(bool value);
  void take_null();
  void wrong_type(int node, std::string_view found);
  [[noreturn]] void unknown_key(const JsonNode& object, const std::string& name) const;
  [[noreturn]] void unparsable(const std::string& token, const char* detail, bool overflow) const;

  std::span<const JsonNode> nodes_;
  JsonReading reading_;
  std::string complaint_;
  JsonSource* source_ = nullptr;
  std::vector<Frame> open_;
  int after_key_ = -1;
  bool skipping_ = false;          // the value at hand belongs to an ignored key
  std::size_t skipped_depth_ = 0;  // containers open in it
  int keeping_ = -1;               // the node of the value that is kept,
  std::string kept_;               // as far as it was read
};

}  // namespace odontoscope
