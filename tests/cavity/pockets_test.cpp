// Canals that open to the outside.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "recon/cavity/anatomy.h"
#include "recon/cavity/cavity.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/sample/sample_tooth.h"
#include "tests/cavity/fine_lines.h"
#include "tests/mesh/shapes.h"

namespace odontoscope {
namespace {

Contour circle(double radius, const Point2& centre = {}, const std::string& structure = "tooth") {
  constexpr int corners = 48;
  Contour made{structure, {}};
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    made.points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return made;
}

/// A round tooth of radius 4 with slices half a millimetre apart, from z = 0 to 12; the radius of its hole at each
/// height, 0 for none.
ContourStack drilled(const std::function<double(double)>& hole) {
  ContourStack stack;
  for (int i = 0; i <= 24; ++i) {
    Slice slice{0.5 * i, {circle(4)}};
    if (const double radius = hole(slice.z); radius > 0) slice.contours.push_back(circle(radius));
    stack.slices.push_back(std::move(slice));
  }
  return stack;
}

/// Its solids' surfaces and what is in them.
struct Model {
  Reconstruction made;
  std::vector<StructureSurface> parts() const {
    std::vector<StructureSurface> all;
    for (const Solid& solid : made.solids) all.push_back({solid.structure, &solid.surface});
    return all;
  }
};
Model model_of(const ContourStack& stack) { return {reconstruct(stack)}; }

ContourStack only(ContourStack stack, double low, double high) {
  std::erase_if(stack.slices, [&](const Slice& slice) { return slice.z < low || slice.z > high; });
  return stack;
}

void expect_sound(const Cavity& cavity) {
  const SurfaceReport report = inspect(cavity.wall);
  EXPECT_TRUE(report.closed_oriented_manifold());
  ASSERT_EQ(report.shells.size(), 1u);
  EXPECT_EQ(report.shells[0].kind, Shell::Kind::cavity);
  EXPECT_GE(cavity.cap_triangles, cavity.mouths.size());
  EXPECT_FALSE(cavity.cut_from.empty());
}

TEST(OpenCanals, OfACutOffRootEndInTheLastSlicesPlane) {
  // A chamber of radius 2 from 8 to 10, closed above; a canal below, open at z = 0.
  const Model model = model_of(drilled([](double z) { return z > 10 ? 0 : z >= 8 ? 2 : 0.6; }));
  const std::vector<Cavity> cavities = cavities_in(model.parts());
  ASSERT_EQ(cavities.size(), 1u);
  const Cavity& cavity = cavities[0];
  expect_sound(cavity);
  ASSERT_EQ(cavity.mouths.size(), 1u);
  EXPECT_NEAR(cavity.mouths[0].at.z, 0, 0.02);
  EXPECT_NEAR(cavity.mouths[0].area, std::numbers::pi * 0.36, 0.02);
  // All that is not material, and not outside.
  double material = 0;
  for (const Shell& shell : model.made.solids[0].report.shells) material += shell.volume;
  const double whole = 48 * 0.5 * std::sin(2 * std::numbers::pi / 48) * 16 * 12;
  EXPECT_NEAR(cavity.volume, whole - material, 0.01 * cavity.volume);
  const Anatomy anatomy = measure_anatomy(model.parts());
  ASSERT_EQ(anatomy.canals.size(), 1u);
  EXPECT_EQ(anatomy.mouths.size(), 1u);
  EXPECT_NEAR(anatomy.canals[0].end.z, 0, 0.02);
  EXPECT_NEAR(anatomy.canals[0].length, 8, 0.5);  // the floor lies between two slices
  ASSERT_TRUE(anatomy.canals[0].narrowest);
  EXPECT_NEAR(anatomy.canals[0].narrowest->width, 1.2, 0.012);
  ASSERT_TRUE(anatomy.canals[0].thinnest_wall);
  EXPECT_NEAR(anatomy.canals[0].thinnest_wall->width, 2, 0.02);  // beside the chamber's floor
  ASSERT_EQ(anatomy.roots.size(), 1u);
  EXPECT_EQ(anatomy.roots[0].vertucci, "I");
}

TEST(OpenCanals, WithAnAccessCavityHaveAMouthAtEitherEnd) {
  const Model model = model_of(drilled([](double z) { return z >= 8 ? 1.8 : 0.6; }));
  const std::vector<Cavity> cavities = cavities_in(model.parts());
  ASSERT_EQ(cavities.size(), 1u);
  expect_sound(cavities[0]);
  ASSERT_EQ(cavities[0].mouths.size(), 2u);
  const CentreLines lines = centre_lines(cavities[0]);
  ASSERT_EQ(lines.canals.size(), 1u);
  EXPECT_NEAR(lines.canals[0].end.z, 0, 0.02);
}

TEST(OpenCanals, OfASampleMolarWithoutItsRootTipsKeepTheirNumbers) {
  ContourStack stack = only(sample_tooth(ToothKind::molar), 4, 100);
  const double cut = stack.slices.front().z;
  const Anatomy filled = measure_anatomy(model_of(stack).parts());  // its pulp is a body
  EXPECT_EQ(filled.cavity_of, "pulp");
  for (Slice& slice : stack.slices)
    std::erase_if(slice.contours, [](const Contour& contour) { return contour.structure == "pulp"; });
  const Model model = model_of(stack);
  const std::vector<Cavity> cavities = cavities_in(model.parts());
  ASSERT_EQ(cavities.size(), 1u);
  EXPECT_EQ(cavities[0].structure, "dentine");
  expect_sound(cavities[0]);
  EXPECT_EQ(cavities[0].mouths.size(), 3u);
  const Anatomy anatomy = measure_anatomy(model.parts());
  ASSERT_EQ(anatomy.canals.size(), 3u);
  EXPECT_GE(anatomy.horns, 4u);
  // What there is above the cut, by finer slices and another method.
  for (const CanalFact& fact : sample_facts(ToothKind::molar).canals) {
    const CentreLine& fine = test::ending_at(test::fine_lines(ToothKind::molar).canals, fact.axis.front());
    const double known = test::length_down_to(fine, cut);
    const Point3 end = std::find_if(fine.points.begin(), fine.points.end() - 1, [&](const CentrePoint& point) {
                         return point.at.z < cut;
                       })->at;
    const auto canal = std::min_element(
        anatomy.canals.begin(), anatomy.canals.end(),
        [&](const MeasuredCanal& a, const MeasuredCanal& b) { return length(a.end - end) < length(b.end - end); });
    EXPECT_NEAR(canal->length, known, 0.03 * known) << fact.name;
  }
  ASSERT_EQ(filled.canals.size(), 3u);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(anatomy.canals[c].end.z, cut, 0.05);
    for (const MeasuredCanal& canal : {anatomy.canals[c], filled.canals[c]}) {
      ASSERT_TRUE(canal.thinnest_wall);
      EXPECT_GT(canal.thinnest_wall->width, 0.2);
    }
  }
  EXPECT_EQ(anatomy.roots.size(), 2u);
}

TEST(OpenCanals, AreNotWhatIsShallowOrFilled) {
  // A dish, and a well in which another solid stands.
  const Model dish = model_of(drilled([](double z) { return z >= 9 ? 3 : 0; }));
  EXPECT_TRUE(cavities_in(dish.parts()).empty());
  ContourStack well = drilled([](double z) { return z >= 2 ? 1.5 : 0; });
  const Model empty = model_of(well);
  EXPECT_EQ(cavities_in(empty.parts()).size(), 1u);
  for (Slice& slice : well.slices)
    if (slice.z >= 2) slice.contours.push_back(circle(1.2, {}, "post"));
  const Model filled = model_of(well);
  EXPECT_TRUE(cavities_in(filled.parts()).empty());
}

TEST(OpenCanals, AreLeftOutWhereARealVoidIsLarger) {
  const SurfaceMesh hollow =
      shapes::together(shapes::cube(0, 0, 20, 40), shapes::inside_out(shapes::cube(5, 5, 25, 30)));
  const Model model = model_of(drilled([](double) { return 0.6; }));
  std::vector<StructureSurface> parts = model.parts();
  ASSERT_EQ(cavities_in(parts).size(), 1u);
  EXPECT_EQ(cavities_in(parts)[0].mouths.size(), 2u);
  parts.push_back({"hollow", &hollow});
  ASSERT_EQ(cavities_in(parts).size(), 1u);
  EXPECT_EQ(cavities_in(parts)[0].structure, "hollow");
}

}  // namespace
}  // namespace odontoscope
