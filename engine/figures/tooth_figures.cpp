// Figures 1, 5, 6 and 13 to 17: the tooth as a whole and near by.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "engine/figures/contour_sets.h"
#include "engine/figures/makers.h"
#include "engine/figures/panels.h"
#include "engine/measure/triangle_tree.h"
#include "recon/compare/contour_fit.h"
#include "recon/core/error.h"
#include "recon/core/grouped.h"
#include "recon/input/validate.h"

namespace odontoscope::figures {
namespace {

constexpr double portrait = 3.0 / 4.0, square = 1;
const glm::dvec3 from_the_cheek{-0.35, 1, 0.12};
const glm::dvec3 from_below{-0.3, 1, -0.25};

Panel tooth_panel(std::string caption, const ToothModel& model, const glm::dvec3& towards_eye = from_the_cheek) {
  return panel(std::move(caption), {.surfaces = model.surfaces}, portrait, towards_eye);
}

/// The lowest point of the surfaces: the tip of a root.
Point3 lowest_point(const std::vector<NamedSurface>& surfaces) {
  Point3 lowest{0, 0, std::numeric_limits<double>::max()};
  for (const NamedSurface& named : surfaces)
    for (const Triangle& triangle : named.surface.triangles)
      for (const PointIndex p : triangle)
        if (named.surface.points[p].z < lowest.z) lowest = named.surface.points[p];
  return lowest;
}

double height_of(const ContourStack& stack) {
  const auto [low, high] = std::minmax_element(stack.slices.begin(), stack.slices.end(),
                                               [](const Slice& a, const Slice& b) { return a.z < b.z; });
  return high->z - low->z;
}

ContourStack every_third(const ContourStack& stack) {
  ContourStack fewer;
  for (std::size_t k = 0; k < stack.slices.size(); k += 3) fewer.slices.push_back(stack.slices[k]);
  return fewer;
}

/// The solid that has a cavity, the pulp's; none if no solid has one.
std::string hollow_solid(const ToothModel& model) {
  const auto found = std::find_if(model.surfaces.begin(), model.surfaces.end(),
                                  [](const NamedSurface& named) { return named.cavity; });
  return found == model.surfaces.end() ? std::string() : found->solid;
}

/// The middle of the widest hole that a slice has in that structure: in the pulp chamber.
Point3 middle_of_the_chamber(const ContourStack& contours, const std::string& structure) {
  const ContourStack sorted = ordered(contours).stack;
  ContourPassage widest;
  for (const ContourPassage& passage : passages(sorted, structure))
    if (passage.hole && passage.width > widest.width) widest = passage;
  return {widest.middle.x, widest.middle.y, sorted.slices[widest.slice].z};
}

}  // namespace

Figure tooth_and_contours(ToothModels& tooth) {
  Figure figure;
  figure.aspect = portrait;
  const ToothModel& model = tooth.whole_dt();
  figure.caption = fmt::format(
      "Contours of {}, {} slices, reconstructed by DT: an outside and an inside, which can be made together or each by "
      "itself.",
      tooth.name().empty() ? "a tooth" : tooth.name(), grouped(tooth.whole_contours().slices.size()));
  Panel clear = tooth_panel("The model, its outside clear so that the pulp shows.", model);
  const Scene usual = usual_scene(make_model(clear.surfaces), portrait);
  clear.scene.looks = usual.looks;
  Panel lines = tooth_panel("The contours, every third slice.", model);
  lines.strokes = {contour_strokes(every_third(tooth.whole_contours()))};
  for (Look& look : lines.scene.looks) look.visible = false;
  figure.panels = {std::move(clear), std::move(lines)};
  return figure;
}

Figure tooth_by_db(ToothModels& tooth) {
  Figure figure;
  figure.aspect = portrait;
  const ToothModel& model = tooth.db();
  figure.caption = fmt::format("DB on a grid of {0} x {0} points a slice, classic marching cubes. {1}", tooth.grid(),
                               tooth.is_sample() ? "Near the tips of the roots, where a section reaches well beyond "
                                                   "the one below it, there are ridges, one a slice, that the contours "
                                                   "do not have. They are shallow, but light shows them."
                                                 : "Where a section reaches well beyond the one below it there may be "
                                                   "ridges, one a slice, that the contours do not have.");
  Panel shaded = tooth_panel("The outside.", model, from_below);
  Panel ridges = shaded;
  ridges.caption = tooth.is_sample() ? "The ridges, from near the tip of a root." : "The lower end from near by.";
  const Point3 tip = lowest_point(model.surfaces);
  const double height = height_of(tooth.outer_contours());
  look_closer(ridges, {tip.x, tip.y, tip.z + 0.11 * height}, 0.14 * height);
  Panel mesh = with_mesh(fmt::format("Its mesh: {} triangles.", grouped(model.triangles)), shaded);
  figure.panels = {std::move(shaded), std::move(ridges), std::move(mesh)};
  return figure;
}

Figure tooth_by_dt(ToothModels& tooth) {
  Figure figure;
  figure.aspect = portrait;
  const ToothModel& model = tooth.dt();
  figure.caption = "DT on the same contours, seen from the same places: every triangle spans from contour to contour.";
  if (tooth.is_sample()) figure.caption += " No ridges.";
  Panel shaded = tooth_panel("The outside.", model, from_below);
  Panel near = shaded;
  near.caption = "The same place.";
  const Point3 tip = lowest_point(model.surfaces);
  const double height = height_of(tooth.outer_contours());
  look_closer(near, {tip.x, tip.y, tip.z + 0.11 * height}, 0.14 * height);
  Panel mesh = with_mesh(
      fmt::format("Its mesh: {} triangles, against {} by DB.", grouped(model.triangles), grouped(tooth.db().triangles)),
      shaded);
  figure.panels = {std::move(shaded), std::move(near), std::move(mesh)};
  return figure;
}

namespace {

struct Furcation {
  ContourStack contours = molar_furcation();
  std::vector<NamedSurface> dt, db, decimated;
};

Furcation furcation_models(std::size_t columns) {
  Furcation made;
  made.dt = dt_surfaces(made.contours);
  made.db = db_surfaces(made.contours, columns);
  DbOptions fewer;
  fewer.grid.columns = fewer.grid.rows = columns;
  fewer.cases = CaseTable::consistent;
  fewer.decimation = DecimateOptions{};
  for (DbSurface& one : reconstruct_by_distance(made.contours, fewer).surfaces)
    made.decimated.push_back({one.structure, std::move(one.surface), one.structure});
  return made;
}

constexpr std::size_t furcation_grid = 64;
const glm::dvec3 under_the_arch{-0.2, 1, -0.1};

Panel furcation_panel(std::string caption, const std::vector<NamedSurface>& surfaces, const Colour& colour) {
  Panel made = panel(std::move(caption), {.surfaces = surfaces}, square, under_the_arch);
  paint(made, colour);
  return made;
}

}  // namespace

Figure singularities(ToothModels&) {
  Figure figure;
  figure.aspect = square;
  figure.caption =
      "The furcation of the sample molar. Between one slice and the next two contours become one: the place where a "
      "naive solid hangs "
      "together by an edge or a point (figure 3). Both methods close it to a proper surface.";
  const Furcation made = furcation_models(furcation_grid);
  figure.panels = {furcation_panel("DT.", made.dt, dt_colour), furcation_panel("DB.", made.db, db_colour)};
  return figure;
}

Figure singularity_meshes(ToothModels&) {
  Figure figure;
  figure.aspect = square;
  figure.caption =
      "The meshes of figure 13. DT's triangles are of a size with the spacing of the contours' points. DB has far "
      "more, many of them slivers where the "
      "surface just touches a cell, and decimation makes them fewer but not even.";
  const Furcation made = furcation_models(furcation_grid);
  figure.panels.push_back(furcation_panel("The contours.", made.dt, dt_colour));
  figure.panels.back().strokes = {contour_strokes(made.contours)};
  for (Look& look : figure.panels.back().scene.looks) look.visible = false;
  const auto add = [&](const char* method, const std::vector<NamedSurface>& surfaces, const Colour& colour) {
    figure.panels.push_back(with_mesh(fmt::format("{}: {} triangles.", method, grouped(triangles_of(surfaces))),
                                      furcation_panel({}, surfaces, colour)));
  };
  add("DT", made.dt, dt_colour);
  add("DB", made.db, db_colour);
  add("DB, decimated to the most possible", made.decimated, decimated_colour);
  return figure;
}

Figure mesh_details(ToothModels& tooth) {
  Figure figure;
  figure.aspect = square;
  figure.caption = fmt::format(
      "The lower end of the tooth of figures 5 and 6. The paper counted 7,995 triangles for DT, 94,627 for DB and "
      "3,817 after decimation; here, with contours and grid "
      "of our own, {}, {} and {}.",
      grouped(tooth.dt().triangles), grouped(tooth.db().triangles), grouped(tooth.decimated().triangles));
  const Point3 tip = lowest_point(tooth.dt().surfaces);
  const double height = height_of(tooth.outer_contours());
  const auto add = [&](const char* caption, const ToothModel& model, const Colour& colour) {
    Panel near = panel(caption, {.surfaces = model.surfaces}, square, from_below);
    paint(near, colour);
    look_closer(near, {tip.x, tip.y, tip.z + 0.07 * height}, 0.09 * height);
    near.scene.wire = true;
    figure.panels.push_back(std::move(near));
  };
  add("DT: its triangles span from contour to contour.", tooth.dt(), dt_colour);
  add("DB: its triangles are what the grid's cells make of the surface.", tooth.db(), db_colour);
  add("DB decimated: few, but uneven.", tooth.decimated(), decimated_colour);
  return figure;
}

Figure decimated_shaded(ToothModels& tooth) {
  Figure figure;
  figure.aspect = portrait;
  figure.caption = fmt::format(
      "The DB model after decimation to the most possible ({} of {} triangles are left). It looks blocky, with facets "
      "of all sizes.",
      grouped(tooth.decimated().triangles), grouped(tooth.db().triangles));
  figure.panels.push_back(panel("Shaded triangle by triangle.",
                                {.surfaces = tooth.decimated().surfaces, .crease_deg = 1}, portrait, from_below));
  figure.panels.push_back(with_mesh("With its mesh.", figure.panels.front()));
  return figure;
}

namespace {

/// How far one sees from `from` to the first wall of the model.
double sight(const TriangleTree& tree, const glm::dvec3& from, const glm::dvec3& direction) {
  const auto wall =
      tree.nearest({.origin = from, .direction = glm::normalize(direction)}, [](const Crossing&) { return true; });
  return wall ? wall->distance : 0;
}

/// Stands in the pulp chamber, near one end of its longer axis and under its roof, and looks to the other end and down.
Camera in_the_chamber(const ToothModels& tooth, const ToothModel& model) {
  const std::string solid = hollow_solid(model);
  const Point3 widest = middle_of_the_chamber(tooth.whole_contours(), solid);
  std::vector<NamedSurface> walls;
  for (const NamedSurface& named : model.surfaces)
    if (named.solid == solid) walls.push_back(named);
  const Model shown = make_model(walls);
  const TriangleTree tree(shown);
  const auto metres = [&](const glm::dvec3& place) { return metres_per_mm * (place - shown.origin_mm); };
  glm::dvec3 middle{widest.x, widest.y, widest.z};
  const auto room = [&](const glm::dvec3& direction) { return sight(tree, metres(middle), direction) / metres_per_mm; };
  middle.z += 0.5 * (room({0, 0, 1}) - room({0, 0, -1}));
  const bool along_x = room({1, 0, 0}) + room({-1, 0, 0}) >= room({0, 1, 0}) + room({0, -1, 0});
  const glm::dvec3 axis = along_x ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  constexpr double back = 0.75, ahead = 0.35;
  Camera camera;
  camera.position = middle - back * room(-axis) * axis + glm::dvec3(0, 0, 0.4 * room({0, 0, 1}));
  camera.target = middle + ahead * room(axis) * axis - glm::dvec3(0, 0, room({0, 0, -1}));
  camera.field_of_view_deg = 80;
  return camera;
}

/// A ring around the place where the next pictures are taken from, and the way that they look.
Strokes eye_mark(const Camera& camera, double length) {
  Strokes mark{LineKind::measure, {}};
  const auto add = [&](const glm::dvec3& from, const glm::dvec3& to) {
    mark.ends.push_back({from.x, from.y, from.z});
    mark.ends.push_back({to.x, to.y, to.z});
  };
  const glm::dvec3 &at = camera.position, ahead = glm::normalize(camera.target - at);
  const glm::dvec3 tip = at + 2.4 * length * ahead, aside = glm::normalize(glm::cross(ahead, glm::dvec3(0, 1, 0)));
  add(at, tip);
  add(tip, tip - 0.8 * length * ahead + 0.6 * length * aside);
  add(tip, tip - 0.8 * length * ahead - 0.6 * length * aside);
  constexpr int sides = 24;
  const auto on_ring = [&](int i) {
    const double angle = glm::radians(360.0 * i / sides);
    return at + 0.5 * length * glm::dvec3(std::cos(angle), 0, std::sin(angle));
  };
  for (int i = 0; i < sides; ++i) add(on_ring(i), on_ring(i + 1));
  return mark;
}

Panel within(const char* caption, const ToothModel& model, const std::string& solid, const Camera& camera) {
  std::vector<NamedSurface> walls;
  for (const NamedSurface& named : model.surfaces)
    if (named.solid == solid) walls.push_back(named);
  Panel inside = panel(caption, {.surfaces = std::move(walls)}, square);
  inside.scene.camera = camera;
  paint(inside, usual_colour(solid, 0));
  for (Look& look : inside.scene.looks) look.as_body = false;  // the wall itself, as its winding is
  return inside;
}

}  // namespace

Figure inside_the_tooth(ToothModels& tooth) {
  Figure figure;
  figure.aspect = square;
  figure.caption =
      "From within the pulp chamber, as viewers for games and the web draw: triangles seen from behind are left out. "
      "DT's walls are all there. With "
      "a table of cases whose triangles are not oriented, which went unnoticed as long as both sides were drawn, DB's "
      "walls have holes.";
  const std::string solid = hollow_solid(tooth.whole_dt());
  if (solid.empty())
    throw InputError("no-cavity", {}, "the tooth has no cavity to look around in, so that figure 17 cannot be made",
                     "Leave it out (--only), or give contours of a tooth with its pulp chamber");
  const Camera camera = in_the_chamber(tooth, tooth.whole_dt());
  Panel cut = panel("Where we stand, and where we look: the tooth cut open.", {.surfaces = tooth.whole_dt().surfaces},
                    square, NamedView::buccal);
  cut.scene.section = Section{camera.position, {0, 1, 0}};
  if (Look* pulp = cut.scene.look_of("pulp")) pulp->visible = false;
  for (Look& look : cut.scene.looks) look.as_body = false;
  cut.strokes.push_back(eye_mark(camera, 0.05 * height_of(tooth.whole_contours())));
  Panel both_sides = within("DB with unoriented cases, both sides drawn.", tooth.whole_unoriented(), solid, camera);
  both_sides.scene.back_faces = BackFaces::show;
  figure.panels = {std::move(cut),
                   within("DT: walls, floor, and the way down into the canals.", tooth.whole_dt(), solid, camera),
                   within("DB with unoriented cases.", tooth.whole_unoriented(), solid, camera), std::move(both_sides)};
  return figure;
}

}  // namespace odontoscope::figures
