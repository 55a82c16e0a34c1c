// Stills: rays that are told by those around them, against a ray through every sample.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "recon/volume/read_volume.h"
#include "tests/output/temporary_folder.h"
#include "tests/radiograph/solids.h"
#include "tests/raycast/cast_bench.h"

namespace odontoscope::test {
namespace {

constexpr RenderOptions still{.side = 2}, every_sample{.side = 2, .rays = RenderOptions::Rays::every};

struct Unlike {
  int worst = 0, pixels = 0, drawn = 0;  // of 255; off by more than two; not black
};

Unlike unlike(const Image& one, const Image& other) {
  Unlike found;
  for (int y = 0; y < one.height; ++y)
    for (int x = 0; x < one.width; ++x) {
      int here = 0, light = 0;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        here = std::max(here, std::abs(one.pixel(x, y)[channel] - other.pixel(x, y)[channel]));
        light = std::max<int>(light, other.pixel(x, y)[channel]);
      }
      found.worst = std::max(found.worst, here);
      found.pixels += here > 2;
      found.drawn += light > 0;
    }
  return found;
}

class Still : public CastTest {
 protected:
  static constexpr PixelSize large{320, 240};

  Unlike judged(const Model& model, const ValueGrid& grid, const Scene& scene,
                const std::vector<ShaderEdit>& edits = {}, float coarseness = 1) {
    const testing_support::TemporaryFolder folder;
    write_edited_shaders(edits, folder.path().string());
    return unlike(cast_with(gl(), model, grid, scene, {folder.path()}, large, still, coarseness),
                  cast_with(gl(), model, grid, scene, {}, large, every_sample, coarseness));
  }

  static VolumeLook look_of(VolumeLook::Cast cast) {
    VolumeLook look = shaded_look();
    look.cast = cast;
    look.lit = true;
    look.white = 200;
    look.attenuation = 0.6;
    return look;
  }

  /// A ball and rods in the volume, the rods thinner than the first rays are apart, and a clear box around.
  struct Stage {
    ValueGrid grid = whole(lumps());
    Model model = make_model({{"clear", block({-3.7, -2.9, -3.3}, {2.8, 2.2, 4.1})},
                              {"rod", block({-2.5, 1.9, 0.2}, {2.5, 1.92, 0.22})},
                              {"other rod", block({0.2, 1.9, -2.5}, {0.22, 1.92, 2.5})},
                              {"solid", ball({0.9, 0.3, -0.9}, 0.9, 24, 16)}});
    Scene scene = scene_of(model, cameras()[1].camera, [] {
      VolumeLook look = shaded_look();
      look.shows = VolumeLook::Shows::both;
      return look;
    }());
    Stage() {
      *scene.look_of("clear") = {"clear", colour_of(0x4060a0), 0.4f};
      *scene.look_of("solid") = {"solid", colour_of(0x905030), 1};
    }
  };
};

/// A thousandth of what is drawn may be off by more than two levels, and nothing by more than six.
void expect_as_good(const Unlike& found, const std::string& what) {
  EXPECT_GT(found.drawn, 3000) << what;
  EXPECT_LE(found.pixels, found.drawn / 1000) << what;
  EXPECT_LE(found.worst, 6) << what;
}

TEST_F(Still, IsThatOfARayThroughEverySample) {
  const ValueGrid grid = whole(lumps());
  const Model model = box_model(grid);
  for (const VolumeLook::Cast kind :
       {VolumeLook::Cast::shaded, VolumeLook::Cast::maximum, VolumeLook::Cast::average, VolumeLook::Cast::radiograph})
    for (const NamedCamera& from : cameras())
      expect_as_good(judged(model, grid, scene_of(model, from.camera, look_of(kind))),
                     std::string(name(kind)) + from.name);
}

TEST_F(Still, AmongSurfacesIsThatOfARayThroughEverySample) {
  const Stage stage;
  expect_as_good(judged(stage.model, stage.grid, stage.scene), "both");
}

TEST_F(Still, OfTheCtMolarIsThatOfARayThroughEverySample) {
  const std::filesystem::path file = std::filesystem::path(ODONTOSCOPE_DATA) / "ct_molar" / "tooth.nrrd";
  if (std::string(ODONTOSCOPE_DATA).empty() || !std::filesystem::exists(file))
    GTEST_SKIP() << "the data set ct_molar is not here";
  const ValueGrid grid = whole(read_volume(file, {}, {}));
  const Model model = box_model(grid);
  VolumeLook look = look_of(VolumeLook::Cast::shaded);
  look.transfer = transfer_of(TransferPreset::tooth, 78, 164);
  const Scene scene = scene_of(model, usual_scene(model, 4.0 / 3).camera, look);
  expect_as_good(judged(model, grid, scene), "CT");
  // What is left are the fine lines of steps of half a voxel: finer steps have none.
  EXPECT_EQ(judged(model, grid, scene, {}, 0.2f).pixels, 0);
}

TEST_F(Still, HasMutantsThatAreNoticed) {
  const Stage stage;
  for (const ShaderEdit& edit :
       {ShaderEdit{"volume_alike.frag", "bool straight = ", "bool straight = true || "},
        {"volume_alike.frag", "|| surfaces_are_one(apart * cell, apart)", "|| true"},
        {"volume_told.frag", "vec4 own = texelFetch(coarse, cell, 0)",
         "vec4 own = texelFetch(coarse, max(cell - 2, ivec2(0)), 0)"},
        {"volume_ray.glsl", "vec2(sample_cast()) + 0.5", "vec2(sample_cast()) + 0.5 * float(apart)"}}) {
    const Unlike found = judged(stage.model, stage.grid, stage.scene, {edit});
    EXPECT_TRUE(found.pixels > found.drawn / 1000 || found.worst > 6) << edit.to;
  }
}

// No two of the first rays are further apart than values: what lies between them would be missed.
TEST_F(Still, BeginsWithRaysAsFarApartAsTheValuesAre) {
  const ValueGrid grid = whole(lumps());
  const Model model = box_model(grid);
  const GpuModel gpu_model = upload(gl(), model);
  const GpuValueGrid values = upload(gl(), grid, gpu_model);
  const GpuVolume volume(gl(), grid, values.field());
  const auto distances = [&](double height_mm, bool every_ray) {
    Camera camera = cameras()[0].camera;  // parallel
    camera.height_mm = height_mm;
    const View view = view_of(camera, model, 1);
    return ray_distances({.world_to_eye = view.world_to_eye,
                          .eye_to_clip = view.eye_to_clip,
                          .parallel = true,
                          .size = {100, 100},
                          .every_ray = every_ray},
                         volume);
  };
  // Values lie 0.3 mm apart along the finest axis.
  EXPECT_EQ(distances(29, false), (std::vector{1}));
  EXPECT_EQ(distances(14, false), (std::vector{2, 1}));
  EXPECT_EQ(distances(7, false), (std::vector{4, 2, 1}));
  EXPECT_EQ(distances(0.1, false), (std::vector{8, 4, 2, 1}));
  EXPECT_EQ(distances(0.1, true), (std::vector{1}));
}

}  // namespace
}  // namespace odontoscope::test
