#include "engine/app/made_model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

#include "engine/app/words.h"
#include "recon/core/error.h"
#include "recon/core/grouped.h"
#include "recon/core/limits.h"
#include "recon/delaunay/verdict.h"
#include "recon/elements/limits.h"
#include "recon/mesh/tetra_report.h"
#include "recon/output/simplify_model.h"

namespace odontoscope::app {
namespace {

std::size_t triangles_in(const Reconstruction& reconstruction) {
  std::size_t sum = 0;
  for (const Solid& solid : reconstruction.solids) sum += solid.surface.triangles.size();
  return sum;
}

std::string remedies_in_words(const std::vector<Link>& remedies) {
  std::vector<std::string> words;
  for (const Link& link : remedies)
    words.push_back(fmt::format("slice {} contour {} of {} with slice {} contour {}", link.slice, link.lower,
                                link.structure, link.slice + 1, link.upper));
  return fmt::format("{} tried, and would join such a region; if meant, say so with --links: {}.",
                     counted(remedies.size(), "link was", "links were"), fmt::join(words, "; "));
}

void tell_shells(const std::vector<Shell>& shells, Console& console) {
  constexpr std::size_t most_lines = 6;
  for (std::size_t i = 0; i < std::min(shells.size(), most_lines); ++i) console.say("  " + shell_in_words(shells[i]));
  if (shells.size() > most_lines) {
    console.say(fmt::format("  and {} smaller ones", shells.size() - most_lines));
  }
}

void tell_solid(const Solid& solid, Console& console) {
  console.say(fmt::format("{}: {} in {}", solid.structure,
                          counted(solid.tetrahedra.tetrahedra.size(), "tetrahedron", "tetrahedra"),
                          counted(solid.report.shells.size(), "closed surface")));
  tell_shells(solid.report.shells, console);
}

void tell_simplification(const StructureSimplification& done, Console& console) {
  console.say(fmt::format("{}: simplified from {} to {}, off by {} mm on average and {} mm at most", done.structure,
                          counted(done.triangles_before, "triangle"), counted(done.triangles, "triangle"),
                          measured(done.distance.mean()), measured(done.distance.largest())));
}

void tell_elements(const ModelElements& elements, Console& console) {
  for (const elements::MaterialElements& one : elements.materials) {
    console.say(fmt::format(
        "{}: {} of about {} mm, angles {:.1f} to {:.1f} degrees; off the exact surface by {} mm on average and {} mm "
        "at most, volume {:+.2f} %",
        one.structure, counted(one.shape.tetrahedra, "element"), measured(elements.size),
        one.shape.smallest_dihedral_deg.min, one.shape.largest_dihedral_deg.max, measured(one.distance.mean()),
        measured(one.distance.largest()), 100 * (one.shape.volume / one.exact_volume - 1)));
  }
  if (elements.size < elements.asked)
    console.say(fmt::format("Elements of {} mm would have changed the topology or came to no end, so they are smaller.",
                            measured(elements.asked)));
}

}  // namespace

std::string report_of(const MadeModel& made) {
  const Model& model = made.model;
  return report_json(
      model.reconstruction,
      {.simplifications = model.simplifications, .volume = made.volume, .aim = model.aim, .elements = model.elements});
}

void simplify_model(Model& model, std::size_t triangles, const Progress& progress) {
  ModelSimplification done = simplify_surfaces(model.reconstruction, triangles, progress);
  model.simplifications = std::move(done.structures);
  model.aim = done.aim;
}

std::optional<double> element_size_from(const std::string& text) {
  if (text == "quality") return std::nullopt;
  double size = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  if (error == std::errc() && end == text.data() + text.size() && size >= elements::limits::least_size &&
      size <= limits::largest_coordinate)
    return size;
  throw UsageError(fmt::format("--elements {}: that is neither a size in mm, from {} on, nor quality", text,
                               elements::limits::least_size),
                   "Say how long edges of elements may be, as --elements 0.5");
}

void mesh_model(Model& model, std::optional<double> size, const Progress& progress) {
  model.elements = mesh_elements(model.reconstruction, size, progress);
}

void move_model(Model& model, const RigidMotion& motion) {
  for (Solid& solid : model.reconstruction.solids) {
    for (Point3& p : solid.tetrahedra.points) p = motion(p);
    for (Point3& p : solid.surface.points) p = motion(p);
    solid.report = inspect(solid.surface);
    for (Shell& shell : solid.report.shells) shell.structure = solid.structure;
    const std::size_t flat = inspect(solid.tetrahedra).non_positive;
    if (flat == 0 && solid.report.closed_oriented_manifold()) continue;
    throw InputError("turned-flat", {},
                     fmt::format("{}: {} of {} tetrahedra became flat when the model was turned back, by rounding",
                                 solid.structure, grouped(flat), solid.tetrahedra.tetrahedra.size()),
                     "Leave --as-given out: the report's matrix tells the turn");
  }
}

std::string missed_aim_in_words(const SimplificationAim& aim) {
  if (aim.reached()) return {};
  std::vector<std::string> reasons;
  const auto add = [&](std::size_t edges, const char* what) {
    if (edges > 0) reasons.push_back(fmt::format("{} {}", counted(edges, "edge"), what));
  };
  add(aim.obstacles.topology, "would change pieces, handles or cavities");
  add(aim.obstacles.cuts, "would make the surface cut through itself");
  add(aim.obstacles.shape, "would turn triangles over or lead far off");
  return fmt::format("{} are left, not {} as asked for: no edge of theirs can be collapsed any more ({})",
                     counted(aim.triangles, "triangle"), grouped(aim.aim), fmt::join(reasons, "; "));
}

std::string absurd_distance_in_words(const std::vector<StructureSimplification>& simplifications) {
  std::vector<std::string> words;
  for (const StructureSimplification& done : simplifications) {
    const double share = done.distance.largest() / done.diagonal;
    if (share <= limits::absurd_distance) continue;
    words.push_back(fmt::format("{} is off by up to {} mm, {:.0f} % of its size", done.structure,
                                measured(done.distance.largest()), 100 * share));
  }
  if (words.empty()) return {};
  return fmt::format("the simplified surface is hardly the model any more: {}; ask for more triangles",
                     fmt::join(words, ", "));
}

void tell_model(const Model& model, double seconds, Console& console) {
  const Reconstruction& made = model.reconstruction;
  for (const Solid& solid : made.solids) tell_solid(solid, console);
  for (const StructureSimplification& done : model.simplifications) {
    if (done.triangles < done.triangles_before) tell_simplification(done, console);
  }
  if (model.elements) tell_elements(*model.elements, console);
  console.say(fmt::format("In all {} and {}, in {} s on {}.", counted(triangles_in(made), "triangle"),
                          counted(made.counts.kept, "tetrahedron", "tetrahedra"), measured(seconds),
                          counted(static_cast<std::size_t>(made.threads), "thread")));
  if (const std::string changes = in_words(made.changes); !changes.empty()) console.say(changes + ".");
  if (made.counts.isolated_regions > 0) {
    console.say(fmt::format("{} linked to nothing above or below and became thin plates.",
                            counted(made.counts.isolated_regions, "region is", "regions are")));
    if (!made.remedies.empty()) console.say("  " + remedies_in_words(made.remedies));
  }
  console.say("certified: every surface is closed, manifold and oriented outwards.");
  console.say(fmt::format("  At each of the {} slices the {} exactly the contours given.", made.slices_checked,
                          model.elements                  ? "full model, before it was meshed anew, is"
                          : model.simplifications.empty() ? "model is"
                                                          : "full model, before simplification, is"));
  console.say(headline(made) + ".");
}

void tell_model(const DbReconstruction& model, double seconds, Console& console) {
  std::size_t triangles = 0;
  bool sound = true;
  for (const DbSurface& made : model.surfaces) {
    triangles += made.report.triangles;
    const std::vector<std::string> defects = defects_in_words(made.report);
    sound = sound && defects.empty();
    console.say(fmt::format(
        "{}: {}{}", made.structure, counted(made.report.triangles, "triangle"),
        made.decimation_error ? fmt::format(", decimated from {}", counted(made.before.triangles, "triangle")) : ""));
    tell_shells(made.report.shells, console);
    if (!defects.empty()) console.say(fmt::format("  wanting: {}", fmt::join(defects, ", ")));
  }
  console.say(fmt::format("In all {} from a grid of {} x {} points in {}, in {} s on {}.",
                          counted(triangles, "triangle"), model.grid.columns, model.grid.rows,
                          counted(model.grid.layers.size(), "layer"), measured(seconds),
                          counted(static_cast<std::size_t>(model.threads), "thread")));
  console.say(sound ? "closed, manifold and oriented outwards, as found by inspection; nothing else is certified."
                    : "not certified: not every surface is a closed, oriented manifold. That is what the method made "
                      "of these contours.");
}

}  // namespace odontoscope::app
