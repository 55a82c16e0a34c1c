// Scenes as values and files; cameras; normals; the way from millimetres to metres.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "engine/scene/normals.h"
#include "engine/scene/scene_json.h"
#include "recon/core/error.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

std::string cause_of(const std::string& text) {
  try {
    scene_from_json(text, Scene{}, "a.json");
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("a.json"), std::string::npos) << error.what();
    return error.cause();
  }
  return "none";
}

std::string with(const std::string& members) { return R"({"format":"odontoscope.scene","version":1,)" + members + "}"; }

TEST(SceneFiles, ComeBackAsTheyWere) {
  Scene scene = usual_scene(hollow_ball_model(), 1.5);
  scene.section = Section{{1, 2, 3}, {0.5, -1, 0.25}};
  scene.back_faces = BackFaces::tint;
  scene.wire = true;
  scene.camera.projection = Camera::Projection::parallel;
  scene.background = {Background::Kind::transparent, {}, {}};
  scene.occlusion = {false, 2, 0.3f};
  scene.wall_depth = scene.wall_thickness = true;
  scene.looks[0] = {"shell", colour_from_hex("#123456"), 0.7f, false, true};
  scene.looks[1].colour = colour_from_hex("#fedcba");
  scene.cap = {CapLook::Shows::ct, ValueWindow{-1000, 2500.5}};
  scene.headlight = Headlight{1.25};
  scene.camera.near_mm = 0.0125;
  EXPECT_EQ(scene_from_json(to_json(scene), Scene{}), scene);
  EXPECT_EQ(to_json(scene_from_json(to_json(scene), Scene{})), to_json(scene));
}

TEST(SceneFiles, KnowWhatACapShows) {
  for (const CapLook::Shows shows : {CapLook::Shows::material, CapLook::Shows::plain, CapLook::Shows::ct}) {
    Scene scene;
    scene.cap.shows = shows;
    EXPECT_EQ(scene_from_json(to_json(scene), Scene{}).cap.shows, shows);
  }
}

TEST(SceneFiles, ChangeOnlyWhatTheySay) {
  Scene start = usual_scene(hollow_ball_model(), 1);
  start.wire = true;
  const Scene scene = scene_from_json(with(R"("structures":[{"name":"shell","opacity":0.5}])"), start);
  EXPECT_EQ(scene.look_of("shell")->opacity, 0.5f);
  EXPECT_EQ(scene.look_of("shell")->colour, start.look_of("shell")->colour);
  EXPECT_EQ(scene.camera, start.camera);
  EXPECT_TRUE(scene.wire);
}

TEST(SceneFiles, ThatMakeNoSenseAreRefused) {
  EXPECT_EQ(cause_of("{"), "unparsable");
  EXPECT_EQ(cause_of("[]"), "wrong-format");
  EXPECT_EQ(cause_of(R"({"format":"odontoscope.stack","version":1})"), "wrong-format");
  EXPECT_EQ(cause_of(R"({"format":"odontoscope.scene","version":2})"), "wrong-version");
  EXPECT_EQ(cause_of(with(R"("camera":5)")), "wrong-type");
  EXPECT_EQ(cause_of(with(R"("camera":{"position":[1,2]})")), "wrong-type");
  EXPECT_EQ(cause_of(with(R"("camera":{"position":[1,2,"3"]})")), "wrong-type");
  EXPECT_EQ(cause_of(with(R"("camera":{"position":[0,0,0],"target":[0,0,0]})")), "bad-camera");
  EXPECT_EQ(cause_of(with(R"("camera":{"position":[0,0,9],"target":[0,0,0],"up":[0,0,-2]})")), "bad-camera");
  EXPECT_EQ(cause_of(with(R"("camera":{"field_of_view_deg":180})")), "bad-camera");
  EXPECT_EQ(cause_of(with(R"("camera":{"height_mm":0})")), "bad-camera");
  EXPECT_EQ(cause_of(with(R"("camera":{"near_mm":-1})")), "bad-camera");
  EXPECT_EQ(cause_of(with(R"("camera":{"projection":"fisheye"})")), "bad-value");
  EXPECT_EQ(cause_of(with(R"("headlight":{"reach_mm":0})")), "bad-value");
  EXPECT_EQ(cause_of(with(R"("headlight":{"reach_mm":1e300})")), "bad-value");
  EXPECT_EQ(cause_of(with(R"("headlight":true)")), "wrong-type");
  EXPECT_EQ(cause_of(with(R"("structures":[{"opacity":0.5}])")), "bad-value");
  EXPECT_EQ(cause_of(with(R"("structures":[{"name":"a","opacity":1.5}])")), "bad-value");
  EXPECT_EQ(cause_of(with(R"("structures":[{"name":"a","colour":"red"}])")), "bad-value");
  EXPECT_EQ(cause_of(with(R"("section":{"normal":[0,0,0]})")), "bad-value");
  EXPECT_EQ(cause_of(with(R"("cap":{"shows":"x-rays"})")), "bad-value");
  EXPECT_EQ(cause_of(with(R"("cap":{"window":[5,5]})")), "bad-value");
  EXPECT_EQ(cause_of(with(R"("cap":{"window":[1e300,2e300]})")), "bad-value");
  EXPECT_EQ(cause_of(with(R"("cap":{"window":[5]})")), "wrong-type");
  EXPECT_EQ(cause_of(with(R"("cap":{"window":"wide"})")), "wrong-type");
  EXPECT_EQ(cause_of(with(R"("wire":1)")), "wrong-type");
  EXPECT_EQ(cause_of(with(R"("back_faces":"sometimes")")), "bad-value");
  EXPECT_EQ(cause_of(with(R"("camera":{"position":[1e999,0,0]})")), "not-finite");
  EXPECT_EQ(cause_of(std::string(100'000, '[')), "wrong-format");
  EXPECT_EQ(cause_of(with(R"("note":)" + std::string(100'000, '['))), "too-deep");
}

class NamedViews : public ::testing::TestWithParam<NamedView> {};

TEST_P(NamedViews, HoldTheWholeModelAndNearlyFillThePicture) {
  for (const double aspect : {0.5, 1.0, 16.0 / 9}) {
    for (const auto projection : {Camera::Projection::perspective, Camera::Projection::parallel}) {
      const Model model = make_model({{"box", box({100, -3, 20}, {109, 4, 42})}});
      const View view = view_of(fit(GetParam(), model, aspect, projection), model, aspect);
      double furthest = 0;
      for (const glm::vec3& position : model.parts[0].positions) {
        const glm::vec4 clip = view.eye_to_clip * view.world_to_eye * glm::vec4(position, 1);
        for (int axis = 0; axis < 3; ++axis) EXPECT_LE(std::abs(clip[axis]), clip.w) << axis;
        furthest = std::max({furthest, std::abs(double{clip.x / clip.w}), std::abs(double{clip.y / clip.w})});
      }
      EXPECT_GT(furthest, 0.9);
      EXPECT_LT(furthest, 1);
    }
  }
}

TEST_P(NamedViews, HaveNamesThatReadBack) { EXPECT_EQ(view_named(name(GetParam())), GetParam()); }

INSTANTIATE_TEST_SUITE_P(Each, NamedViews,
                         ::testing::Values(NamedView::three_quarter, NamedView::buccal, NamedView::lingual,
                                           NamedView::mesial, NamedView::distal, NamedView::occlusal,
                                           NamedView::apical));

TEST(Views, LookFromTheSideThatTheyName) {
  const Model model = make_model({{"box", box({-1, -1, -1}, {1, 1, 1})}});
  EXPECT_GT(fit(NamedView::buccal, model, 1).position.y, 5);
  EXPECT_LT(fit(NamedView::lingual, model, 1).position.y, -5);
  EXPECT_GT(fit(NamedView::mesial, model, 1).position.x, 5);
  EXPECT_LT(fit(NamedView::distal, model, 1).position.x, -5);
  EXPECT_GT(fit(NamedView::occlusal, model, 1).position.z, 5);
  EXPECT_LT(fit(NamedView::apical, model, 1).position.z, -5);
  EXPECT_THROW(view_named("sideways"), UsageError);
}

TEST(Models, AreInMetresAroundTheirOwnOrigin) {
  const Model model = make_model({{"box", box({100'000, 2, 3}, {100'002, 4, 5})}});
  EXPECT_EQ(model.origin_mm, glm::dvec3(100'001, 3, 4));
  for (const glm::vec3& position : model.parts[0].positions)
    for (int axis = 0; axis < 3; ++axis) EXPECT_FLOAT_EQ(std::abs(position[axis]), 0.001f);
}

TEST(Models, WithoutATriangleAreRefused) { EXPECT_THROW(make_model({{"nothing", {}}}), InputError); }

TEST(Normals, OfABoxAreSharpAndOfABallSmooth) {
  const Model cube = make_model({{"box", box({0, 0, 0}, {1, 1, 1})}});
  EXPECT_EQ(cube.parts[0].positions.size(), 24u) << "each corner once for each of its three sides";
  const SurfaceMesh mesh = ball({{}, 5, 32});
  const Model smooth = make_model({{"ball", mesh}});
  EXPECT_EQ(smooth.parts[0].positions.size(), mesh.points.size());
  for (std::size_t i = 0; i < smooth.parts[0].positions.size(); ++i)
    EXPECT_GT(glm::dot(smooth.parts[0].normals[i], glm::normalize(smooth.parts[0].positions[i])), 0.995f);
}

TEST(Normals, AreUnitLengthEvenWhereATriangleHasNoArea) {
  SurfaceMesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.triangles.push_back({0, 0, 1});
  for (const glm::vec3& normal : corner_normals(mesh, default_crease_deg)) EXPECT_NEAR(glm::length(normal), 1, 1e-6);
}

TEST(Colours, ReadBackAndRefuse) {
  for (const char* text : {"#000000", "#ffffff", "#12ab9f"}) EXPECT_EQ(hex(colour_from_hex(text)), text);
  for (const char* text : {"", "#", "#12345", "#1234567", "123456", "#12345g", "#-12345"})
    EXPECT_THROW(colour_from_hex(text), UsageError) << text;
}

TEST(UsualScenes, AreTheSameFromAFile) {
  const Scene scene = usual_scene(small_molar(), 1);
  EXPECT_EQ(scene_from_json(to_json(scene), Scene{}), scene);
}

TEST(UsualScenes, ShowWhatIsInside) {
  const Scene scene = usual_scene(small_molar(), 1);
  EXPECT_LT(scene.look_of("enamel")->opacity, 1);
  EXPECT_LT(scene.look_of("dentine")->opacity, 1);
  EXPECT_EQ(scene.look_of("pulp")->opacity, 1);
  EXPECT_TRUE(usual_scene(hollow_ball_model(), 1).look_of("shell cavity")->as_body);
}

TEST(UsualScenes, ACavityIsFilledByWhatEndsALittleLater) {
  // Where both end between slices each ends by its own course: of the pulp and the dentine's void a few hundredths of a
  // millimetre lay between.
  for (const double radius : {1.9, 2.04, 2.3}) {
    const Model model = make_model({{"shell", ball({{0, 0, 0}, 5}), "shell"},
                                    {"shell cavity", reversed(ball({{0, 0, 0}, 2})), "shell", true},
                                    {"core", ball({{0, 0, 0}, radius}), "core"}});
    EXPECT_EQ(usual_scene(model, 1).look_of("shell cavity")->as_body, radius > 2.1) << radius;
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
