#include "recon/input/json_schema.h"

#include <fmt/format.h>

#include "recon/input/structure_names.h"

namespace odontoscope {

std::vector<JsonField> optional(std::vector<JsonField> fields) {
  for (JsonField& field : fields) field.required = false;
  return fields;
}

JsonSchema::JsonSchema(std::string_view what, JsonReading reading) : StrictJson({}, reading) {
  node(Shape::object, what);
}

void JsonSchema::document(std::string_view format, JsonVersions versions, Fields fields, Effect effect) {
  fields.push_back(field("format", Shape::text, {.text = [this, format](const std::string& value) {
                           has_format_ = true;
                           if (value != format)
                             refuse("wrong-format",
                                    fmt::format("the format is {}, not \"{}\"", in_quotes(value), format),
                                    "Check that this is the file you mean");
                         }}));
  if (versions.last > 0)
    fields.push_back(field("version", Shape::number, {.number = [this, versions](double value) {
                             has_version_ = true;
                             check_version(value, versions);
                           }}));
  if (reading() != JsonReading::strict) {
    effect.closed = [this, format, versions, closed = std::move(effect.closed)] {
      if (!has_format_)
        refuse("wrong-format", fmt::format("it does not say that its format is \"{}\"", format),
               "Check that this is the file you mean");
      if (!has_version_ && versions.last > 0)
        refuse("wrong-version", "it does not say the version of its format",
               fmt::format("Add \"version\":{}", versions.last));
      if (closed) closed();
    };
  }
  take_fields(0, fields);
  effects_[0] = std::move(effect);
}

void JsonSchema::check_version(double value, JsonVersions versions) const {
  if (value >= versions.first && value <= versions.last && value == std::floor(value)) return;
  const std::string read = versions.first == versions.last
                               ? fmt::format("version {}", versions.last)
                               : fmt::format("versions {} to {}", versions.first, versions.last);
  refuse("wrong-version", fmt::format("version {} of the format, but this program reads {}", value, read),
         "Write the file anew with a matching program");
}

void JsonSchema::read(JsonSource& source) {
  has_format_ = has_version_ = false;
  describe(table_);
  StrictJson::read(source);
}

void JsonSchema::read(std::string_view bytes, const std::string& name) {
  JsonSource source = JsonSource::from_bytes(bytes, name);
  read(source);
}

int JsonSchema::node(Shape shape, std::string_view what, Effect effect, int element) {
  table_.push_back({shape, words_.emplace_back(what), element});
  effects_.push_back(std::move(effect));
  return static_cast<int>(table_.size()) - 1;
}

void JsonSchema::take_fields(int object, const Fields& fields) {
  std::vector<JsonNode::Key>& keys = keys_.emplace_back();
  for (const JsonField& field : fields)
    keys.push_back({field.key, field.node, field.required && reading() == JsonReading::strict});
  table_[static_cast<std::size_t>(object)].keys = keys;
}

JsonField JsonSchema::field(std::string_view key, Shape shape, Effect effect, int element) {
  return {key, node(shape, fmt::format("\"{}\"", key), std::move(effect), element)};
}

JsonField JsonSchema::object(std::string_view key, const Fields& fields, Effect effect) {
  const JsonField made = field(key, Shape::object, std::move(effect));
  take_fields(made.node, fields);
  return made;
}

JsonField JsonSchema::counted(std::string_view key, JsonLength length, int element, Effect whole) {
  const auto count = std::make_shared<std::size_t>(0);
  const auto with = [](auto first, auto then) {
    return [first, then](auto&&... value) {
      if (first() && then) then(value...);
    };
  };
  const auto one_more = [this, key, length, count] {
    if (++*count <= length.most) return true;
    fault(length.cause, fmt::format("\"{}\" has more than {} entries", key, length.most), length.remedy);
    return false;
  };
  Effect& of_one = effects_[static_cast<std::size_t>(element)];
  if (table_[static_cast<std::size_t>(element)].shape == Shape::text)
    of_one.text = with(one_more, of_one.text);
  else
    of_one.opened = with(one_more, of_one.opened);
  whole.opened = with(
      [count] {
        *count = 0;
        return true;
      },
      whole.opened);
  whole.closed = with(
      [this, key, length, count] {
        if (*count >= length.least) return true;
        fault(length.cause, fmt::format("\"{}\" has {} entries, but needs {} at least", key, *count, length.least),
              length.remedy);
        return false;
      },
      whole.closed);
  return field(key, Shape::array, std::move(whole), element);
}

JsonField JsonSchema::list(std::string_view key, std::string_view one, JsonLength length, const Fields& fields,
                           Effect of_one, Effect whole) {
  const int element = node(Shape::object, one, std::move(of_one));
  take_fields(element, fields);
  return counted(key, length, element, std::move(whole));
}

JsonField JsonSchema::texts(std::string_view key, std::string_view one, JsonLength length,
                            std::function<void(const std::string&)> take, Effect whole) {
  return counted(key, length, node(Shape::text, one, {.text = std::move(take)}), std::move(whole));
}

JsonField JsonSchema::rows(std::string_view key, std::string_view one, std::size_t columns, JsonLength length,
                           std::function<void(std::span<const std::string>)> take) {
  const int text = node(Shape::text, "a text", {.text = [this, columns](const std::string& value) {
                          if (row_.size() <= columns) row_.push_back(value);
                        }});
  const auto closed = [this, one = std::string(one), columns, take = std::move(take)] {
    if (row_.size() == columns) return take(row_);
    fault("bad-text", fmt::format("{} has {} of them", one, columns), "Correct it.");
  };
  const int row = node(Shape::array, one, {.opened = [this] { row_.clear(); }, .closed = closed}, text);
  return counted(key, length, row, {});
}

JsonField JsonSchema::map(std::string_view key, std::string_view one, std::function<void(const std::string&)> name,
                          const Fields& fields, Effect of_one) {
  const int element = node(Shape::object, one, std::move(of_one));
  take_fields(element, fields);
  return field(key, Shape::map, {.text = std::move(name)}, element);
}

int JsonSchema::number_list(std::string_view what, std::size_t count, std::function<void(std::span<const double>)> take,
                            std::string_view cause) {
  const int element = node(Shape::number, "a number", {.number = [this, count](double value) {
                             if (numbers_.size() <= count) numbers_.push_back(value);
                           }});
  const auto closed = [this, what = std::string(what), count, take = std::move(take), cause] {
    if (numbers_.size() == count) return take(numbers_);
    fault(cause, fmt::format("{} must be a list of {} numbers", what, count), "Correct the list");
  };
  return node(Shape::array, what, {.opened = [this] { numbers_.clear(); }, .closed = closed}, element);
}

JsonField JsonSchema::numbers(std::string_view key, std::size_t count,
                              std::function<void(std::span<const double>)> take, std::string_view cause) {
  return {key, number_list(fmt::format("\"{}\"", key), count, std::move(take), cause)};
}

JsonField JsonSchema::number_rows(std::string_view key, std::string_view one, std::size_t count,
                                  std::function<void(std::span<const double>)> take, Effect whole,
                                  std::string_view cause) {
  return field(key, Shape::array, std::move(whole), number_list(one, count, std::move(take), cause));
}

bool JsonSchema::in_range(std::string_view key, double value, const JsonRange& range) {
  if (value >= range.low && value <= range.high && (!range.whole || value == std::floor(value))) return true;
  fault(range.cause,
        fmt::format("\"{}\" is {}, which is {} {} and {}", key, value,
                    range.whole ? "no whole number between" : "not between", range.low, range.high),
        "Correct the value");
  return false;
}

void JsonSchema::opened(int node) {
  if (effect(node).opened) effect(node).opened();
}
void JsonSchema::closed(int node) {
  if (effect(node).closed) effect(node).closed();
}
void JsonSchema::number(int node, double value) {
  if (effect(node).number) effect(node).number(value);
}
void JsonSchema::count(int node, std::uint64_t value) { number(node, static_cast<double>(value)); }
void JsonSchema::text(int node, const std::string& value) {
  if (effect(node).text) effect(node).text(value);
}
void JsonSchema::boolean(int node, bool value) {
  if (effect(node).boolean) effect(node).boolean(value);
}
void JsonSchema::named(int node, const std::string& key) { text(node, key); }
void JsonSchema::kept(int node, const std::string& json) { text(node, json); }

}  // namespace odontoscope
