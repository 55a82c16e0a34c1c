// Figures 7 to 12: which contours of two slices belong together.

#include <fmt/format.h>

#include "engine/figures/contour_sets.h"
#include "engine/figures/makers.h"
#include "engine/figures/panels.h"
#include "recon/core/grouped.h"

namespace odontoscope::figures {
namespace {

constexpr double as_wide_as_high = 1;
const glm::dvec3 from_the_side{0.1, 1, 0.28};
constexpr std::size_t grid = 96;
/// How far the upper stump stands aside, in radii.
constexpr double well = 0.45, slightly = 1.6, not_at_all = 2.25;
constexpr double between[] = {1.68, 1.78, 1.88};

Panel shaded(std::string caption, const ContourStack& stack, std::vector<NamedSurface> surfaces, const Colour& colour) {
  Panel made = panel(std::move(caption), {.surfaces = std::move(surfaces), .strokes = {contour_strokes(stack)}},
                     as_wide_as_high, from_the_side);
  paint(made, colour);
  return made;
}

/// Contours alone, seen as the models are.
Panel lines_only(std::string caption, const ContourStack& stack) {
  Panel made = shaded(std::move(caption), stack, dt_surfaces(stack), dt_colour);
  for (Look& look : made.scene.looks) look.visible = false;
  return made;
}

std::string share(double radii) { return fmt::format("{:g} of the radius", radii); }
double last_of_lower() { return stump_spacing * static_cast<double>(stump_slices - 1); }
/// The user's word that the two stumps are one.
std::vector<Link> forced() { return {{"tooth", stump_slices - 1, 0, 0, true}}; }

}  // namespace

Figure consecutive_contours(ToothModels&) {
  Figure figure;
  figure.aspect = as_wide_as_high;
  figure.caption =
      "Two neighbouring sections, as through the crown of a molar, that overlap well: both methods connect them. DT "
      "puts its triangles between the points that "
      "were given; DB puts them where its grid is.";
  const ContourStack stack = crown_sections();
  figure.panels.push_back(lines_only("The two contours from the side.", stack));
  Panel top = lines_only("The same from above: the lower lies within the upper.", stack);
  Subject seen{.surfaces = top.surfaces, .strokes = top.strokes};
  const std::string caption = top.caption;
  top = panel(caption, std::move(seen), as_wide_as_high, NamedView::occlusal);
  for (Look& look : top.scene.looks) look.visible = false;
  figure.panels.push_back(std::move(top));
  const auto db = db_surfaces(stack, grid / 2), dt = dt_surfaces(stack);
  figure.panels.push_back(with_mesh({}, shaded({}, stack, db, db_colour)));
  figure.panels.back().caption =
      fmt::format("DB on a grid of {0} x {0}: {1} triangles.", grid / 2, grouped(triangles_of(db)));
  figure.panels.push_back(
      with_mesh(fmt::format("DT: {} triangles.", grouped(triangles_of(dt))), shaded({}, stack, dt, dt_colour)));
  return figure;
}

Figure overlap_patterns(ToothModels&) {
  Figure figure;
  figure.aspect = as_wide_as_high;
  figure.caption =
      "Two stumps of four round contours each, one above the other, set apart sideways. The next figures are made from "
      "these. Which of them are "
      "one piece of tooth? The contours do not say.";
  figure.panels.push_back(
      lines_only(fmt::format("Shifted by {}: most of the area overlaps.", share(well)), shifted_stumps(well)));
  figure.panels.push_back(
      lines_only(fmt::format("Shifted by {}: a narrow lens overlaps.", share(slightly)), shifted_stumps(slightly)));
  figure.panels.push_back(
      lines_only(fmt::format("Shifted by {}: nothing overlaps.", share(not_at_all)), shifted_stumps(not_at_all)));
  return figure;
}

Figure dt_separates(ToothModels&) {
  Figure figure;
  figure.aspect = as_wide_as_high;
  figure.caption =
      "DT, left to itself, on the contours of figure 8. Stumps that overlap well become one; the others end flat, each "
      "on its own slice, closed and "
      "whole.";
  const auto add = [&](std::string caption, double shift) {
    const ContourStack stack = shifted_stumps(shift);
    figure.panels.push_back(shaded(std::move(caption), stack, dt_surfaces(stack), dt_colour));
  };
  add("Good overlap: one solid.", well);
  add("Slight overlap: two solids.", slightly);
  add("No overlap: two solids.", not_at_all);
  return figure;
}

Figure dt_forced(ToothModels&) {
  Figure figure;
  figure.aspect = as_wide_as_high;
  const ContourStack stack = shifted_stumps(between[2]);
  const auto surfaces = dt_surfaces(stack, forced());
  figure.caption =
      "The contours of figure 12(c), which DT would keep apart, connected by the user's word (one line in a links "
      "file). Compare with what DB makes of them: "
      "DT's bridge is smooth and takes no more triangles than the rest.";
  figure.panels.push_back(shaded("One solid, as asked for.", stack, surfaces, dt_colour));
  figure.panels.push_back(with_mesh(fmt::format("Its mesh: {} triangles.", grouped(triangles_of(surfaces))),
                                    shaded({}, stack, surfaces, dt_colour)));
  return figure;
}

Figure db_connects(ToothModels&) {
  Figure figure;
  figure.aspect = as_wide_as_high;
  figure.caption =
      "DB on the contours of figure 8. It knows no correspondence: whatever has grid points inside both contours "
      "becomes one. That makes a thin neck "
      "with a sharp ledge on either side, which on a tooth shows as ridges along slanting roots (figure 5).";
  const auto add = [&](std::string caption, double shift, const std::vector<double>& splits) {
    const ContourStack stack = shifted_stumps(shift);
    figure.panels.push_back(shaded(std::move(caption), stack, db_surfaces(stack, grid, splits), db_colour));
  };
  add("Good overlap: one surface.", well, {});
  add("Slight overlap: one surface all the same.", slightly, {});
  add("The same contours forced apart by an empty layer put between the slices.", slightly,
      {last_of_lower() + stump_spacing / 2});
  return figure;
}

Figure db_between(ToothModels&) {
  Figure figure;
  figure.aspect = as_wide_as_high;
  figure.caption =
      "DB with contours in between those of figure 8(b) and 8(c). As the overlap shrinks the neck gets thinner and its "
      "shape is more and more the grid's "
      "and less the tooth's, but the two stay connected.";
  const char* letters[] = {"Shifted by {}.", "Shifted by {}.",
                           "Shifted by {}: a mere thread, where DT makes the bridge of figure 10."};
  for (int i = 0; i < 3; ++i) {
    const ContourStack stack = shifted_stumps(between[i]);
    figure.panels.push_back(
        shaded(fmt::format(fmt::runtime(letters[i]), share(between[i])), stack, db_surfaces(stack, grid), db_colour));
  }
  return figure;
}

}  // namespace odontoscope::figures
