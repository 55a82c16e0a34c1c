#pragma once
// A JSON format as declarations: for each key what it may hold and where that goes. Read by StrictJson, whose errors it
// has, and bad-value besides.
//
//   JsonSchema schema("a lamp");
//   schema.document("demo.lamp", {1, 1}, {schema.number("reach_mm", lamp.reach, {.low = 0, .high = 9}),
//                                         optional(schema.text("name", lamp.name)),
//                                         schema.list("bulbs", "a bulb", lamp.bulbs, {.most = 8},
//                                                     {schema.flag("lit", of(last(lamp.bulbs), &Bulb::lit))})});
//   schema.read(source);
//
// Where a value goes is a variable, or a function that returns one when the value is read, since lists grow. Such
// variables must outlive the schema, and so must keys and other texts.

#include <cmath>
#include <cstddef>
#include <deque>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "recon/core/named.h"
#include "recon/input/strict_json.h"

namespace odontoscope {

/// A key of an object; made by JsonSchema only. Strict, it must be there unless it is `optional`.
struct JsonField {
  std::string_view key;
  int node;
  bool required = true;
};
inline JsonField optional(JsonField field) {
  field.required = false;
  return field;
}
/// All of them optional.
std::vector<JsonField> optional(std::vector<JsonField> fields);

/// The last of a list, what an optional holds, a member of what `where` returns: as functions.
template <class Value>
auto last(std::vector<Value>& list) {
  return [&list]() -> Value& { return list.back(); };
}
template <class Value>
auto held(std::optional<Value>& value) {
  return [&value]() -> Value& { return *value; };
}
template <class Where, class Owner, class Value>
auto of(Where where, Value Owner::*member) {
  return [where, member]() -> Value& { return where().*member; };
}

/// Both ends may be. What is no whole number is rounded where one goes, unless `whole` refuses it.
struct JsonRange {
  double low = std::numeric_limits<double>::lowest(), high = std::numeric_limits<double>::max();
  bool whole = false;
  std::string_view cause = "bad-value";
};
struct JsonLength {
  std::size_t least = 0, most = std::numeric_limits<std::size_t>::max();
  std::string_view cause = "bad-value";  // of too few or too many
  std::string_view remedy = "Correct the list.";
};
/// First and last that are read; 0: the format has none.
struct JsonVersions {
  int first = 1, last = 1;
};

/// What happens as a value is read.
struct JsonEffect {
  std::function<void()> opened = {}, closed = {};
  std::function<void(double)> number = {};
  std::function<void(const std::string&)> text = {};  // of a map each key, of what is kept its JSON
  std::function<void(bool)> boolean = {};
};

class JsonSchema final : private StrictJson {
 public:
  using Shape = JsonNode::Shape;
  using Fields = std::vector<JsonField>;
  using Effect = JsonEffect;

  /// `what` is the document in messages: "a scene".
  explicit JsonSchema(std::string_view what, JsonReading reading = JsonReading::strict);
  JsonSchema(const JsonSchema&) = delete;
  JsonSchema& operator=(const JsonSchema&) = delete;

  /// The document, with "format" and "version" beside its fields. Strict, both must be there; otherwise a document
  /// without them is of the wrong format or version.
  void document(std::string_view format, JsonVersions versions, Fields fields, Effect effect = {});
  void read(JsonSource& source);
  void read(std::string_view bytes, const std::string& name);

  JsonField field(std::string_view key, Shape shape, Effect effect, int element = -1);
  JsonField object(std::string_view key, const Fields& fields, Effect effect = {});
  /// An object that is made when it begins.
  template <class Value>
  JsonField object(std::string_view key, std::optional<Value>& value, const Fields& fields, Effect effect = {});
  /// Objects, each of them `one`.
  JsonField list(std::string_view key, std::string_view one, JsonLength length, const Fields& fields, Effect of_one,
                 Effect whole = {});
  /// Each of them a new one at the end of `where`.
  template <class Where>
  JsonField list(std::string_view key, std::string_view one, Where&& where, JsonLength length, const Fields& fields,
                 std::function<void()> closed = {});
  JsonField texts(std::string_view key, std::string_view one, JsonLength length,
                  std::function<void(const std::string&)> take, Effect whole = {});
  /// Lists of so many texts, each handed over together; bad-text for one of another length.
  JsonField rows(std::string_view key, std::string_view one, std::size_t columns, JsonLength length,
                 std::function<void(std::span<const std::string>)> take);
  /// Objects by names that are anyone's: `name` takes each before its object begins.
  JsonField map(std::string_view key, std::string_view one, std::function<void(const std::string&)> name,
                const Fields& fields, Effect of_one);
  /// So many numbers, handed over together; `cause` for another number of them.
  JsonField numbers(std::string_view key, std::size_t count, std::function<void(std::span<const double>)> take,
                    std::string_view cause = "wrong-type");
  /// Lists of so many numbers, each of them `one` and handed over likewise.
  JsonField number_rows(std::string_view key, std::string_view one, std::size_t count,
                        std::function<void(std::span<const double>)> take, Effect whole = {},
                        std::string_view cause = "wrong-type");

  template <class Where>
  JsonField number(std::string_view key, Where&& where, JsonRange range = {});
  template <class Where>
  JsonField flag(std::string_view key, Where&& where) {
    return field(key, Shape::boolean, {.boolean = [get = place_of(where)](bool value) { get() = value; }});
  }
  template <class Where>
  JsonField text(std::string_view key, Where&& where) {
    return field(key, Shape::text, {.text = [get = place_of(where)](const std::string& value) { get() = value; }});
  }
  /// Any JSON, without blanks.
  template <class Where>
  JsonField kept(std::string_view key, Where&& where) {
    return field(key, Shape::kept, {.text = [get = place_of(where)](const std::string& json) { get() = json; }});
  }
  /// One of known words. `table` must outlive the schema.
  template <class Where, class Value, std::size_t words>
  JsonField word(std::string_view key, Where&& where, const NameTable<Value, words>& table);
  /// [x, y, z].
  template <class Where>
  JsonField vector(std::string_view key, Where&& where) {
    return numbers(key, 3, [get = place_of(where)](std::span<const double> xyz) { get() = {xyz[0], xyz[1], xyz[2]}; });
  }

  /// A function that returns where a value goes: `where` itself if it is one.
  template <class Where>
  static auto place_of(Where& where) {
    if constexpr (std::is_invocable_v<const Where&>)
      return std::decay_t<Where>(where);
    else
      return [&where]() -> Where& { return where; };
  }

  using StrictJson::complaint;
  // For effects, while a file is read.
  using StrictJson::fault;
  using StrictJson::place;
  using StrictJson::refuse;

 private:
  int node(Shape shape, std::string_view what, Effect effect = {}, int element = -1);
  int number_list(std::string_view what, std::size_t count, std::function<void(std::span<const double>)> take,
                  std::string_view cause);
  void take_fields(int object, const Fields& fields);
  JsonField counted(std::string_view key, JsonLength length, int element, Effect whole);
  void check_version(double value, JsonVersions versions) const;
  bool in_range(std::string_view key, double value, const JsonRange& range);

  const Effect& effect(int node) const { return effects_[static_cast<std::size_t>(node)]; }
  void opened(int node) override;
  void closed(int node) override;
  void number(int node, double value) override;
  void count(int node, std::uint64_t value) override;
  void text(int node, const std::string& value) override;
  void boolean(int node, bool value) override;
  void named(int node, const std::string& key) override;
  void kept(int node, const std::string& json) override;

  std::vector<JsonNode> table_;
  std::vector<Effect> effects_;
  std::deque<std::string> words_;
  std::deque<std::vector<JsonNode::Key>> keys_;
  std::vector<double> numbers_;   // of the list that is read,
  std::vector<std::string> row_;  // and texts
  bool has_format_ = false, has_version_ = false;
};

template <class Value>
JsonField JsonSchema::object(std::string_view key, std::optional<Value>& value, const Fields& fields, Effect effect) {
  effect.opened = [&value] { value.emplace(); };
  return object(key, fields, std::move(effect));
}

template <class Where>
JsonField JsonSchema::list(std::string_view key, std::string_view one, Where&& where, JsonLength length,
                           // NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved on
                           const Fields& fields, std::function<void()> closed) {
  return list(key, one, length, fields,
              {.opened = [get = place_of(where)] { get().emplace_back(); }, .closed = std::move(closed)});
}

template <class Where>
JsonField JsonSchema::number(std::string_view key, Where&& where, JsonRange range) {
  return field(key, Shape::number, {.number = [this, key, range, get = place_of(where)](double value) {
                 using Number = std::remove_reference_t<decltype(get())>;
                 if (!in_range(key, value, range)) return;
                 if constexpr (std::is_integral_v<Number>)
                   get() = static_cast<Number>(std::llround(value));
                 else if constexpr (std::is_floating_point_v<Number>)
                   get() = static_cast<Number>(value);
                 else  // an optional
                   get() = static_cast<typename Number::value_type>(value);
               }});
}

template <class Where, class Value, std::size_t words>
JsonField JsonSchema::word(std::string_view key, Where&& where, const NameTable<Value, words>& table) {
  return field(key, Shape::text, {.text = [this, key, &table, get = place_of(where)](const std::string& value) {
                 if (const auto meant = value_of(table, value))
                   get() = *meant;
                 else
                   fault("bad-value", std::string("\"").append(key) + "\" is none of " + words_of(table),
                         "Write one of these words.");
               }});
}

}  // namespace odontoscope
