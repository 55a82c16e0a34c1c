// Sums, averages and maxima along 10,000 rays, against other code than the shaders'.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "recon/radiograph/sum_through.h"
#include "tests/output/temporary_folder.h"
#include "tests/raycast/cast_bench.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {
namespace {

class Projection : public CastTest, public ::testing::WithParamInterface<NamedCamera> {
 protected:
  struct Judged {
    double worst = 0, brightest = 0;  // of 255
    int rays = 0;
  };
  /// `wanted(ray, span)` is the part that is shown, of 1; black beside the box.
  template <class Wanted>
  Judged judged(const Volume& volume, const VolumeLook& look, const std::optional<Section>& section, Wanted wanted,
                const ShaderLibrary& shaders = {}) {
    const ValueGrid grid = whole(volume);
    const Model model = box_model(grid);
    Scene scene = scene_of(model, GetParam().camera, look);
    scene.section = section;
    const Image image = cast(model, grid, scene, shaders);
    Judged judged;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) {
        const Ray ray = ray_through(scene.camera, picture, x, y);
        const Span span = span_of(ray, grid, section);
        const double right = span.empty() ? 0 : 255 * std::clamp(wanted(grid, ray, span), 0.0, 1.0);
        judged.brightest = std::max(judged.brightest, right);
        judged.worst = std::max(judged.worst, std::abs(right - image.pixel(x, y)[0]));
        judged.rays += span.empty() ? 0 : 1;
      }
    return judged;
  }

  static VolumeLook look_of(VolumeLook::Cast cast) {
    VolumeLook look;
    look.shows = VolumeLook::Shows::volume;
    look.cast = cast;
    look.black = 0;
    look.white = 200;
    look.attenuation = 0.6;
    return look;
  }
};

FilmRay film_ray(const Ray& ray, const Span& span) {
  const glm::dvec3 end = ray.at(span.to + 1);
  return {{end.x, end.y, end.z}, {ray.direction.x, ray.direction.y, ray.direction.z}, span.to + 1 - span.from};
}

/// Rounding to eight bits takes half a level.
constexpr double one_level = 1;

// The exact integral: what the processor computes for a film, cell by cell.
TEST_P(Projection, OfARadiographSumsAsTheFilmDoes) {
  const Volume volume = lumps();
  const VolumeLook look = look_of(VolumeLook::Cast::radiograph);
  const auto wanted = [&](const ValueGrid&, const Ray& ray, const Span& span) {
    return look.attenuation / look.white * sum_along(volume, 0, film_ray(ray, span)) / look.latitude;
  };
  const Judged whole_one = judged(volume, look, std::nullopt, wanted);
  EXPECT_GT(whole_one.rays, 3000);
  EXPECT_GT(whole_one.brightest, 60);
  EXPECT_LT(whole_one.worst, one_level);
  const Judged cut = judged(volume, look, Section{{0.3, 0, 0.2}, {0.2, 1, -0.3}}, wanted);
  EXPECT_LT(cut.worst, one_level);
}

// The film covers all that the rays pass beside the box, too, and hangs at the model's middle, square to where the
// camera looks.
TEST_P(Projection, OfARadiographHasAnEdgeAndMayBeInverted) {
  const ValueGrid grid = whole(lumps());
  const Model model = box_model(grid);
  Camera camera = GetParam().camera;  // the box is but a part of the picture
  camera.height_mm *= 3;
  camera.field_of_view_deg = 80;
  const bool within_it = GetParam().name == std::string("Inside");
  const glm::dvec2 size_mm = within_it ? glm::dvec2(0.6, 0.8) : glm::dvec2(5.1, 7.3);
  const auto drawn = [&](const glm::dvec2& film_mm, bool inverted, const std::vector<ShaderEdit>& edits = {}) {
    const testing_support::TemporaryFolder folder;
    write_edited_shaders(edits, folder.path().string());
    VolumeLook look = look_of(VolumeLook::Cast::radiograph);
    look.film_mm = film_mm;
    look.inverted = inverted;
    return cast(model, grid, scene_of(model, camera, look), {folder.path()});
  };
  const Image usual = drawn({0, 0}, false), negative = drawn({0, 0}, true), film = drawn(size_mm, false);
  const Image larger = drawn(size_mm, false, {{"film_edge.glsl", "0.5 * film", "0.6 * film"}});
  const glm::dvec3 ahead = glm::normalize(camera.target - camera.position),
                   right = glm::normalize(glm::cross(ahead, camera.up)), up = glm::cross(right, ahead),
                   centre = model.bounds_mm.centre();
  int wrong = 0, noticed = 0, within = 0, unlike = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const Ray ray = ray_through(camera, picture, x, y);
      const glm::dvec3 off = ray.at(glm::dot(centre - ray.origin, ahead) / glm::dot(ray.direction, ahead)) - centre;
      const glm::dvec2 from_centre(std::abs(glm::dot(off, right)), std::abs(glm::dot(off, up)));
      const bool inside = glm::all(glm::lessThan(from_centre, 0.5 * size_mm));
      const auto wanted = inside ? usual.pixel(x, y) : std::array<std::uint8_t, 4>{41, 41, 41, 255};
      within += inside;
      wrong += film.pixel(x, y) != wanted;
      noticed += larger.pixel(x, y) != wanted;
      unlike += std::abs(255 - usual.pixel(x, y)[1] - negative.pixel(x, y)[1]) > 1;
    }
  EXPECT_GT(within, 40);
  EXPECT_LE(wrong, 12);  // on its edge
  EXPECT_GT(noticed, 24) << "a larger film";
  EXPECT_EQ(unlike, 0);
}

// Noise from voxel to voxel, with values below that of air.
TEST_P(Projection, OfNoiseSumsAsTheFilmDoes) {
  RandomNumbers random(11);
  Volume volume = lumps();
  for (float& value : volume.values) value += static_cast<float>(random.between(-15, 15));
  const VolumeLook look = look_of(VolumeLook::Cast::radiograph);
  const Judged noise = judged(volume, look, std::nullopt, [&](const ValueGrid&, const Ray& ray, const Span& span) {
    return look.attenuation / look.white * sum_along(volume, 0, film_ray(ray, span)) / look.latitude;
  });
  EXPECT_LT(noise.worst, one_level);
}

TEST_P(Projection, IsTheLargestValue) {
  const VolumeLook look = look_of(VolumeLook::Cast::maximum);
  const Judged found =
      judged(lumps(), look, std::nullopt,
             [&](const ValueGrid& grid, const Ray& ray, const Span& span) { return largest(grid, look, ray, span); });
  EXPECT_GT(found.brightest, 250);
  EXPECT_LT(found.worst, one_level);
}

TEST_P(Projection, IsTheAverage) {
  VolumeLook look = look_of(VolumeLook::Cast::average);
  look.black = 10;
  look.white = 60;
  const Judged found =
      judged(lumps(), look, Section{{0.3, 0, 0.2}, {0.2, 1, -0.3}},
             [&](const ValueGrid& grid, const Ray& ray, const Span& span) { return average(grid, look, ray, span); });
  EXPECT_GT(found.brightest, 60);
  EXPECT_LT(found.worst, one_level);
}

// Without the bricks the same picture comes out, to the last bit.
TEST_P(Projection, PassesOverNothingThatIsSeen) {
  const testing_support::TemporaryFolder folder;
  write_edited_shaders({{"volume_ray.glsl", "if (far == 0) return number;", "return number;"}}, folder.path().string());
  const ValueGrid grid = whole(lumps());
  const Model model = box_model(grid);
  for (VolumeLook look : {look_of(VolumeLook::Cast::radiograph), look_of(VolumeLook::Cast::maximum),
                          look_of(VolumeLook::Cast::average), shaded_look()}) {
    const Scene scene = scene_of(model, GetParam().camera, look);
    EXPECT_EQ(cast(model, grid, scene), cast(model, grid, scene, {folder.path()})) << name(look.cast);
  }
}

TEST_P(Projection, HasMutantsThatAreNoticed) {
  const Volume volume = lumps();
  VolumeLook look = look_of(VolumeLook::Cast::radiograph);
  const auto wanted = [&](const ValueGrid&, const Ray& ray, const Span& span) {
    return look.attenuation / look.white * sum_along(volume, 0, film_ray(ray, span)) / look.latitude;
  };
  const ShaderEdit edits[] = {
      {"volume_ray.glsl", "(place + 0.5) / size", "(place + 0.8) / size"},
      {"volume_ray.glsl", "clip(dot(section.xyz, origin), dot(section.xyz, direction), -endless, section.w, ray);", ""},
      {"volume.frag", "attenuation * part * (far - near)", "attenuation * max(part, 0.05) * (far - near)"}};
  for (const ShaderEdit& edit : edits) {
    const testing_support::TemporaryFolder folder;
    write_edited_shaders({edit}, folder.path().string());
    EXPECT_GT(judged(volume, look, Section{{0.3, 0, 0.2}, {0.2, 1, -0.3}}, wanted, {folder.path()}).worst, 2)
        << edit.to;
  }
}

INSTANTIATE_TEST_SUITE_P(From, Projection, ::testing::ValuesIn(cameras()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace odontoscope::test
