// The film of a model without a volume, against lengths inside its solids in double precision: one ray through every
// triangle.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "recon/radiograph/tissue.h"
#include "tests/output/temporary_folder.h"
#include "tests/radiograph/solids.h"
#include "tests/raycast/cast_bench.h"

namespace odontoscope::test {
namespace {

/// A ray's way inside a closed solid, in what a section leaves.
double length_inside(const SurfaceMesh& mesh, const Ray& ray, const std::optional<Section>& section) {
  std::vector<std::pair<double, int>> faces;  // where, and +1 where the ray enters
  const auto corner = [&](PointIndex index) {
    return glm::dvec3(mesh.points[index].x, mesh.points[index].y, mesh.points[index].z);
  };
  for (const Triangle& triangle : mesh.triangles) {
    // Moller and Trumbore, Journal of Graphics Tools 2(1), 1997.
    const glm::dvec3 a = corner(triangle[0]), u = corner(triangle[1]) - a, v = corner(triangle[2]) - a,
                     p = glm::cross(ray.direction, v);
    const double det = glm::dot(u, p);
    if (det == 0) continue;
    const glm::dvec3 s = ray.origin - a, q = glm::cross(s, u);
    const double b = glm::dot(s, p) / det, c = glm::dot(ray.direction, q) / det;
    if (b >= 0 && c >= 0 && b + c <= 1) faces.emplace_back(glm::dot(v, q) / det, det > 0 ? 1 : -1);
  }
  std::sort(faces.begin(), faces.end());
  double from = -1e9, to = 1e9;
  if (section) {
    const double speed = glm::dot(section->normal, ray.direction),
                 way = glm::dot(section->normal, section->point_mm - ray.origin) / speed;
    (speed > 0 ? to : from) = way;
  }
  double sum = 0;
  int inside = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (inside > 0) sum += std::max(0.0, std::min(faces[i].first, to) - std::max(faces[i - 1].first, from));
    inside += faces[i].second;
  }
  return sum;
}

class ModelFilm : public CastTest, public ::testing::WithParamInterface<NamedCamera> {
 protected:
  static constexpr PixelSize picture{80, 80};
  SurfaceMesh crown = block({-2.9, -2.2, 0.4}, {2.4, 2.6, 3.3}), body = ball({0.3, -0.2, -0.4}, 2.6, 24, 16),
              pulp = ball({0.4, 0.1, -0.6}, 1.1, 20, 12);
  Model model = make_model(
      {{"enamel", crown}, {"dentine", body}, {"pulp", pulp}, {"marble", block({-4, -4, -4}, {-3.2, -3.1, -2.8})}});

  static double attenuation(const char* name) {
    return linear_attenuation(*tissue_called(name), effective_energy_kev(usual_kv));
  }

  Scene scene(const std::optional<Section>& section) const {
    VolumeLook look;
    look.shows = VolumeLook::Shows::volume;
    look.cast = VolumeLook::Cast::radiograph;
    look.latitude = 3;
    Scene scene = scene_of(model, GetParam().camera, look);
    scene.section = section;
    return scene;
  }

  Image drawn(const Scene& scene, const std::vector<ShaderEdit>& edits = {}) {
    const testing_support::TemporaryFolder folder;
    write_edited_shaders(edits, folder.path().string());
    Renderer renderer(gl(), {folder.path()});
    return picture_of(gl(), renderer, upload(gl(), model), model, scene, {.size = picture, .render = one_ray_a_pixel});
  }

  /// Of 255, of all pixels but so many of the worst: a silhouette may run through a pixel's very middle.
  double off(const Scene& scene, const Image& image, std::size_t on_edges = 2) const {
    std::vector<double> worst;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) {
        const Ray ray = ray_through(scene.camera, picture, x, y);
        double sum = 0;
        for (const auto& [name, mesh] : {std::pair{"enamel", &crown}, {"dentine", &body}, {"pulp", &pulp}})
          if (scene.look_of(name)->visible) sum += attenuation(name) * length_inside(*mesh, ray, scene.section);
        worst.push_back(std::abs(255 * std::clamp(sum / scene.volume.latitude, 0.0, 1.0) - image.pixel(x, y)[1]));
      }
    std::nth_element(worst.begin(), worst.end() - static_cast<std::ptrdiff_t>(on_edges + 1), worst.end());
    return worst[worst.size() - on_edges - 1];
  }
};

const Section cut{{0.5, 0.3, -0.4}, {-0.2, 0.9, -0.2}}, cut_away_from_the_eye{{0.5, -0.3, -0.4}, {0.2, -0.9, 0.2}};

// Three solids of known tissues overlap as they like; what is unknown (marble) lets rays through.
TEST_P(ModelFilm, IsThatOfLengthsInsideItsSolids) {
  const Image image = drawn(scene(std::nullopt));
  EXPECT_LE(off(scene(std::nullopt), image), 1);
  int brightest = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) brightest = std::max<int>(brightest, image.rgba[i]);
  EXPECT_GT(brightest, 100);
}

TEST_P(ModelFilm, IsCutBySections) {
  for (Section section : {cut, cut_away_from_the_eye}) {
    section.normal = glm::normalize(section.normal);
    EXPECT_LE(off(scene(section), drawn(scene(section))), 1);
  }
}

// In the middle of the model, square to where the camera looks: what lies there has its own size.
TEST_P(ModelFilm, HasAnEdgeAndMayBeInverted) {
  Scene edged = scene(std::nullopt);
  edged.volume.film_mm = {3.1, 4.1};
  Scene inverted = scene(std::nullopt);
  inverted.volume.inverted = true;
  const Image usual = drawn(scene(std::nullopt)), film = drawn(edged), negative = drawn(inverted);
  const glm::dvec3 ahead = glm::normalize(edged.camera.target - edged.camera.position),
                   right = glm::normalize(glm::cross(ahead, edged.camera.up)), up = glm::cross(right, ahead),
                   centre = model.bounds_mm.centre();
  int wrong = 0, within = 0, unlike = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const Ray ray = ray_through(edged.camera, picture, x, y);
      const glm::dvec3 off = ray.at(glm::dot(centre - ray.origin, ahead) / glm::dot(ray.direction, ahead)) - centre;
      const bool inside = std::abs(glm::dot(off, right)) < 1.55 && std::abs(glm::dot(off, up)) < 2.05;
      within += inside;
      wrong += film.pixel(x, y) != (inside ? usual.pixel(x, y) : std::array<std::uint8_t, 4>{41, 41, 41, 255});
      unlike += std::abs(255 - usual.pixel(x, y)[1] - negative.pixel(x, y)[1]) > 1;
    }
  EXPECT_GT(within, 40);
  EXPECT_LE(wrong, 4);  // on its edge
  EXPECT_EQ(unlike, 0);
}

TEST_P(ModelFilm, LeavesOutWhatIsHidden) {
  Scene without = scene(std::nullopt);
  without.look_of("enamel")->visible = false;
  EXPECT_LE(off(without, drawn(without)), 1);
}

TEST_P(ModelFilm, HasMutantsThatAreNoticed) {
  Section section = cut;
  section.normal = glm::normalize(section.normal);
  for (const ShaderEdit& edit :
       {ShaderEdit{"film_faces.frag", "gl_FrontFacing ? -attenuation : attenuation", "attenuation"},
        {"film_faces.frag", "if (dot(section.xyz, place) > section.w) discard;", ""},
        {"film_faces.frag", "parallel != 0 ? -eye_place.z : length(eye_place)",
         "parallel == 0 ? -eye_place.z : length(eye_place)"},
        {"film.frag", "approach - middle", "approach"},
        {"film.frag", "- dot(section.xyz, begin)", "- 0.001"},
        {"film.frag", "sum / latitude", "1.03 * sum / latitude"}}) {
    const bool of_parallel_rays = edit.to == "- 0.001";
    if (of_parallel_rays && GetParam().camera.projection != Camera::Projection::parallel) continue;
    EXPECT_GT(off(scene(section), drawn(scene(section), {edit})), 2) << edit.from << " -> " << edit.to;
  }
}

INSTANTIATE_TEST_SUITE_P(From, ModelFilm, ::testing::Values(cameras()[0], cameras()[1]),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace odontoscope::test
