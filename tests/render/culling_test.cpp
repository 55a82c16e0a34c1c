// Culling proven by pixels (see engine/render/face_count.h), and that one wrong triangle does not escape.

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/render/face_count.h"
#include "tests/render/drawing.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

constexpr int cameras = 100;
constexpr PixelSize size{320, 320};
/// Of the pixels of the outline, since ties lie where fronts turn into backs. Measured: up to 0.0009 (a tooth with its
/// thin canals); one triangle that is wrong breaks the balance as well, and that has no tolerance.
constexpr double most_ties = 0.002;

/// Evenly over the sphere (golden angle), alternately perspective and parallel, none along an axis.
Camera camera_around(const Model& model, int i) {
  const double height = 1 - (2.0 * i + 1) / cameras, azimuth = i * std::numbers::pi * (3 - std::sqrt(5.0));
  const double level = std::sqrt(1 - height * height);
  const glm::dvec3 direction{level * std::cos(azimuth), level * std::sin(azimuth), height};
  Camera camera;
  camera.target = model.bounds_mm.centre();
  camera.position = camera.target + 5 * model.radius_mm * direction;
  camera.projection = i % 2 == 0 ? Camera::Projection::perspective : Camera::Projection::parallel;
  camera.height_mm = 2.05 * model.radius_mm;
  camera.up = std::abs(height) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  return camera;
}

class Culling : public DrawingTest {
 protected:
  FaceVerdict from(const Model& model, const Camera& camera) {
    context().make_current();
    const FaceCounter counter(gl(), ShaderLibrary{});
    const GpuModel gpu_model = upload(gl(), model);
    return judge(counter.count(gpu_model, usual_scene(model, 1), view_of(camera, model, 1), size));
  }

  FaceVerdict from_everywhere(const Model& model) {
    context().make_current();
    const FaceCounter counter(gl(), ShaderLibrary{});
    const GpuModel gpu_model = upload(gl(), model);
    FaceVerdict all;
    for (int i = 0; i < cameras; ++i) {
      const View view = view_of(camera_around(model, i), model, 1);
      const FaceVerdict one = judge(counter.count(gpu_model, usual_scene(model, 1), view, size));
      all.covered += one.covered;
      all.outline += one.outline;
      all.unbalanced += one.unbalanced;
      all.back_nearest += one.back_nearest;
      all.ties += one.ties;
    }
    RecordProperty("covered", std::to_string(all.covered));
    RecordProperty("outline", std::to_string(all.outline));
    RecordProperty("ties", std::to_string(all.ties));
    return all;
  }

  void expect_sound(const Model& model) {
    const FaceVerdict all = from_everywhere(model);
    EXPECT_GT(all.covered, 100'000u) << "nothing was drawn";
    EXPECT_EQ(all.unbalanced, 0u);
    EXPECT_EQ(all.back_nearest, all.ties) << "back faces in front that are no ties";
    EXPECT_LE(static_cast<double>(all.ties), most_ties * static_cast<double>(all.outline));
  }
};

Model alone(const SurfaceMesh& mesh) { return make_model({{"one", mesh}}); }

TEST_F(Culling, NoBackFaceOfABallIsSeen) { expect_sound(alone(ball({{3, -2, 7}, 5}))); }
TEST_F(Culling, NoBackFaceOfARingIsSeen) { expect_sound(alone(ring({}))); }
TEST_F(Culling, NoBackFaceOfABoxIsSeen) { expect_sound(alone(box({-3, -2, -1}, {3, 2, 1}))); }
TEST_F(Culling, NoBackFaceOfAHollowBallIsSeen) { expect_sound(hollow_ball_model()); }
TEST_F(Culling, NoBackFaceFarFromTheOriginIsSeen) { expect_sound(alone(ball({{-90'000, 500'000, 250'000}, 5}))); }

TEST_F(Culling, NoBackFaceOfTheReconstructedMolarIsSeen) {
  for (const NamedSurface& surface : small_molar_surfaces()) {
    SCOPED_TRACE(surface.structure);
    expect_sound(make_model({surface}));
  }
}

TEST_F(Culling, FromInsideACavityOnlyFrontsAreNearest) {
  const Model model = hollow_ball_model();
  for (int i = 0; i < cameras; ++i) {
    Camera camera = camera_around(model, i);
    camera.projection = Camera::Projection::perspective;
    camera.position = 0.3 * (camera.position - camera.target) / model.radius_mm;  // up to 1.5 mm from the middle of 2
    camera.target = {0.1, 0.2, 0.3};
    camera.field_of_view_deg = 80;
    const FaceVerdict verdict = from(model, camera);
    EXPECT_EQ(verdict.covered, static_cast<std::size_t>(size.width * size.height));
    EXPECT_EQ(verdict.unbalanced, 0u);
    EXPECT_EQ(verdict.back_nearest, verdict.ties);
  }
}

TEST_F(Culling, EverySingleFlippedTriangleOfACoarseBallIsFound) {
  const SurfaceMesh sound = coarse_ball(5);
  for (std::size_t t = 0; t < sound.triangles.size(); t += 7) {
    SurfaceMesh wrong = sound;
    std::swap(wrong.triangles[t][1], wrong.triangles[t][2]);
    const FaceVerdict verdict = from_everywhere(alone(wrong));
    EXPECT_GT(verdict.unbalanced, 0u) << t;
    EXPECT_GT(verdict.back_nearest, verdict.ties) << t;
  }
}

/// The pulp by itself: one shell, so that each triangle is seen from somewhere outside.
NamedSurface pulp() {
  for (const NamedSurface& surface : small_molar_surfaces())
    if (surface.structure == "pulp") return surface;
  return {};
}

TEST_F(Culling, OneFlippedOrMissingTriangleOfThePulpIsFound) {
  NamedSurface surface = pulp();
  const std::size_t middle = surface.surface.triangles.size() / 2;
  std::swap(surface.surface.triangles[middle][1], surface.surface.triangles[middle][2]);
  const FaceVerdict flipped = from_everywhere(make_model({surface}));
  EXPECT_GT(flipped.unbalanced, 0u);
  EXPECT_GT(flipped.back_nearest, flipped.ties);
  surface = pulp();
  surface.surface.triangles.erase(surface.surface.triangles.begin() + static_cast<std::ptrdiff_t>(middle));
  EXPECT_GT(from_everywhere(make_model({surface})).unbalanced, 0u);
}

TEST_F(Culling, MoreFlippedTrianglesCountMore) {
  const SurfaceMesh sound = ball({{}, 5, 40});
  std::size_t before = 0;
  for (const std::size_t every : {std::size_t{1000}, std::size_t{100}, std::size_t{10}}) {  // 0.1 %, 1 %, 10 %
    SurfaceMesh wrong = sound;
    for (std::size_t t = every / 2; t < wrong.triangles.size(); t += every)
      std::swap(wrong.triangles[t][1], wrong.triangles[t][2]);
    const FaceVerdict verdict = from_everywhere(alone(wrong));
    EXPECT_GT(verdict.unbalanced, 2 * before);
    before = verdict.unbalanced;
  }
}

TEST_F(Culling, ASurfaceInsideOutIsAllBackFaces) {
  const FaceVerdict verdict = from_everywhere(alone(reversed(ball({{}, 5}))));
  EXPECT_GT(static_cast<double>(verdict.back_nearest), 0.99 * static_cast<double>(verdict.covered));
  EXPECT_LT(static_cast<double>(verdict.ties), 0.05 * static_cast<double>(verdict.covered));
}

}  // namespace
}  // namespace odontoscope::testing_support
