// Every caption says something; here it is asserted of the geometry that the panel shows.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engine/figures/contour_sets.h"
#include "engine/figures/figures.h"
#include "engine/figures/papers_way.h"
#include "engine/figures/slab_steps.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope::figures {
namespace {

/// The tooth's models are shared: they take seconds.
ToothModels& tooth() {
  static ToothModels models({});
  return models;
}

const Figure& figure(int number) {
  static std::map<int, Figure> made;
  const auto found = made.find(number);
  return found != made.end() ? found->second : made.emplace(number, make_figure(number, tooth())).first->second;
}

SurfaceReport report(const Panel& panel, std::size_t surface = 0) {
  return inspect(panel.surfaces.at(surface).surface);
}

/// Closed surfaces of the panel's only structure; every one must be sound.
std::size_t solids(const Panel& panel) {
  const SurfaceReport of = report(panel);
  EXPECT_TRUE(of.closed_oriented_manifold()) << panel.caption;
  return of.shells.size();
}

std::size_t triangles(const Panel& panel) {
  std::size_t count = 0;
  for (const NamedSurface& named : panel.surfaces) count += named.surface.triangles.size();
  return count;
}

bool all_sound(const Panel& panel) {
  return std::all_of(panel.surfaces.begin(), panel.surfaces.end(),
                     [](const NamedSurface& named) { return inspect(named.surface).closed_oriented_manifold(); });
}

double median_smallest_angle(const Panel& panel) { return report(panel).smallest_angle_deg.median; }

TEST(PaperFigures, AreAllThereWithWords) {
  ASSERT_EQ(paper_figures().size(), 18u);
  for (int number = 1; number <= 18; ++number) {
    const Figure& made = figure(number);
    EXPECT_EQ(made.number, number);
    EXPECT_FALSE(made.title.empty());
    EXPECT_GT(made.caption.size(), 40u) << number;
    EXPECT_GE(made.panels.size(), 2u) << number;
    std::set<std::string> captions;
    for (const Panel& panel : made.panels) captions.insert(panel.caption);
    EXPECT_EQ(captions.size(), made.panels.size()) << number << ": two panels say the same";
    EXPECT_EQ(captions.count(""), 0u) << number;
  }
  EXPECT_THROW(make_figure(0, tooth()), UsageError);
  EXPECT_THROW(make_figure(19, tooth()), UsageError);
}

TEST(Figure1, HasAnOutsideAndAnInside) {
  const Panel& model = figure(1).panels[0];
  EXPECT_TRUE(all_sound(model));
  std::set<std::string> names;
  for (const NamedSurface& named : model.surfaces) names.insert(named.structure);
  EXPECT_EQ(names, (std::set<std::string>{"enamel", "dentine", "dentine cavity", "pulp"}));
  EXPECT_GT(figure(1).panels[1].strokes.at(0).ends.size(), 1000u);
}

TEST(Figure2, ReverseTetrahedraAreWhereContoursMatch) {
  const auto joining = [](const SlabSteps& steps) {
    return std::count_if(steps.reverse.begin(), steps.reverse.end(),
                         [](const ReverseTetrahedron& t) { return t.lower_inside && t.upper_inside; });
  };
  EXPECT_GT(joining(slab_steps(well_placed_pair())), 0);
  const SlabSteps branch = slab_steps(one_over_two());
  EXPECT_TRUE(std::any_of(branch.reverse.begin(), branch.reverse.end(),
                          [](const auto& t) { return !t.lower_inside && t.upper_inside; }));
  const SlabSteps apart = slab_steps(badly_placed_pair());
  EXPECT_FALSE(apart.delaunay.empty());
  EXPECT_EQ(apart.reverse.size(), 0u);
  const auto marked = [](const Panel& panel) {
    return panel.surfaces.size() == 2 ? panel.surfaces[0].surface.triangles.size() : 0u;
  };
  EXPECT_EQ(marked(figure(2).panels[0]), 4u) << "one tetrahedron";
  EXPECT_EQ(marked(figure(2).panels[1]), 4u);
  EXPECT_EQ(marked(figure(2).panels[2]), 0u);
  ReconstructOptions by_reverse;
  by_reverse.correspondence = Correspondence::reverse;
  EXPECT_EQ(reconstruct(well_placed_pair(), by_reverse).links.size(), 1u);
  EXPECT_EQ(reconstruct(badly_placed_pair(), by_reverse).links.size(), 0u);
}

TEST(Figure3, TheEdgeIsSingularOnlyWithoutTheTetrahedron) {
  const SlabSteps steps = slab_steps(one_over_two());
  EXPECT_EQ(steps.restored.size(), 1u) << "the caption speaks of one";
  ASSERT_EQ(steps.singular_edges.size(), 2u) << "one edge, two ends";
  EXPECT_EQ(steps.singular_edges[0].z, 2.2);
  EXPECT_EQ(steps.singular_edges[1].z, 2.2);
  EXPECT_GT(inspect(boundary_of(steps.points, steps.kept)).nonmanifold_edges, 0u);
  std::vector<Tetrahedron> whole = steps.kept;
  whole.insert(whole.end(), steps.restored.begin(), steps.restored.end());
  EXPECT_TRUE(singular_edges(steps.points, whole).empty());
  EXPECT_EQ(figure(3).panels[1].strokes.back().ends.size(), 2u);
}

TEST(Figure4, SubdivisionMakesOneSoundPieceThatLeavesTheSliceFree) {
  const SlabSteps steps = slab_steps(one_over_two());
  EXPECT_FALSE(steps.lifted.empty());
  for (const Point3& p : steps.lifted) {
    EXPECT_GT(p.z, 0) << "above the lower slice";
    EXPECT_LT(p.z, 2.2);
  }
  EXPECT_TRUE(singular_edges(steps.points, steps.solid).empty());
  const SurfaceReport of = inspect(boundary_of(steps.points, steps.solid));
  EXPECT_TRUE(of.closed_oriented_manifold());
  EXPECT_EQ(of.shells.size(), 1u);
}

TEST(Figures5And6, DbHasMoreTrianglesAndCracks) {
  const Panel &db = figure(5).panels[0], &dt = figure(6).panels[0];
  EXPECT_TRUE(all_sound(dt));
  EXPECT_FALSE(all_sound(db)) << "the classic table cracks";
  EXPECT_GT(triangles(db), triangles(dt));
}

TEST(Figure7, BothConnectConsecutiveSections) {
  EXPECT_EQ(solids(figure(7).panels[2]), 1u);
  EXPECT_EQ(solids(figure(7).panels[3]), 1u);
  EXPECT_GT(triangles(figure(7).panels[2]), 5 * triangles(figure(7).panels[3]));
}

TEST(Figure9, DtSeparatesWhatOverlapsSlightlyOrNotAtAll) {
  EXPECT_EQ(solids(figure(9).panels[0]), 1u);
  EXPECT_EQ(solids(figure(9).panels[1]), 2u);
  EXPECT_EQ(solids(figure(9).panels[2]), 2u);
}

TEST(Figure10, DtConnectsOnTheUsersWordAndOnlyThen) {
  EXPECT_EQ(solids(figure(10).panels[0]), 1u);
  EXPECT_EQ(solids(figure(10).panels[1]), 1u);
  const Reconstruction alone = reconstruct(shifted_stumps(1.88), papers_way());
  EXPECT_EQ(alone.solids[0].report.shells.size(), 2u) << "left to itself";
}

TEST(Figure11, DbConnectsSlightOverlapUnlessAnEmptyLayerParts) {
  EXPECT_EQ(solids(figure(11).panels[0]), 1u);
  EXPECT_EQ(solids(figure(11).panels[1]), 1u);
  EXPECT_EQ(solids(figure(11).panels[2]), 2u);
}

TEST(Figure12, DbStaysConnectedAsOverlapShrinks) {
  for (const Panel& panel : figure(12).panels) EXPECT_EQ(solids(panel), 1u) << panel.caption;
  for (const double shift : {1.68, 1.78, 1.88})
    EXPECT_EQ(reconstruct(shifted_stumps(shift), papers_way()).solids[0].report.shells.size(), 2u) << "DT at " << shift;
}

TEST(Figures13And14, TheFurcationIsSingularAndBothCloseIt) {
  const Reconstruction dt = reconstruct(molar_furcation(), papers_way());
  EXPECT_GT(dt.counts.restored, 0u) << "else there was no singularity to mend";
  EXPECT_EQ(solids(figure(13).panels[0]), 1u);
  EXPECT_EQ(solids(figure(13).panels[1]), 1u);
  const auto& panels = figure(14).panels;
  EXPECT_GT(triangles(panels[2]), 2 * triangles(panels[1]));
  EXPECT_LT(triangles(panels[3]), triangles(panels[2]) / 2);
}

TEST(Figures15And16, DecimationLeavesFewAndUnevenTriangles) {
  const auto& panels = figure(15).panels;
  EXPECT_LT(triangles(panels[2]), triangles(panels[1]) / 4);
  const double dt = median_smallest_angle(panels[0]), db = median_smallest_angle(panels[1]),
               decimated = median_smallest_angle(panels[2]);
  EXPECT_GT(dt, db);
  EXPECT_GT(dt, decimated);
  EXPECT_EQ(triangles(figure(16).panels[0]), triangles(panels[2]));
}

TEST(Figure17, StandsInTheCavityWhoseDtWallIsSoundAndDbWallIsNot) {
  const auto& panels = figure(17).panels;
  EXPECT_TRUE(all_sound(panels[1]));
  EXPECT_GT(report(panels[2]).misoriented_edges, 100u);
  for (const Look& look : panels[1].scene.looks)
    EXPECT_FALSE(look.as_body) << "else the wall would be seen from its wrong side";
  EXPECT_EQ(panels[1].scene.back_faces, BackFaces::cull);
  EXPECT_EQ(panels[2].scene.back_faces, BackFaces::cull);
  EXPECT_EQ(panels[3].scene.back_faces, BackFaces::show);
  EXPECT_EQ(panels[1].scene.camera, panels[2].scene.camera);
  // Inside the pulp by its own contours: below and above there are slices whose pulp holds the eye.
  const glm::dvec3 eye = panels[1].scene.camera.position;
  const ContourStack& stack = tooth().whole_contours();
  const auto nearest = std::min_element(stack.slices.begin(), stack.slices.end(), [&](const Slice& a, const Slice& b) {
    return std::abs(a.z - eye.z) < std::abs(b.z - eye.z);
  });
  bool inside = false;
  for (const Contour& contour : nearest->contours) {
    if (contour.structure != "pulp") continue;
    for (std::size_t i = 0, j = contour.points.size() - 1; i < contour.points.size(); j = i++) {
      const Point2 &a = contour.points[i], &b = contour.points[j];
      if ((a.y > eye.y) != (b.y > eye.y) && eye.x < (b.x - a.x) * (eye.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    }
  }
  EXPECT_TRUE(inside);
}

TEST(Figure18, TheTetrahedraFillTheirBoundary) {
  const auto& panels = figure(18).panels;
  const Reconstruction made = reconstruct(roots_and_trunk(), papers_way());
  EXPECT_EQ(panels[0].surfaces[0].surface.triangles.size(), 4 * made.solids[0].tetrahedra.tetrahedra.size());
  EXPECT_EQ(solids(panels[2]), 1u);
  EXPECT_EQ(report(panels[2]).shells[0].genus, 3)
      << "two canals into one chamber, and the chamber open above: three handles";
}

}  // namespace
}  // namespace odontoscope::figures
