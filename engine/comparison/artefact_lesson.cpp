#include "engine/comparison/artefact_lesson.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "engine/scene/scene_json.h"
#include "recon/core/error.h"
#include "recon/input/json_schema.h"

namespace odontoscope {

namespace {

constexpr const char* format_name = "odontoscope.lesson";
constexpr int format_version = 1;
constexpr std::array quantities = {"triangles", "cracks",    "misoriented", "nonmanifold",
                                   "pieces",    "lowest_mm", "ridges_mm",   "median_angle_deg"};

constexpr std::string_view form = "See engine/comparison/artefact_lesson.h for the form of a lesson.";

struct Shown {
  ComparisonLayout layout;
  bool db;
};
constexpr NameTable<Shown, 4> layouts{{{"db", {ComparisonLayout::in_place, true}},
                                       {"dt", {ComparisonLayout::in_place, false}},
                                       {"side-by-side", {ComparisonLayout::side_by_side, true}},
                                       {"split", {ComparisonLayout::split, true}}}};

class LessonSchema {
 public:
  LessonSchema() {
    schema_.document(format_name, {format_version, format_version},
                     {text(
                          "title", [this]() -> auto& { return lesson_.title; }),
                      schema_.list("steps", "a step", lesson_.steps, {1, lesson_limits::steps, "bad-value", form},
                                   step(), [this] { take_layout(); })});
  }
  ArtefactLesson read(std::string_view bytes, const std::string& file) {
    if (bytes.size() > lesson_limits::bytes) {
      Place place;
      place.file = file;
      throw InputError("file-too-large", place, fmt::format("a lesson is at most {} bytes long", lesson_limits::bytes),
                       form);
    }
    schema_.read(bytes, file);
    return std::move(lesson_);
  }

 private:
  ArtefactLessonStep& at_hand() { return lesson_.steps.back(); }

  template <class Where>
  JsonField text(std::string_view key, Where where) {
    return schema_.field(key, JsonNode::Shape::text, {.text = [this, key, where](const std::string& value) {
                           if (value.empty() || value.size() > lesson_limits::text)
                             schema_.refuse("bad-value",
                                            fmt::format("\"{}\" is not 1 to {} bytes long", key, lesson_limits::text),
                                            form);
                           where() = value;
                         }});
  }
  JsonSchema::Fields step() {
    const auto step = last(lesson_.steps);
    const auto claims = [step]() -> auto& { return step().claims; };
    const auto claim = [claims]() -> Claim& { return claims().back(); };
    return {text("title", of(step, &ArtefactLessonStep::title)),
            text("words", of(step, &ArtefactLessonStep::words)),
            schema_.word("layout", shown_, layouts),
            db(),
            optional(schema_.flag("artefact", of(step, &ArtefactLessonStep::at_artefact))),
            schema_.list("claims", "a claim", claims, {1, lesson_limits::claims, "bad-value", form},
                         {text("quantity", of(claim, &Claim::quantity)),
                          optional(text("structure", of(claim, &Claim::structure))),
                          optional(schema_.number("at_least", of(claim, &Claim::at_least))),
                          optional(schema_.number("at_most", of(claim, &Claim::at_most)))},
                         [this, claim] { check(claim()); }),
            optional(schema_.field("scene", JsonNode::Shape::kept, {.text = [this](const std::string& scene) {
                                     at_hand().scene = scene;
                                     // Refused now rather than in the middle of a lesson.
                                     scene_from_json(scene, Scene{}, schema_.place().file);
                                   }}))};
  }
  JsonField db() {
    const auto options = of(last(lesson_.steps), &ArtefactLessonStep::db);
    return schema_.object(
        "db", {schema_.number("grid", of(options, &ComparisonOptions::grid),
                              {comparison_limits::least_grid, comparison_limits::most_grid, true}),
               schema_.word("field", of(options, &ComparisonOptions::field), field_kinds),
               schema_.word("cases", of(options, &ComparisonOptions::cases), case_tables),
               schema_.word("decimate", of(options, &ComparisonOptions::decimation), comparison_decimations)});
  }
  void check(const Claim& claim) const {
    if (std::find(quantities.begin(), quantities.end(), claim.quantity) == quantities.end())
      schema_.refuse("bad-value", fmt::format("\"quantity\" is none of {}", fmt::join(quantities, ", ")), form);
    if (!claim.at_least && !claim.at_most)
      schema_.refuse("missing-key", "a claim says neither \"at_least\" nor \"at_most\"", form);
  }
  void take_layout() {
    at_hand().layout = shown_.layout;
    at_hand().shows_db = shown_.db;
  }

  ArtefactLesson lesson_;
  Shown shown_{};
  JsonSchema schema_{"a lesson"};
};

}  // namespace

Scene ArtefactLessonStep::scene_over(const Scene& usual) const {
  return scene.empty() ? usual : scene_from_json(scene, usual, "lesson");
}

ArtefactLesson parse_artefact_lesson(std::string_view bytes, const std::string& file) {
  return LessonSchema().read(bytes, file);
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
