// Things that must not go unnoticed: each makes at least one golden fail.

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/picture/png.h"
#include "tests/render/drawing.h"
#include "tests/render/golden.h"

namespace odontoscope::testing_support {
namespace {

/// The triangle nearest to the eye, as (surface, triangle).
std::pair<std::size_t, std::size_t> nearest_triangle(const std::vector<NamedSurface>& surfaces, const Scene& scene) {
  std::pair<std::size_t, std::size_t> nearest;
  double least = std::numeric_limits<double>::max();
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const SurfaceMesh& mesh = surfaces[s].surface;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      glm::dvec3 centre(0);
      for (const PointIndex p : mesh.triangles[t])
        centre += glm::dvec3(mesh.points[p].x, mesh.points[p].y, mesh.points[p].z) / 3.0;
      const double distance = glm::distance(centre, scene.camera.position);
      if (distance < least) least = distance, nearest = {s, t};
    }
  }
  return nearest;
}

struct NamedMutation {
  const char* name;
  Mutation mutation;
};

Mutation of_surfaces(std::function<void(std::vector<NamedSurface>&, const Scene&)> change) {
  return {std::move(change), {}, {}, {}};
}
Mutation of_model(std::function<void(Model&)> change) { return {{}, std::move(change), {}, {}}; }
Mutation of_scene(std::function<void(Scene&)> change) { return {{}, {}, std::move(change), {}}; }
Mutation of_shader(std::string shader, std::string from, std::string to) {
  return {{}, {}, {}, {{std::move(shader), std::move(from), std::move(to)}}};
}

std::vector<NamedMutation> mutations() {
  return {
      {"DroppedTriangle", of_surfaces([](auto& surfaces, const Scene& scene) {
         const auto [s, t] = nearest_triangle(surfaces, scene);
         surfaces[s].surface.triangles.erase(surfaces[s].surface.triangles.begin() + static_cast<std::ptrdiff_t>(t));
       })},
      {"FlippedTriangle", of_surfaces([](auto& surfaces, const Scene& scene) {
         const auto [s, t] = nearest_triangle(surfaces, scene);
         std::swap(surfaces[s].surface.triangles[t][0], surfaces[s].surface.triangles[t][1]);
       })},
      {"CullingOff", of_scene([](Scene& scene) { scene.back_faces = BackFaces::show; })},
      {"NormalsNegated", of_model([](Model& model) {
         for (ModelPart& part : model.parts)
           for (glm::vec3& normal : part.normals) normal = -normal;
       })},
      {"FlatNormals", of_shader("surface.frag", "normalize(from.eye_normal)",
                                "normalize(cross(dFdx(from.eye_position), dFdy(from.eye_position)))")},
      {"WrongColourSpace", of_shader("tone.glsl", "mix(curve,", "mix(colour,")},
      {"CameraMovedOnePercent", of_scene([](Scene& scene) {
         const glm::dvec3 sight = scene.camera.target - scene.camera.position;
         const glm::dvec3 aside = glm::normalize(glm::cross(sight, scene.camera.up)) * glm::length(sight) * 0.01;
         scene.camera.position += aside;
         scene.camera.target += aside;
       })},
      {"OcclusionOff", of_scene([](Scene& scene) { scene.occlusion.on = false; })},
      {"MoreOpaque", of_scene([](Scene& scene) {
         for (Look& look : scene.looks) look.opacity = std::min(1.0f, look.opacity + 0.1f);
       })},
      {"SectionForgotten", of_scene([](Scene& scene) { scene.section.reset(); })},
      {"CapsForgotten", of_shader("cap_count.frag", "void main() {", "void main() {\n  discard;")},
      {"LightFromTheOtherSide", of_shader("lighting.glsl", "vec3(-0.477, 0.620, 0.623)", "vec3(0.477, 0.620, 0.623)")},
      {"LayersBackToFront", of_shader("surface.frag", "gl_FragCoord.z <= texelFetch(layer_before",
                                      "gl_FragCoord.z < texelFetch(layer_before")},
      {"WiresForgotten", of_scene([](Scene& scene) { scene.wire = false; })},
      {"OverlaysForgotten", of_scene([](Scene& scene) { scene.overlays = {}; })},
      {"LinesSunkIntoTheSurface", of_shader("line.vert", "(1.0 - min(lift", "(1.0 + min(lift")},
      {"HiddenLinesForgotten", of_shader("line.frag", "gl_FragCoord.z <= before ||", "gl_FragCoord.z >= before ||")},
      {"TetrahedraNotShrunk", of_scene([](Scene& scene) { scene.overlays.shrink = 1; })},
      {"BackgroundUpsideDown",
       of_scene([](Scene& scene) { std::swap(scene.background.top, scene.background.bottom); })},
  };
}

class Mutants : public DrawingTest, public ::testing::WithParamInterface<NamedMutation> {};

TEST_P(Mutants, MakeAGoldenFail) {
  std::vector<std::string> noticed;
  for (const GoldenCase& golden : golden_cases()) {
    const Image drawn = draw_golden(context(), golden, GetParam().mutation);
    if (!compare(drawn, read_png(golden_file(golden, ".png")), golden_tolerance).within_tolerance)
      noticed.emplace_back(golden.name);
  }
  std::string names;
  for (const std::string& name : noticed) names += name + " ";
  RecordProperty("noticed_by", names);
  EXPECT_FALSE(noticed.empty()) << "no golden noticed " << GetParam().name;
}

INSTANTIATE_TEST_SUITE_P(Each, Mutants, ::testing::ValuesIn(mutations()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace odontoscope::testing_support
