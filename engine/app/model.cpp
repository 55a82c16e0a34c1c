#include "engine/app/model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "engine/app/words.h"
#include "recon/core/error.h"
#include "recon/mesh/simplify_surface.h"

namespace odontoscope::app {
namespace {

std::size_t triangles_in(const Reconstruction& reconstruction) {
  std::size_t sum = 0;
  for (const Solid& solid : reconstruction.solids) sum += solid.surface.triangles.size();
  return sum;
}

StructureSimplification simplify_solid(Solid& solid, std::size_t triangles, const Progress& progress) {
  SimplifiedSurface simple = simplify(solid.surface, {.triangles = triangles, .distance = {}}, progress);
  if (!simple.report.closed_oriented_manifold()) {
    throw InternalError(fmt::format("simplifying {} broke its surface", solid.structure));
  }
  for (Shell& shell : simple.report.shells) shell.structure = solid.structure;
  StructureSimplification told{.structure = solid.structure,
                               .triangles_before = solid.surface.triangles.size(),
                               .triangles = simple.surface.triangles.size(),
                               .distance = simple.distance,
                               .self_intersections = simple.self_intersections,
                               .restarts = simple.restarts,
                               .kept_vertices = simple.kept_vertices};
  solid.surface = std::move(simple.surface);
  solid.report = std::move(simple.report);
  return told;
}

void tell_shells(const std::vector<Shell>& shells, Console& console) {
  constexpr std::size_t most_lines = 6;
  for (std::size_t i = 0; i < std::min(shells.size(), most_lines); ++i) console.say("  " + shell_in_words(shells[i]));
  if (shells.size() > most_lines) {
    console.say(fmt::format("  and {} smaller ones", shells.size() - most_lines));
  }
}

void tell_solid(const Solid& solid, Console& console) {
  console.say(fmt::format("{}: {} in {}", solid.structure, counted(solid.tetrahedra.tetrahedra.size(), "tetrahedron", "tetrahedra"),
                          counted(solid.report.shells.size(), "closed surface")));
  tell_shells(solid.report.shells, console);
}

void tell_simplification(const StructureSimplification& done, Console& console) {
  console.say(fmt::format("{}: simplified from {} to {}, off by {} mm on average and {} mm at most", done.structure,
                          counted(done.triangles_before, "triangle"), counted(done.triangles, "triangle"),
                          measured(done.distance.mean()), measured(done.distance.largest())));
}

}  // namespace

void simplify_model(Model& model, std::size_t triangles, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const double share = static_cast<double>(triangles) / static_cast<double>(triangles_in(model.reconstruction));
  for (Solid& solid : model.reconstruction.solids) {
    const auto aim = static_cast<std::size_t>(std::floor(share * static_cast<double>(solid.surface.triangles.size())));
    constexpr std::size_t smallest_closed_surface = 4;
    if (aim >= solid.surface.triangles.size()) continue;
    model.simplifications.push_back(simplify_solid(solid, std::max(aim, smallest_closed_surface), progress));
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  model.reconstruction.seconds.push_back({"simplify", taken.count()});
}

void tell_model(const Model& model, double seconds, Console& console) {
  const Reconstruction& made = model.reconstruction;
  for (const Solid& solid : made.solids) tell_solid(solid, console);
  for (const StructureSimplification& done : model.simplifications) tell_simplification(done, console);
  console.say(fmt::format("In all {} and {}, in {} s on {}.", counted(triangles_in(made), "triangle"),
                          counted(made.counts.kept, "tetrahedron", "tetrahedra"), measured(seconds),
                          counted(static_cast<std::size_t>(made.threads), "thread")));
  if (made.counts.isolated_regions > 0) {
    console.say(fmt::format("{} linked to nothing above or below and became thin plates; --correspondence overlap or --links "
                            "may connect them.",
                            counted(made.counts.isolated_regions, "region is", "regions are")));
  }
  console.say("certified: every surface is closed, manifold and oriented outwards.");
  console.say(fmt::format("  At each of the {} slices the {} exactly the contours given.", made.slices_checked,
                          model.simplifications.empty() ? "model is" : "full model, before simplification, is"));
}

void tell_model(const DbReconstruction& model, double seconds, Console& console) {
  std::size_t triangles = 0;
  bool sound = true;
  for (const DbSurface& made : model.surfaces) {
    triangles += made.report.triangles;
    const std::vector<std::string> defects = defects_in_words(made.report);
    sound = sound && defects.empty();
    console.say(fmt::format("{}: {}{}", made.structure, counted(made.report.triangles, "triangle"),
                            made.decimation_error ? fmt::format(", decimated from {}", counted(made.before.triangles, "triangle")) : ""));
    tell_shells(made.report.shells, console);
    if (!defects.empty()) console.say(fmt::format("  wanting: {}", fmt::join(defects, ", ")));
  }
  console.say(fmt::format("In all {} from a grid of {} x {} points in {}, in {} s on {}.", counted(triangles, "triangle"),
                          model.grid.columns, model.grid.rows, counted(model.grid.layers.size(), "layer"), measured(seconds),
                          counted(static_cast<std::size_t>(model.threads), "thread")));
  console.say(sound ? "closed, manifold and oriented outwards, as found by inspection; nothing else is certified."
                    : "not certified: not every surface is a closed, oriented manifold. That is what the method made of these contours.");
}

}  // namespace odontoscope::app
