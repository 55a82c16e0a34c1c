#include "recon/input/strict_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "recon/core/limits.h"
#include "recon/core/lower_case.h"
#include "recon/input/structure_names.h"

namespace odontoscope {
namespace {

std::string_view in_words(JsonNode::Shape shape) {
  switch (shape) {
    case JsonNode::Shape::object:
    case JsonNode::Shape::map:
      return "an object {...}";
    case JsonNode::Shape::array:
      return "a list [...]";
    case JsonNode::Shape::number:
      return "a number";
    case JsonNode::Shape::count:
      return "a whole number from 0";
    case JsonNode::Shape::text:
      return "a text in quotes";
    case JsonNode::Shape::boolean:
      return "true or false";
    case JsonNode::Shape::kept:
    case JsonNode::Shape::ignored:
      break;
  }
  return "anything";
}

/// Insertions, deletions and replacements that turn a into b.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

constexpr std::size_t longest_word = 3;  // "nan", "inf"

/// Does the last word read, with what follows, begin with the name that other programs give to what is no number?
bool ends_in_no_number(std::string_view token, std::string_view upcoming) {
  std::string text(token.substr(token.find_last_of(" \t\r\n,:[{") + 1));
  text = lower_case(text.append(upcoming));
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.erase(0, 1);
  return text.starts_with("nan") || text.starts_with("inf");
}

}  // namespace

/// The parser's events, passed on. (All names and signatures are the parser's.) The parser keeps what it has read
/// since the last number, text or key began: those mark the source, which bounds it.
struct JsonEvents {
  using json = nlohmann::json;
  StrictJson& reader;

  bool null() {
    if (!kept(nullptr)) reader.take_null();
    return true;
  }
  bool boolean(bool value) {
    if (!kept(value)) reader.take_boolean(value);
    return true;
  }
  bool number_integer(json::number_integer_t value) {
    if (!kept(value)) reader.take_number(static_cast<double>(value));
    return marked();
  }
  bool number_unsigned(json::number_unsigned_t value) {
    if (!kept(value)) reader.take_count(value);
    return marked();
  }
  bool number_float(json::number_float_t value, const std::string&) {
    if (!kept(value)) reader.take_number(value);
    return marked();
  }
  bool string(std::string& value) {
    if (!kept(value)) reader.take_text(value);
    return marked();
  }
  bool binary(json::binary_t&) { return false; }
  bool start_object(std::size_t) {
    reader.open(JsonNode::Shape::object);
    return true;
  }
  bool key(std::string& name) {
    reader.key(name);
    return marked();
  }
  bool end_object() {
    reader.close('}');
    return true;
  }
  bool start_array(std::size_t) {
    reader.open(JsonNode::Shape::array);
    return true;
  }
  bool end_array() {
    reader.close(']');
    return true;
  }
  bool parse_error(std::size_t, const std::string& token, const json::exception& error) {
    constexpr int number_overflow = 406;
    reader.unparsable(token, error.what(), error.id == number_overflow);
  }

 private:
  template <class Value>
  bool kept(const Value& value) {
    if (!reader.keeps_value()) return false;
    reader.keep(json(value).dump());
    return true;
  }
  bool marked() {
    reader.source_->mark();
    return true;
  }
};

void StrictJson::read(JsonSource& source) {
  source_ = &source;
  open_.clear();
  after_key_ = -1;
  skipping_ = false;
  skipped_depth_ = 0;
  keeping_ = -1;
  complaint_.clear();
  JsonEvents events{*this};
  nlohmann::json::sax_parse(source.begin(), source.end(), &events);
  if (!source.ended()) {  // the parser takes a zero byte for the end
    refuse("unparsable", fmt::format("a zero byte at column {}", source.column() - 1), "Write or copy the file again");
  }
}

Place StrictJson::place() const {
  Place place = source_->place();
  add_place(place);
  return place;
}

void StrictJson::refuse(std::string_view cause, std::string_view wrong, std::string_view remedy) const {
  throw InputError(cause, place(), wrong, remedy);
}

void StrictJson::fault(std::string_view cause, std::string_view wrong, std::string_view remedy) {
  if (reading_ != JsonReading::forgiving) refuse(cause, wrong, remedy);
  if (complaint_.empty()) complaint_ = wrong;
}

int StrictJson::expected() const {
  if (open_.empty()) return 0;
  const JsonNode& parent = rule(open_.back().node);
  return parent.shape == JsonNode::Shape::array ? parent.element : after_key_;
}

/// Is the value at hand part of something ignored?
bool StrictJson::skips_value() {
  if (!skipping_) return false;
  if (skipped_depth_ == 0) skipping_ = false;
  return true;
}

/// Is the value at hand kept, or part of one that is?
bool StrictJson::keeps_value() const {
  return keeping_ >= 0 || (!skipping_ && rule(expected()).shape == JsonNode::Shape::kept);
}

/// A scalar, or a bracket, of a value that is kept; the whole of it if no bracket is open.
void StrictJson::keep(std::string_view token) {
  const bool first = kept_.empty() || std::string_view("{[:").find(kept_.back()) != std::string_view::npos;
  if (!first && token != "}" && token != "]") kept_ += ',';
  kept_ += token;
  if (skipped_depth_ > 0) return;
  const int node = keeping_ >= 0 ? keeping_ : expected();
  keeping_ = -1;
  kept(node, std::exchange(kept_, {}));
}

void StrictJson::open(JsonNode::Shape shape) {
  const bool is_list = shape == JsonNode::Shape::array;
  if (!skipping_ && keeps_value()) {
    keeping_ = expected();
    skipping_ = true;
  }
  if (skipping_) {
    if (++skipped_depth_ > limits::json_depth) {
      refuse("too-deep", fmt::format("more than {} levels of brackets", limits::json_depth),
             "Check that this is the file you mean");
    }
    if (keeping_ >= 0) keep(is_list ? "[" : "{");
    return;
  }
  const int node = expected();
  const JsonNode::Shape wanted = rule(node).shape;
  const bool fits = wanted == shape || (wanted == JsonNode::Shape::map && !is_list);
  if (!fits && wanted != JsonNode::Shape::ignored) wrong_type(node, in_words(shape));
  if (!fits) {
    skipping_ = true;
    skipped_depth_ = 1;
    return;
  }
  open_.push_back({node, 0});
  opened(node);
}

void StrictJson::close(char bracket) {
  if (skipping_) {
    if (--skipped_depth_ == 0) skipping_ = false;
    if (keeping_ >= 0) keep({&bracket, 1});
    return;
  }
  const Frame frame = open_.back();
  const std::span<const JsonNode::Key> keys = rule(frame.node).keys;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (!keys[k].required || (frame.keys_seen >> k & 1u)) continue;
    fault("missing-key", fmt::format("{} has no \"{}\"", rule(frame.node).what, keys[k].name),
          fmt::format("Add \"{}\"", keys[k].name));
  }
  closed(frame.node);
  open_.pop_back();
}

void StrictJson::key(const std::string& name) {
  if (keeping_ >= 0) {
    if (kept_.back() != '{') kept_ += ',';
    kept_ += nlohmann::json(name).dump() + ':';
  }
  if (skipping_) return;
  const JsonNode& object = rule(open_.back().node);
  if (object.shape == JsonNode::Shape::map) {
    after_key_ = object.element;
    return named(open_.back().node, name);
  }
  const auto found =
      std::find_if(object.keys.begin(), object.keys.end(), [&](const auto& k) { return k.name == name; });
  const bool known = found != object.keys.end();
  if (name.starts_with("x-") || (!known && reading_ != JsonReading::strict)) {
    skipping_ = true;
    return;
  }
  if (!known) unknown_key(object, name);
  const std::uint32_t bit = 1u << (found - object.keys.begin());
  if (reading_ == JsonReading::strict && open_.back().keys_seen & bit) {
    refuse("repeated-key", fmt::format("{} has \"{}\" twice", object.what, name), "Remove one of them");
  }
  open_.back().keys_seen |= bit;
  after_key_ = found->node;
}

void StrictJson::take_number(double value) {
  if (skips_value()) return;
  const int node = expected();
  switch (rule(node).shape) {
    case JsonNode::Shape::number:
      return number(node, value);
    case JsonNode::Shape::ignored:
      return;
    default:
      wrong_type(node, fmt::format("the number {}", value));
  }
}

void StrictJson::take_count(std::uint64_t value) {
  if (skips_value()) return;
  const int node = expected();
  switch (rule(node).shape) {
    case JsonNode::Shape::count:
      return count(node, value);
    case JsonNode::Shape::number:
      return number(node, static_cast<double>(value));
    case JsonNode::Shape::ignored:
      return;
    default:
      wrong_type(node, fmt::format("the number {}", value));
  }
}

void StrictJson::take_text(const std::string& value) {
  if (skips_value()) return;
  const int node = expected();
  switch (rule(node).shape) {
    case JsonNode::Shape::text:
      return text(node, value);
    case JsonNode::Shape::ignored:
      return;
    default:
      wrong_type(node, fmt::format("the text {}", in_quotes(value)));
  }
}

void StrictJson::take_boolean(bool value) {
  if (skips_value()) return;
  const int node = expected();
  switch (rule(node).shape) {
    case JsonNode::Shape::boolean:
      return boolean(node, value);
    case JsonNode::Shape::ignored:
      return;
    default:
      wrong_type(node, value ? "true" : "false");
  }
}

void StrictJson::take_null() {
  if (skips_value()) return;
  const int node = expected();
  const bool is_member = !open_.empty() && rule(open_.back().node).shape == JsonNode::Shape::object;
  if (rule(node).shape == JsonNode::Shape::ignored || (is_member && reading_ == JsonReading::tolerant)) return;
  wrong_type(node, "null");
}

void StrictJson::wrong_type(int node, std::string_view found) {
  if (node == 0) {
    refuse("wrong-format", fmt::format("{} is {}, but here is {}", rule(0).what, in_words(rule(0).shape), found),
           "Check that this is the file you mean");
  }
  fault("wrong-type", fmt::format("{} must be {}, but here is {}", rule(node).what, in_words(rule(node).shape), found),
        "Correct the value");
}

void StrictJson::unknown_key(const JsonNode& object, const std::string& name) const {
  const std::string_view compared = std::string_view(name).substr(0, limits::name_length);
  const auto nearest = std::min_element(object.keys.begin(), object.keys.end(), [&](const auto& a, const auto& b) {
    return edits(compared, a.name) < edits(compared, b.name);
  });
  refuse("unknown-key", fmt::format("{} has no key {}", object.what, in_quotes(name)),
         fmt::format("Did you mean \"{}\"? Notes of your own start with \"x-\"", nearest->name));
}

/// `detail` is the parser's own message: "[json...] parse error at line 1, column 2: syntax error ...".
void StrictJson::unparsable(const std::string& token, const char* detail, bool overflow) const {
  const Place where = place();
  if (overflow || ends_in_no_number(token, source_->upcoming(longest_word))) {
    throw InputError("not-finite", where,
                     overflow ? "a number too large for any computer" : "NaN and infinity are not allowed",
                     "Find out where the number was lost");
  }
  if (source_->offset() == 0) {
    throw InputError("unparsable", where, "the file is empty", "Write or copy it again");
  }
  const std::size_t column = source_->column();
  if (source_->ended()) {
    throw InputError("unparsable", where, fmt::format("the text ends too early, at column {}", column),
                     "The file was cut short: write or copy it again");
  }
  std::string reason = detail;
  if (const std::size_t colon = reason.find(": "); colon != std::string::npos) reason.erase(0, colon + 2);
  if (reason.size() > limits::name_length) reason = reason.substr(0, limits::name_length) + "...";
  const bool printable =
      std::all_of(reason.begin(), reason.end(), [](unsigned char c) { return c >= 0x20 && c < 0x7f; });
  throw InputError("unparsable", where,
                   fmt::format("no JSON at column {}{}", column, printable ? " (" + reason + ")" : std::string()),
                   "Correct the text there");
}

}  // namespace odontoscope
