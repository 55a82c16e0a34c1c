// No back face of a reconstructed molar is seen, from 100 places around it and from 100 within its pulp cavity; and
// flipped triangles are.

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "engine/measure/triangle_tree.h"
#include "engine/render/face_count.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/mesh/exact_predicates.h"
#include "recon/volume/iso_contours.h"
#include "recon/volume/read_volume.h"
#include "tests/render/drawing.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

constexpr int places = 100;
constexpr PixelSize size{200, 200};
/// As in culling_test.cpp, of the pixels of the outline. Within a cavity there is no outline, so there of all pixels.
constexpr double most_ties = 0.002;
/// Of the model's radius: cameras keep this far from the walls, so that none is nearer than the near plane (view_of:
/// 0.002 at 80 degrees).
constexpr double least_clearance = 0.008;

glm::dvec3 direction_of(int i) {
  const double height = 1 - (2.0 * i + 1) / places, azimuth = i * std::numbers::pi * (3 - std::sqrt(5.0)),
               level = std::sqrt(1 - height * height);
  return {level * std::cos(azimuth), level * std::sin(azimuth), height};
}

Camera outside(const Model& model, int i) {
  Camera camera;
  camera.target = model.bounds_mm.centre();
  camera.position = camera.target + 5 * model.radius_mm * direction_of(i);
  camera.projection = i % 2 == 0 ? Camera::Projection::perspective : Camera::Projection::parallel;
  camera.height_mm = 2.05 * model.radius_mm;
  camera.up = std::abs(direction_of(i).z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  return camera;
}

/// How often the shells go round the place, by exact predicates alone: nothing if the line from there to `far` touches
/// an edge.
std::optional<int> times_around(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& shell_of,
                                std::optional<std::uint32_t> shell, const Point3& place, const Point3& far) {
  int around = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (shell && shell_of[t] != *shell) continue;
    const Point3 &a = mesh.points[mesh.triangles[t][0]], &b = mesh.points[mesh.triangles[t][1]],
                 &c = mesh.points[mesh.triangles[t][2]];
    const int u = orientation(place, far, a, b), v = orientation(place, far, b, c), w = orientation(place, far, c, a);
    if (u * v < 0 || v * w < 0 || u * w < 0) continue;
    const int here = orientation(a, b, c, place), there = orientation(a, b, c, far);
    if (here * there > 0) continue;
    if (u == 0 || v == 0 || w == 0 || here == 0 || there == 0) return std::nullopt;
    around += here < 0 ? 1 : -1;  // leaves through the triangle's outside, or comes in
  }
  return around;
}

struct Molar {
  std::string name, skipped;  // why there is none
  SurfaceMesh surface;
  SurfaceReport report;
};

/// The solid that has a cavity.
Molar molar_of(const std::string& name, const ContourStack& stack) {
  for (Solid& solid : reconstruct(stack).solids)
    for (const Shell& shell : solid.report.shells)
      if (shell.kind == Shell::Kind::cavity) return {name, {}, std::move(solid.surface), std::move(solid.report)};
  return {name, "it has no cavity", {}, {}};
}

const Molar& ct_molar() {
  static const Molar molar = [] {
    const std::filesystem::path file = std::filesystem::path(ODONTOSCOPE_DATA) / "ct_molar" / "tooth.nrrd";
    if (std::string(ODONTOSCOPE_DATA).empty() || !std::filesystem::exists(file))
      return Molar{"CT", "the data set ct_molar is not here", {}, {}};
    return molar_of("CT", iso_contours(read_volume(file.string()), {{120, "tooth"}}, {.min_area = 4}).stack);
  }();
  return molar;
}

const Molar& sample_molar() {
  static const Molar molar = molar_of("Sample", small_molar_overlays().contours);
  return molar;
}

const Molar& the_molar(const std::string& name) { return name == "CT" ? ct_molar() : sample_molar(); }

/// Places in the cavity: halfway between its wall and the wall across, from triangles all over it.
std::vector<Camera> inside(const Molar& molar, const Model& model) {
  std::uint32_t cavity = 0;
  while (molar.report.shells[cavity].kind != Shell::Kind::cavity) ++cavity;  // the largest
  std::vector<std::uint32_t> walls;
  for (std::uint32_t t = 0; t < molar.report.shell_of.size(); ++t)
    if (molar.report.shell_of[t] == cavity) walls.push_back(t);
  const TriangleTree tree(model);
  std::vector<Camera> cameras;
  // A stride that has no factor in common with any number of triangles below it.
  for (std::size_t k = 0; k < walls.size() && cameras.size() < places; ++k) {
    const std::uint32_t t = walls[k * 7919 % walls.size()];
    glm::dvec3 middle(0);
    for (const PointIndex p : molar.surface.triangles[t])
      middle += metres_per_mm / 3 *
                (glm::dvec3(molar.surface.points[p].x, molar.surface.points[p].y, molar.surface.points[p].z) -
                 model.origin_mm);
    const glm::dvec3 away = tree.normal(0, t);
    if (away == glm::dvec3(0)) continue;
    const auto across =
        tree.nearest({middle, away, 1e-9}, [&](const Crossing& crossing) { return crossing.triangle != t; });
    if (!across) continue;
    const glm::dvec3 place = middle + 0.5 * across->distance * away;
    if (tree.nearest_point(place, [](std::uint32_t) { return true; })->distance <
        least_clearance * metres_per_mm * model.radius_mm)
      continue;
    Camera camera;
    camera.position = model.origin_mm + place / metres_per_mm;
    camera.target = camera.position + model.radius_mm * direction_of(static_cast<int>(cameras.size()));
    camera.up =
        std::abs(direction_of(static_cast<int>(cameras.size())).z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    camera.field_of_view_deg = 80;
    const Point3 at{camera.position.x, camera.position.y, camera.position.z};
    const Point3 far{at.x + 977.3, at.y + 313.7, at.z + 4091.9};
    const auto in_cavity = times_around(molar.surface, molar.report.shell_of, cavity, at, far);
    const auto in_all = times_around(molar.surface, molar.report.shell_of, std::nullopt, at, far);
    if (in_cavity == -1 && in_all == 0) cameras.push_back(camera);
  }
  return cameras;
}

class MolarCulling : public DrawingTest, public ::testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    if (!the_molar(GetParam()).skipped.empty()) GTEST_SKIP() << the_molar(GetParam()).skipped;
    DrawingTest::SetUp();
  }
  const Molar& molar() const { return the_molar(GetParam()); }

  std::vector<Camera> all_around(const Model& model) {
    std::vector<Camera> cameras;
    for (int i = 0; i < places; ++i) cameras.push_back(outside(model, i));
    return cameras;
  }

  /// The sum over the cameras, or up to the first that sees something wrong.
  FaceVerdict seen(const Model& model, const std::vector<Camera>& cameras, bool until_wrong = false) {
    context().make_current();
    const FaceCounter counter(gl(), ShaderLibrary{});
    const GpuModel gpu_model = upload(gl(), model);
    FaceVerdict all;
    for (const Camera& camera : cameras) {
      const FaceVerdict one = judge(counter.count(gpu_model, usual_scene(model, 1), view_of(camera, model, 1), size));
      all.covered += one.covered;
      all.outline += one.outline;
      all.unbalanced += one.unbalanced;
      all.back_nearest += one.back_nearest;
      all.ties += one.ties;
      if (until_wrong && all.unbalanced > 0) break;
    }
    return all;
  }

  /// Every `every`th triangle turned round, or one if there are fewer.
  Model flipped(std::size_t every) {
    SurfaceMesh wrong = molar().surface;
    for (std::size_t t = std::min(every / 2, wrong.triangles.size() / 2); t < wrong.triangles.size(); t += every)
      std::swap(wrong.triangles[t][1], wrong.triangles[t][2]);
    return make_model({{"tooth", wrong}});
  }
};

TEST_P(MolarCulling, NoBackFaceIsSeenFromOutside) {
  const Model model = make_model({{"tooth", molar().surface}});
  const FaceVerdict all = seen(model, all_around(model));
  RecordProperty("ties", std::to_string(all.ties));
  EXPECT_GT(all.covered, 200'000u);
  EXPECT_EQ(all.unbalanced, 0u);
  EXPECT_EQ(all.back_nearest, all.ties) << "back faces in front that are no ties";
  EXPECT_LE(double(all.ties), most_ties * double(all.outline));
}

TEST_P(MolarCulling, NoBackFaceIsSeenFromInsideThePulpCavity) {
  const Model model = make_model({{"tooth", molar().surface}});
  const std::vector<Camera> cameras = inside(molar(), model);
  ASSERT_EQ(cameras.size(), std::size_t(places)) << "places proven to lie in the cavity";
  const FaceVerdict all = seen(model, cameras);
  RecordProperty("ties", std::to_string(all.ties));
  EXPECT_EQ(all.covered, std::size_t(places) * size.width * size.height)
      << "a closed room: no line of sight leaves it unmet";
  EXPECT_EQ(all.unbalanced, 0u);
  EXPECT_EQ(all.back_nearest, all.ties) << "back faces in front that are no ties";
  EXPECT_LE(double(all.ties), most_ties * double(all.covered));
}

TEST_P(MolarCulling, FlippedTrianglesAreCountedFromOutside) {
  const std::vector<Camera> all = all_around(make_model({{"tooth", molar().surface}}));
  const std::vector<Camera> few(all.begin(), all.begin() + 5);
  const FaceVerdict hundredth = seen(flipped(100), few), thousandth = seen(flipped(1000), few);
  EXPECT_GT(thousandth.unbalanced, 0u);
  EXPECT_GT(hundredth.unbalanced, 3 * thousandth.unbalanced);
  const FaceVerdict one = seen(flipped(molar().surface.triangles.size()), all, true);
  EXPECT_GT(one.unbalanced, 0u) << "one single triangle";
}

TEST_P(MolarCulling, FlippedTrianglesAreCountedFromInside) {
  const std::vector<Camera> cameras = inside(molar(), make_model({{"tooth", molar().surface}}));
  ASSERT_FALSE(cameras.empty());
  const std::vector<Camera> few(cameras.begin(), cameras.begin() + 5);
  const FaceVerdict hundredth = seen(flipped(100), few), thousandth = seen(flipped(1000), few);
  EXPECT_GT(thousandth.unbalanced, 0u);
  EXPECT_GT(hundredth.unbalanced, 3 * thousandth.unbalanced);
  EXPECT_GT(hundredth.back_nearest, hundredth.ties);
  EXPECT_GT(seen(flipped(molar().surface.triangles.size()), cameras, true).unbalanced, 0u) << "one single triangle";
}

INSTANTIATE_TEST_SUITE_P(Of, MolarCulling, ::testing::Values("CT", "Sample"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace odontoscope::testing_support
