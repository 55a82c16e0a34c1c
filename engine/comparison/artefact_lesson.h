#pragma once
// A guided walk through what the two methods do differently: steps in a file, each a saved scene, DB options, a few
// sentences, and the claims that they make, which a test holds against the models.
//
//   {"format":"odontoscope.lesson","version":1,"title":"...","steps":[
//    {"title":"...","words":"...","layout":"side-by-side",
//     "db":{"grid":64,"field":"hybrid","cases":"classic","decimate":"none"},
//     "artefact":false,
//     "claims":[{"quantity":"cracks","structure":"dentine","at_least":1}],
//     "scene":{"format":"odontoscope.scene",...}}]}
//
// `scene` is what the viewer saves (engine/scene/scene_json.h); what it leaves out is as usual. Layouts: "db", "dt",
// "side-by-side", "split". With `artefact` the camera goes to the first artefact instead of the scene's. Quantities:
// see `quantity_of`. Unknown keys are errors, unless they begin with "x-".

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/comparison/db_pipeline.h"
#include "engine/scene/scene.h"
#include "recon/core/embedded_file.h"

namespace odontoscope {

enum class ComparisonLayout { in_place, side_by_side, split };

/// Of the DB surface of one structure, or of all together.
struct Claim {
  std::string quantity;
  std::string structure;  // empty: all
  std::optional<double> at_least, at_most;
};

struct ArtefactLessonStep {
  std::string title, words;
  ComparisonLayout layout = ComparisonLayout::side_by_side;
  bool shows_db = true;  // with ComparisonLayout::in_place
  ComparisonOptions db;
  bool at_artefact = false;
  std::vector<Claim> claims;
  std::string scene;  // JSON; empty: the usual scene

  /// `usual` with what the step's scene says changed.
  Scene scene_over(const Scene& usual) const;
};

struct ArtefactLesson {
  std::string title;
  std::vector<ArtefactLessonStep> steps;  // one at least
};

namespace lesson_limits {
inline constexpr std::size_t bytes = 1u << 18, steps = 32, text = 1200, claims = 8;
}  // namespace lesson_limits

/// Throws InputError: file-too-large, unparsable, too-deep, wrong-format, wrong-version, wrong-type, missing-key,
/// unknown-key, repeated-key, not-finite, bad-value, and what a scene's reader throws.
ArtefactLesson parse_artefact_lesson(std::string_view bytes, const std::string& file);

/// The one that comes with the program, for the sample molar; in lesson_files.cpp, and so only in this room.
std::span<const EmbeddedFile> lesson_files();
inline std::string_view lesson_text() { return lesson_files()[0].bytes; }
inline ArtefactLesson artefact_lesson() { return parse_artefact_lesson(lesson_text(), "artefacts.lesson.json"); }

/// "triangles", "cracks" (boundary edges), "misoriented", "nonmanifold" (edges), "pieces" (shells), "lowest_mm",
/// "ridges_mm", "median_angle_deg" (median over the triangles of their smallest angle; the least of the structures);
/// empty if there is no such quantity or structure.
std::optional<double> quantity_of(const ComparisonResult& result, std::string_view quantity,
                                  std::string_view structure);
bool holds(const Claim& claim, const ComparisonResult& result);

}  // namespace odontoscope
