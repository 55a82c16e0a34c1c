#include "engine/comparison/artefact_lesson.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/scene/scene_json.h"
#include "recon/core/error.h"

namespace odontoscope {

namespace {

using Json = nlohmann::json;

constexpr const char* format_name = "odontoscope.lesson";
constexpr int format_version = 1;
constexpr std::array quantities = {"triangles", "cracks",    "misoriented", "nonmanifold",
                                   "pieces",    "lowest_mm", "ridges_mm",   "median_angle_deg"};

template <class Value>
using Words = std::initializer_list<std::pair<const char*, Value>>;

/// One object of the file. Keys that nobody knows are refused at once.
class Object {
 public:
  Object(const Json& json, std::string path, const std::string& file, std::initializer_list<const char*> known)
      : json_(json), path_(std::move(path)), file_(file) {
    if (!json.is_object()) refuse("wrong-type", "is no object");
    for (const auto& [key, value] : json.items())
      if (std::none_of(known.begin(), known.end(), [&key = key](const char* name) { return key == name; }))
        refuse("unknown-key", fmt::format("has a key \"{}\" that a lesson does not know", key));
  }

  const Json* member(const char* key) const {
    const auto found = json_.find(key);
    return found == json_.end() ? nullptr : &*found;
  }
  const Json& needed(const char* key) const {
    if (const Json* json = member(key)) return *json;
    refuse("missing-key", fmt::format("lacks \"{}\"", key));
  }
  std::string text(const char* key) const {
    const Json& json = needed(key);
    if (!json.is_string()) refuse("wrong-type", fmt::format("has a \"{}\" that is no text", key));
    std::string text = json.get<std::string>();
    if (text.empty() || text.size() > lesson_limits::text)
      refuse("bad-value", fmt::format("has a \"{}\" that is not 1 to {} bytes long", key, lesson_limits::text));
    return text;
  }
  double number(const char* key) const {
    const Json& json = needed(key);
    if (!json.is_number()) refuse("wrong-type", fmt::format("has a \"{}\" that is no number", key));
    const double number = json.get<double>();
    if (!std::isfinite(number)) refuse("not-finite", fmt::format("has a \"{}\" that is not finite", key));
    return number;
  }
  bool flag(const char* key) const {
    const Json* json = member(key);
    if (!json) return false;
    if (!json->is_boolean()) refuse("wrong-type", fmt::format("has an \"{}\" that is neither true nor false", key));
    return json->get<bool>();
  }
  template <class Value>
  Value word(const char* key, Words<Value> words) const {
    const std::string wanted = text(key);
    std::vector<const char*> known;
    for (const auto& [word, value] : words) {
      if (wanted == word) return value;
      known.push_back(word);
    }
    refuse("bad-value", fmt::format("has a \"{}\" that is none of {}", key, fmt::join(known, ", ")));
  }
  template <class Value, std::size_t count>
  Value word(const char* key, const NameTable<Value, count>& table) const {
    const std::string wanted = text(key);
    std::vector<const char*> known;
    for (const Named<Value>& one : table) {
      if (wanted == one.word) return one.value;
      known.push_back(one.word);
    }
    refuse("bad-value", fmt::format("has a \"{}\" that is none of {}", key, fmt::join(known, ", ")));
  }
  const Json& list(const char* key, std::size_t least, std::size_t most) const {
    const Json& json = needed(key);
    if (!json.is_array()) refuse("wrong-type", fmt::format("has \"{}\" that are no list", key));
    if (json.size() < least || json.size() > most)
      refuse("bad-value", fmt::format("has {} \"{}\"; a lesson has {} to {}", json.size(), key, least, most));
    return json;
  }
  [[noreturn]] void refuse(std::string_view cause, std::string_view wrong) const {
    Place place;
    place.file = file_;
    throw InputError(cause, place, fmt::format("{} {}", path_, wrong),
                     "See engine/comparison/artefact_lesson.h for the form of a lesson.");
  }
  const std::string& path() const { return path_; }

 private:
  const Json& json_;
  std::string path_;
  const std::string& file_;
};

ComparisonOptions db_in(const Json& json, const std::string& path, const std::string& file) {
  const Object object(json, path, file, {"grid", "field", "cases", "decimate"});
  ComparisonOptions options;
  const double grid = object.number("grid");
  if (grid < comparison_limits::least_grid || grid > comparison_limits::most_grid || grid != std::floor(grid))
    object.refuse("bad-value", fmt::format("has a \"grid\" that is no whole number from {} to {}",
                                           comparison_limits::least_grid, comparison_limits::most_grid));
  options.grid = static_cast<std::size_t>(grid);
  options.field = object.word("field", field_kinds);
  options.cases = object.word("cases", case_tables);
  options.decimation = object.word<ComparisonDecimation>("decimate", {{"none", ComparisonDecimation::none},
                                                                      {"half", ComparisonDecimation::half},
                                                                      {"tenth", ComparisonDecimation::tenth},
                                                                      {"most", ComparisonDecimation::most}});
  return options;
}

Claim claim_in(const Json& json, const std::string& path, const std::string& file) {
  const Object object(json, path, file, {"quantity", "structure", "at_least", "at_most"});
  Claim claim;
  claim.quantity = object.text("quantity");
  if (std::find(quantities.begin(), quantities.end(), claim.quantity) == quantities.end())
    object.refuse("bad-value", fmt::format("has a \"quantity\" that is none of {}", fmt::join(quantities, ", ")));
  if (object.member("structure")) claim.structure = object.text("structure");
  if (object.member("at_least")) claim.at_least = object.number("at_least");
  if (object.member("at_most")) claim.at_most = object.number("at_most");
  if (!claim.at_least && !claim.at_most) object.refuse("missing-key", "says neither \"at_least\" nor \"at_most\"");
  return claim;
}

ArtefactLessonStep step_in(const Json& json, const std::string& path, const std::string& file) {
  const Object object(json, path, file, {"title", "words", "layout", "db", "artefact", "claims", "scene"});
  ArtefactLessonStep step;
  step.title = object.text("title");
  step.words = object.text("words");
  struct Shown {
    ComparisonLayout layout;
    bool db;
  };
  const Shown shown = object.word<Shown>("layout", {{"db", {ComparisonLayout::in_place, true}},
                                                    {"dt", {ComparisonLayout::in_place, false}},
                                                    {"side-by-side", {ComparisonLayout::side_by_side, true}},
                                                    {"split", {ComparisonLayout::split, true}}});
  step.layout = shown.layout;
  step.shows_db = shown.db;
  step.db = db_in(object.needed("db"), path + ".db", file);
  step.at_artefact = object.flag("artefact");
  const Json& claims = object.list("claims", 1, lesson_limits::claims);
  for (std::size_t i = 0; i < claims.size(); ++i)
    step.claims.push_back(claim_in(claims[i], fmt::format("{}.claims[{}]", path, i), file));
  if (const Json* scene = object.member("scene")) {
    step.scene = scene->dump();
    scene_from_json(step.scene, Scene{}, file);  // refused now rather than in the middle of a lesson
  }
  return step;
}

/// Refuses what is nested too deeply and keys given twice, of which only one would count.
Json parse(std::string_view bytes, const std::string& file) {
  Place place;
  place.file = file;
  const char* remedy = "See engine/comparison/artefact_lesson.h for the form of a lesson.";
  if (bytes.size() > lesson_limits::bytes)
    throw InputError("file-too-large", place, fmt::format("a lesson is at most {} bytes long", lesson_limits::bytes),
                     remedy);
  std::vector<std::set<std::string>> keys;
  const auto watch = [&](int depth, Json::parse_event_t event, Json& parsed) {
    if (depth > lesson_limits::depth)
      throw InputError("too-deep", place, fmt::format("brackets are nested more than {} deep", lesson_limits::depth),
                       remedy);
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second)
      throw InputError("repeated-key", place, fmt::format("the key \"{}\" is there twice", parsed.get<std::string>()),
                       remedy);
    return true;
  };
  Json json = Json::parse(bytes, watch, /*allow_exceptions=*/false);
  if (json.is_discarded()) throw InputError("unparsable", place, "this is no JSON", remedy);
  return json;
}

}  // namespace

Scene ArtefactLessonStep::scene_over(const Scene& usual) const {
  return scene.empty() ? usual : scene_from_json(scene, usual, "lesson");
}

ArtefactLesson parse_artefact_lesson(std::string_view bytes, const std::string& file) {
  const Json json = parse(bytes, file);
  const Object document(json, "the lesson", file, {"format", "version", "title", "steps"});
  if (document.text("format") != format_name)
    document.refuse("wrong-format", fmt::format("is not of the format \"{}\"", format_name));
  if (document.number("version") != format_version)
    document.refuse("wrong-version", fmt::format("is not of version {}", format_version));
  ArtefactLesson lesson;
  lesson.title = document.text("title");
  const Json& steps = document.list("steps", 1, lesson_limits::steps);
  for (std::size_t i = 0; i < steps.size(); ++i)
    lesson.steps.push_back(step_in(steps[i], fmt::format("steps[{}]", i), file));
  return lesson;
}

std::optional<double> quantity_of(const ComparisonResult& result, std::string_view quantity,
                                  std::string_view structure) {
  std::optional<double> value;
  for (const ComparisonStructure& one : result.structures) {
    if (!structure.empty() && one.structure != structure) continue;
    const SurfaceReport& report = one.report;
    const auto add = [&](std::size_t count) { value = value.value_or(0) + static_cast<double>(count); };
    const auto least = [&](double number) { value = std::min(value.value_or(number), number); };
    if (quantity == "triangles")
      add(report.triangles);
    else if (quantity == "cracks")
      add(report.boundary_edges);
    else if (quantity == "misoriented")
      add(report.misoriented_edges);
    else if (quantity == "nonmanifold")
      add(report.nonmanifold_edges);
    else if (quantity == "pieces")
      add(report.shells.size());
    else if (quantity == "lowest_mm")
      least(one.lowest_mm);
    else if (quantity == "ridges_mm")
      value = value.value_or(0) + one.ridges_mm;
    else if (quantity == "median_angle_deg")
      least(report.smallest_angle_deg.median);
  }
  return value;
}

bool holds(const Claim& claim, const ComparisonResult& result) {
  const auto value = quantity_of(result, claim.quantity, claim.structure);
  return value && (!claim.at_least || *value >= *claim.at_least) && (!claim.at_most || *value <= *claim.at_most);
}

}  // namespace odontoscope
