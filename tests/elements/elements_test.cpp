// Elements for simulation: one mesh of all materials that fills just what they filled, of decent shape.

#include "recon/elements/elements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "recon/core/error.h"
#include "recon/elements/fill.h"
#include "recon/mesh/complex_parts.h"
#include "recon/output/element_model.h"
#include "recon/partition/reconstruct_partition.h"
#include "recon/sample/sample_tooth.h"
#include "tests/partition/named_shapes.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {
namespace {

// --- an independent look at the result -------------------------------------------------------------------------------

using Face = std::array<PointIndex, 3>;

Face sorted(Face face) {
  std::sort(face.begin(), face.end());
  return face;
}

std::array<double, 3> between(const Point3& from, const Point3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

/// Six times the volume.
double six_volumes(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const auto u = between(a, b), v = between(a, c), w = between(a, d);
  return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/// Faces are shared by two, and those between two labels are listed once with just these labels.
void expect_one_mesh(const LabelledComplex& made) {
  std::map<Face, std::vector<Label>> sides;
  for (std::size_t t = 0; t < made.mesh.tetrahedra.size(); ++t) {
    const Tetrahedron& tet = made.mesh.tetrahedra[t];
    const auto& p = made.mesh.points;
    ASSERT_GT(six_volumes(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]), 0) << t;
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      Face face;
      for (std::size_t i = 0, n = 0; i < 4; ++i)
        if (i != left_out) face[n++] = tet[i];
      sides[sorted(face)].push_back(made.mesh.labels[t]);
    }
  }
  std::set<Face> listed;
  for (const InterfaceTriangle& face : made.interfaces) {
    ASSERT_TRUE(listed.insert(sorted(face.triangle)).second) << "a face is listed twice";
    std::vector<Label> wanted{face.inner};
    if (face.outer != void_label) wanted.push_back(face.outer);
    std::vector<Label> found = sides[sorted(face.triangle)];
    std::sort(found.begin(), found.end());
    std::sort(wanted.begin(), wanted.end());
    ASSERT_EQ(found, wanted);
  }
  for (const auto& [face, labels] : sides) {
    ASSERT_LE(labels.size(), 2u);
    const bool border = labels.size() == 1 || labels[0] != labels[1];
    ASSERT_EQ(border, listed.contains(face));
  }
}

/// By counting the faces that a ray upwards crosses. The ray is taken where no vertex lies.
bool inside(const SurfaceMesh& surface, const Point3& from) {
  bool in = false;
  for (const Triangle& t : surface.triangles) {
    const Point3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    const auto side = [&](const Point3& p, const Point3& q) {
      return (q.x - p.x) * (from.y - p.y) - (q.y - p.y) * (from.x - p.x);
    };
    const double ab = side(a, b), bc = side(b, c), ca = side(c, a);
    if (!((ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0))) continue;
    if ((bc * a.z + ca * b.z + ab * c.z) / (ab + bc + ca) > from.z) in = !in;
  }
  return in;
}

/// Places taken at random lie in one element of the material that they lay in before, or none, but for those near its
/// surface.
void expect_same_places(const LabelledComplex& made, const LabelledComplex& exact, double near) {
  std::vector<SurfaceMesh> was;
  for (Label l = 1; l <= exact.structures.size(); ++l) was.push_back(surface_of(exact, l));
  Point3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
  for (const Point3& p : exact.mesh.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  std::mt19937 random(7);
  const auto any = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
  };
  std::size_t differing = 0;
  constexpr std::size_t places = 120;
  for (std::size_t n = 0; n < places; ++n) {
    const Point3 at{any(low.x, high.x), any(low.y, high.y), any(low.z, high.z)};
    std::vector<Label> held;
    for (std::size_t t = 0; t < made.mesh.tetrahedra.size(); ++t) {
      const auto& [a, b, c, d] = made.mesh.tetrahedra[t];
      const auto& p = made.mesh.points;
      if (six_volumes(at, p[b], p[c], p[d]) > 0 && six_volumes(p[a], at, p[c], p[d]) > 0 &&
          six_volumes(p[a], p[b], at, p[d]) > 0 && six_volumes(p[a], p[b], p[c], at) > 0)
        held.push_back(made.mesh.labels[t]);
    }
    ASSERT_LE(held.size(), 1u) << "elements overlap";
    Label before = void_label;
    for (Label l = 1; l <= was.size(); ++l)
      if (inside(was[l - 1], at)) before = l;
    if (before == (held.empty() ? void_label : held[0])) continue;
    ++differing;
    double least = 1e9;
    for (const SurfaceMesh& surface : was)
      if (const auto off = distance_to_surface({at}, surface)) least = std::min(least, off->largest);
    EXPECT_LE(least, near) << "a place is in another material";
  }
  EXPECT_LT(differing, places / 10);
}

std::vector<std::pair<int, long>> shells(const SurfaceMesh& surface) {
  std::vector<std::pair<int, long>> found;
  for (const Shell& shell : inspect(surface).shells) found.emplace_back(static_cast<int>(shell.kind), shell.genus);
  std::sort(found.begin(), found.end());
  return found;
}

void expect_good(const elements::Elements& made, const LabelledComplex& exact) {
  expect_one_mesh(made.complex);
  ASSERT_FALSE(::testing::Test::HasFatalFailure());
  for (Label l = 0; l <= exact.structures.size(); ++l)
    EXPECT_EQ(shells(surface_of(made.complex, l)), shells(surface_of(exact, l))) << l;
  for (const elements::MaterialElements& one : made.materials) {
    EXPECT_NEAR(one.shape.volume, one.exact_volume, 0.025 * one.exact_volume) << one.structure;
    EXPECT_LT(one.distance.largest(), 0.35 * made.size) << one.structure;
  }
}

LabelledComplex partition_of(const ContourStack& stack) { return *reconstruct_partition(stack).complex; }

class Elements : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!elements::can_fill()) GTEST_SKIP() << "built without TetGen (libtet1.5-dev)";
  }
};

// --- teeth -----------------------------------------------------------------------------------------------------------

TEST_F(Elements, OfTheIncisorFillWhatItFills) {
  const LabelledComplex exact = partition_of(
      sample_tooth(ToothKind::incisor, {.slice_spacing = 0.35, .point_spacing = 0.8, .walls = SampleWalls::filled}));
  const elements::Elements made = elements::make_elements(exact, 1.5);
  expect_good(made, exact);
  expect_same_places(made.complex, exact, 0.35);
  EXPECT_EQ(made.size, 1.5);
  ASSERT_EQ(made.materials.size(), 3u);
  for (const elements::MaterialElements& one : made.materials) {
    EXPECT_NEAR(one.shape.volume, one.exact_volume, 0.01 * one.exact_volume) << one.structure;
    EXPECT_GT(one.shape.smallest_dihedral_deg.min, 2) << one.structure;
    EXPECT_LT(one.shape.largest_dihedral_deg.max, 177) << one.structure;
    EXPECT_GT(one.shape.radius_ratio.median, 0.6) << one.structure;
  }
}

TEST_F(Elements, ComeFinerIfAskedFor) {
  const LabelledComplex exact = partition_of(canal_through_the_apex());
  const elements::Elements coarse = elements::make_elements(exact, 1.0), fine = elements::make_elements(exact, 0.3);
  EXPECT_GT(fine.complex.mesh.tetrahedra.size(), 2 * coarse.complex.mesh.tetrahedra.size());
  EXPECT_LT(fine.materials[0].distance.mean(), coarse.materials[0].distance.mean());
}

TEST_F(Elements, AreTheSameEachTime) {
  const LabelledComplex exact = partition_of(canal_through_the_apex());
  const LabelledComplex one = elements::make_elements(exact, 0.4).complex,
                        two = elements::make_elements(exact, 0.4).complex;
  EXPECT_EQ(one.mesh.points, two.mesh.points);
  EXPECT_EQ(one.mesh.tetrahedra, two.mesh.tetrahedra);
  EXPECT_EQ(one.mesh.labels, two.mesh.labels);
}

// --- awkward shapes --------------------------------------------------------------------------------------------------

struct Shape {
  const char* name;
  ContourStack (*stack)();
  double size;
};

class ElementsOf : public ::testing::TestWithParam<Shape> {};

TEST_P(ElementsOf, KeepTheShape) {
  if (!elements::can_fill()) GTEST_SKIP() << "built without TetGen (libtet1.5-dev)";
  const LabelledComplex exact = partition_of(GetParam().stack());
  const elements::Elements made = elements::make_elements(exact, GetParam().size);
  EXPECT_EQ(made.size, GetParam().size);
  expect_good(made, exact);
  expect_same_places(made.complex, exact, 0.35 * made.size);
}

INSTANTIATE_TEST_SUITE_P(Shapes, ElementsOf,
                         ::testing::Values(Shape{"DriftingLine", three_in_a_drifting_line, 0.8},
                                           Shape{"OneBetweenTwo", one_between_two_in_one_slice, 0.8},
                                           Shape{"ThinShell", thin_shell_that_drifts, 1.0},
                                           Shape{"Checkerboard", checkerboard_corner, 0.4},
                                           Shape{"CanalThroughApex", canal_through_the_apex, 0.3},
                                           Shape{"Tube", annulus_over_shifted_annulus, 0.5},
                                           Shape{"Cup", annulus_over_disc, 0.5},
                                           Shape{"Crosswise", two_over_two_crosswise, 1.0}),
                         [](const auto& shape) { return shape.param.name; });

// --- ends, and structures by themselves ------------------------------------------------------------------------------

double flat_area(const LabelledComplex& complex, double z) {
  double sum = 0;
  for (const InterfaceTriangle& face : complex.interfaces) {
    const auto& p = complex.mesh.points;
    const Point3 &a = p[face.triangle[0]], &b = p[face.triangle[1]], &c = p[face.triangle[2]];
    if (a.z == z && b.z == z && c.z == z) sum += std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  }
  return sum;
}

TEST_F(Elements, KeepFlatEndsWhereTheyAre) {
  const LabelledComplex exact = partition_of(canal_through_the_apex());
  const LabelledComplex made = elements::make_elements(exact, 0.5).complex;
  double low = 1e9, high = -1e9;
  for (const Point3& p : exact.mesh.points) low = std::min(low, p.z), high = std::max(high, p.z);
  for (const double z : {low, high}) {
    ASSERT_GT(flat_area(exact, z), 0);
    EXPECT_NEAR(flat_area(made, z), flat_area(exact, z), 0.05 * flat_area(exact, z)) << z;
  }
}

TEST_F(Elements, OfStructuresByThemselves) {
  Reconstruction model = reconstruct(annulus_over_shifted_annulus());
  ASSERT_FALSE(model.complex.has_value());
  const std::vector<Solid> before = model.solids;
  const ModelElements done = mesh_elements(model, 0.4);
  ASSERT_EQ(model.solids.size(), before.size());
  ASSERT_EQ(done.materials.size(), before.size());
  for (std::size_t s = 0; s < before.size(); ++s) {
    EXPECT_EQ(shells(model.solids[s].surface), shells(before[s].surface));
    EXPECT_TRUE(model.solids[s].report.closed_oriented_manifold());
    EXPECT_EQ(inspect(model.solids[s].tetrahedra).non_positive, 0u);
    EXPECT_GT(inspect(model.solids[s].tetrahedra).smallest_dihedral_deg.min, 2);
  }
}

TEST_F(Elements, SuggestedSizeIsSensible) {
  const LabelledComplex exact = partition_of(canal_through_the_apex());
  const double size = elements::suggested_size(exact);
  EXPECT_GT(size, 0);
  const elements::Elements made = elements::make_elements(exact, size);
  EXPECT_GT(made.complex.mesh.tetrahedra.size(), 500u);
  EXPECT_LT(made.complex.mesh.tetrahedra.size(), 500'000u);
}

TEST_F(Elements, CanBeCancelled) {
  const LabelledComplex exact = partition_of(canal_through_the_apex());
  std::stop_source stop;
  stop.request_stop();
  Progress progress;
  progress.stop = stop.get_token();
  EXPECT_THROW(elements::make_elements(exact, 0.3, progress), Cancelled);
}

}  // namespace
}  // namespace odontoscope::test
