#pragma once
// The format of a sample tooth's table (tooth_table.h): its nodes for StrictJson, and what each value that is read does
// to a tooth.

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <deque>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recon/core/named.h"
#include "recon/input/strict_json.h"
#include "recon/sample/limits.h"
#include "recon/sample/tooth_shape.h"

namespace odontoscope::sample {

/// What a value that was read does.
struct ToothEffect {
  std::function<void()> opened = {}, closed = {};
  std::function<void(double)> number = {};
  std::function<void(const std::string&)> text = {};
};

/// The nodes of the format with what each does to a tooth. `get` is asked for its target when the value is read, since
/// lists grow.
class ToothSchema {
 public:
  ToothSchema();
  ToothSchema(const ToothSchema&) = delete;
  ToothSchema& operator=(const ToothSchema&) = delete;

  ToothShape tooth;
  std::vector<JsonNode> nodes;
  std::vector<ToothEffect> effects;
  /// Set by whoever reads.
  std::function<void(std::string_view cause, const std::string& wrong, std::string_view remedy)> refuse;

 private:
  struct Field {
    std::string_view name;
    int node;
    bool required = true;
  };
  static Field optional(Field field) {
    field.required = false;
    return field;
  }

  using Shape = JsonNode::Shape;

  int node(JsonNode::Shape shape, std::string_view what, ToothEffect effect = {}, int element = -1) {
    nodes.push_back({shape, names_.emplace_back(what), element});
    effects.push_back(std::move(effect));
    return static_cast<int>(nodes.size()) - 1;
  }
  static std::string quoted(std::string_view key) { return fmt::format("\"{}\"", key); }

  void take_fields(int object, std::initializer_list<Field> fields) {
    std::vector<JsonNode::Key>& keys = keys_.emplace_back();
    for (const Field& field : fields) keys.push_back({field.name, field.node, field.required});
    nodes[static_cast<std::size_t>(object)].keys = keys;
  }
  Field object(std::string_view key, std::initializer_list<Field> fields) {
    const int made = node(Shape::object, quoted(key));
    take_fields(made, fields);
    return {key, made};
  }
  /// Objects of a list; each begins as a new one at its end.
  template <class Get>
  Field list(std::string_view key, std::string_view one, Get get, std::initializer_list<Field> fields) {
    const int element =
        node(Shape::object, one, {.opened = [this, get, key] {
               if (get().size() == limits::table_rows)
                 refuse("too-many", fmt::format("more than {} {}", limits::table_rows, key), "Leave some out.");
               get().emplace_back();
             }});
    take_fields(element, fields);
    return {key, node(Shape::array, quoted(key), {}, element)};
  }

  template <class Get>
  Field number(std::string_view key, Get get) {
    return {key, node(Shape::number, quoted(key),
                      {.number = [this, get, key](double value) { get() = in_range(value, key); }})};
  }
  template <class Get>
  Field text(std::string_view key, Get get) {
    return {key, node(Shape::text, quoted(key), {.text = [get](const std::string& value) { get() = value; }})};
  }
  /// One of known words.
  template <class Get, class Value, std::size_t count>
  Field word(std::string_view key, Get get, const NameTable<Value, count>& words) {
    return {key, node(Shape::text, quoted(key), {.text = [this, get, key, &words](const std::string& value) {
                        for (const auto& [known, meant] : words) {
                          if (value != known) continue;
                          get() = meant;
                          return;
                        }
                        refuse("bad-value", fmt::format("\"{}\" cannot be \"{}\"", key, value), "Take a known word.");
                      }})};
  }

  /// So many numbers, handed over together.
  int numbers(const std::string& what, std::size_t count, std::function<void()> taken) {
    const int coordinate = node(Shape::number, "a number", {.number = [this](double value) {
                                  if (numbers_.size() < limits::table_rows)
                                    numbers_.push_back(in_range(value, "a number"));
                                }});
    return node(Shape::array, what,
                {.opened = [this] { numbers_.clear(); },
                 .closed =
                     [this, what, count, taken] {
                       if (numbers_.size() != count)
                         refuse("bad-value", fmt::format("{} has not {} numbers", what, count), "Correct it.");
                       taken();
                     }},
                coordinate);
  }
  template <class Get>
  Field point3(std::string_view key, Get get) {
    return {key, numbers(quoted(key), 3, [this, get] { get() = Point3{numbers_[0], numbers_[1], numbers_[2]}; })};
  }
  template <class Get>
  Field point2(std::string_view key, Get get) {
    return {key, numbers(quoted(key), 2, [this, get] { get() = Point2{numbers_[0], numbers_[1]}; })};
  }
  template <class Get>
  Field polyline(std::string_view key, Get get) {
    const int point = numbers("a point", 3, [this, get] {
      get().push_back(Point3{numbers_[0], numbers_[1], numbers_[2]});
    });
    return {key, node(Shape::array, quoted(key), {}, point)};
  }
  template <class Get>
  Field profile(std::string_view key, Get get) {
    const int knot = numbers("a knot", 2, [this, key] {
      if (!knots_.empty() && !(knots_.back().at < numbers_[0]))
        refuse("bad-profile", fmt::format("the knots of \"{}\" do not ascend", key), "Order them by z.");
      knots_.push_back({numbers_[0], numbers_[1]});
    });
    return {key, node(Shape::array, quoted(key),
                      {.opened = [this] { knots_.clear(); },
                       .closed =
                           [this, get, key] {
                             if (knots_.empty())
                               refuse("bad-profile", fmt::format("\"{}\" has no knots", key), "Give it one at least.");
                             get() = Profile(knots_);
                           }},
                      knot)};
  }

  int zones() {
    const int zone = numbers("a range", 2, [this] {
      if (!(numbers_[0] < numbers_[1])) refuse("bad-value", "a range of heights does not ascend", "Write [low, high].");
      if (tooth.steep.size() == limits::table_rows)
        refuse("too-many", fmt::format("more than {} ranges", limits::table_rows), "Leave some out.");
      tooth.steep.push_back({numbers_[0], numbers_[1]});
    });
    return node(Shape::array, "\"steep\"", {}, zone);
  }

  double in_range(double value, std::string_view what) const {
    if (std::abs(value) > limits::table_number)
      refuse("bad-value", fmt::format("{} is {}", what, value),
             "Take a number in millimetres, at most 1000 either way.");
    return value;
  }

  Field crown_sides();
  Field occlusal();
  Field enamel();
  Field roots();
  Field chamber();
  Field horns();
  Field canals();

  std::deque<std::string> names_;
  std::deque<std::vector<JsonNode::Key>> keys_;
  std::vector<double> numbers_;
  std::vector<Profile::Knot> knots_;
};

}  // namespace odontoscope::sample
