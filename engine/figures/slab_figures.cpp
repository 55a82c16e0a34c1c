// Figures 2, 3, 4 and 18: what happens between two slices.

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "engine/figures/contour_sets.h"
#include "engine/figures/makers.h"
#include "engine/figures/panels.h"
#include "engine/figures/papers_way.h"
#include "engine/figures/slab_steps.h"
#include "recon/core/grouped.h"
#include "recon/delaunay/reconstruct.h"

namespace odontoscope::figures {
namespace {

constexpr double landscape = 4.0 / 3.0;
const glm::dvec3 from_above{-0.45, 0.9, 0.5}, along_the_gap{-0.75, 0.85, 0.3};
constexpr const char* reverse_name = "reverse tetrahedron";
constexpr const char* around_name = "other tetrahedra";
constexpr float see_through = 0.22f;

/// Every tetrahedron but these.
std::vector<Tetrahedron> without(std::vector<Tetrahedron> all, const std::vector<Tetrahedron>& left_out) {
  std::erase_if(all,
                [&](const Tetrahedron& t) { return std::find(left_out.begin(), left_out.end(), t) != left_out.end(); });
  return all;
}

void look(Panel& panel, const char* structure, const Colour& colour, float opacity) {
  if (Look* found = panel.scene.look_of(structure)) {
    found->colour = colour;
    found->opacity = opacity;
  }
}

/// Marked tetrahedra among others that one sees through.
Panel marked(std::string caption, const ContourStack& contours, const SlabSteps& steps,
             const std::vector<Tetrahedron>& special, const std::vector<Tetrahedron>& others, float others_opacity,
             const glm::dvec3& towards_eye = along_the_gap) {
  Subject subject;
  if (!special.empty()) subject.surfaces.push_back({reverse_name, shrunk(steps.points, special, 1), reverse_name});
  subject.surfaces.push_back({around_name, boundary_of(steps.points, others), around_name});
  subject.strokes.push_back(contour_strokes(contours));
  subject.crease_deg = 1;
  Panel made = panel(std::move(caption), std::move(subject), landscape, towards_eye);
  look(made, reverse_name, marked_colour, 1);
  look(made, around_name, other_colour, others_opacity);
  made.scene.occlusion.on = false;
  return made;
}

/// The largest of the reverse tetrahedra that `wanted` says yes to; none if there is none.
template <class Wanted>
std::vector<Tetrahedron> largest_reverse(const SlabSteps& steps, Wanted wanted) {
  const auto found = std::find_if(steps.reverse.begin(), steps.reverse.end(), wanted);
  return found == steps.reverse.end() ? std::vector<Tetrahedron>{} : std::vector<Tetrahedron>{found->corners};
}

}  // namespace

Figure reverse_tetrahedra(ToothModels&) {
  Figure figure;
  figure.aspect = landscape;
  figure.caption =
      "The Delaunay tetrahedra between two slices (faint). A tetrahedron is reverse (orange) if it has one edge in "
      "each slice and neither is part "
      "of a contour. Where it joins the insides of two contours, they belong together; no other test is needed.";
  const auto joins = [](const ReverseTetrahedron& t) { return t.lower_inside && t.upper_inside; };
  const ContourStack pair = well_placed_pair(), branch = one_over_two(), apart = badly_placed_pair();
  const SlabSteps of_pair = slab_steps(pair), of_branch = slab_steps(branch), of_apart = slab_steps(apart);
  figure.panels.push_back(
      marked("Two contours well above each other: a reverse tetrahedron joins an edge inside the lower with one inside "
             "the upper.",
             pair, of_pair, largest_reverse(of_pair, joins), of_pair.delaunay, see_through, from_above));
  figure.panels.push_back(marked(
      "Three contours: its lower edge spans the gap between the two below, its upper edge lies within the one above.",
      branch, of_branch, largest_reverse(of_branch, [](const auto& t) { return !t.lower_inside && t.upper_inside; }),
      of_branch.delaunay, see_through));
  figure.panels.push_back(
      marked("Two contours that are not above each other: the tetrahedra between them are there, but none is reverse.",
             apart, of_apart, largest_reverse(of_apart, joins), of_apart.delaunay, see_through, from_above));
  return figure;
}

Figure singular_edge(ToothModels&) {
  Figure figure;
  figure.aspect = landscape;
  figure.caption =
      "One contour above two. The tetrahedra between the two lower contours have an edge outside the tooth, in the "
      "plane of the lower slice, and must "
      "go; but without them the solid hangs together by mere edges. An edge is singular where more than two outer "
      "faces meet.";
  const ContourStack branch = one_over_two();
  const SlabSteps steps = slab_steps(branch);
  figure.panels.push_back(
      marked(fmt::format("Before: the reverse tetrahedr{} (orange) that repair will want back fill{} the gap.",
                         steps.restored.size() == 1 ? "on" : "a", steps.restored.size() == 1 ? "s" : ""),
             branch, steps, steps.restored, without(steps.delaunay, steps.restored), see_through));
  Panel after = marked("After: two wedges of the solid touch along the marked edge and nowhere else.", branch, steps,
                       {}, steps.kept, 1);
  after.strokes.push_back(strokes(LineKind::misoriented_edge, steps.singular_edges));
  after.scene.wire = true;
  figure.panels.push_back(std::move(after));
  return figure;
}

Figure subdivision(ToothModels&) {
  Figure figure;
  figure.aspect = landscape;
  figure.caption =
      "The tetrahedra whose loss would make an edge singular stay, but are cut in two at their outer edge, and the new "
      "point is lifted out of the slice. "
      "The slice then cuts the solid in its own contours and nothing more, and every edge is regular.";
  const ContourStack branch = one_over_two();
  const SlabSteps steps = slab_steps(branch);
  Panel before =
      marked("Put back as they were, the tetrahedra (orange) lie with an edge in the lower slice, where no tooth is.",
             branch, steps, steps.restored, steps.kept, see_through);
  Panel after = marked("Split and lifted: beneath the bridge the slice is free again.", branch, steps, steps.split,
                       without(steps.solid, steps.split), see_through);
  Panel result = marked("The solid that comes out: one piece, no singular edge.", branch, steps, {}, steps.solid, 1);
  result.scene.wire = true;
  for (const Point3& p : steps.lifted) after.strokes.push_back(strokes(LineKind::measure, {p, p}));
  figure.panels = {std::move(before), std::move(after), std::move(result)};
  return figure;
}

Figure slab_volume(ToothModels&) {
  Figure figure;
  figure.aspect = landscape;
  const ContourStack contours = roots_and_trunk();
  const Reconstruction made = reconstruct(contours, papers_way());
  const Solid& solid = made.solids.front();
  const TetraMesh& mesh = solid.tetrahedra;
  figure.caption = fmt::format(
      "DT fills the inside: two sections as of a molar, two roots with their canals below and the trunk with the pulp "
      "chamber above, and the {} tetrahedra between them. They are what a "
      "simulation computes on; a distance field with marching cubes gives a surface alone.",
      grouped(mesh.tetrahedra.size()));
  Panel elements =
      panel("The tetrahedra, each shrunk so that they come apart.",
            {.surfaces = {{"dentine", shrunk(mesh.points, mesh.tetrahedra, 0.72), "dentine"}}, .crease_deg = 1},
            landscape, from_above);
  Panel boundary = panel("Their outside: a closed surface, with the canals running up into the chamber.",
                         {.surfaces = {{"dentine", solid.surface, "dentine"}}, .strokes = {contour_strokes(contours)}},
                         landscape, from_above);
  Panel wires = boundary;
  wires.caption = "The edges of all of them, inside and out.";
  wires.strokes = {edge_strokes(mesh)};
  for (Look& look : wires.scene.looks) look.visible = false;
  figure.panels = {std::move(elements), std::move(wires), std::move(boundary)};
  return figure;
}

}  // namespace odontoscope::figures
