// Two drivers, one picture.

#include "engine/picture/image_difference.h"
#include "tests/radiograph/solids.h"
#include "tests/raycast/cast_bench.h"

namespace odontoscope::test {
namespace {

class CastBackends : public CastTest {
 protected:
  /// Lit, cut, with a clear and a solid structure; or greys.
  static std::vector<Image> pictures(const Gl& gl) {
    const ValueGrid grid = whole(lumps());
    const Model model = make_model(
        {{"clear", block({-3.7, -2.9, -3.3}, {2.8, 2.2, 4.1})}, {"solid", ball({0.9, 0.3, -0.9}, 1.7, 24, 16)}});
    std::vector<Image> drawn;
    for (const auto cast : {VolumeLook::Cast::shaded, VolumeLook::Cast::maximum, VolumeLook::Cast::average,
                            VolumeLook::Cast::radiograph, VolumeLook::Cast::surface})
      for (const NamedCamera& from : cameras()) {
        VolumeLook look = shaded_look();
        look.shows = VolumeLook::Shows::both;
        look.cast = cast;
        look.lit = true;
        look.white = 200;
        look.iso = 90;
        Scene scene = scene_of(model, from.camera, look);
        scene.look_of("clear")->opacity = 0.3f;
        scene.section = Section{{0.5, 0.6, -0.4}, {-0.2, 0.9, -0.2}};
        drawn.push_back(cast_with(gl, model, grid, scene, {}, {80, 60}));
      }
    return drawn;
  }
};

TEST_F(CastBackends, AgreeWithinTwoLevels) {
  std::vector<std::vector<Image>> drawn;
  for (const Backend backend : {Backend::egl, Backend::osmesa}) {
    const testing_support::PerhapsContext made = testing_support::try_context(backend);
    if (!made.context) {
      context().make_current();
      GTEST_SKIP() << made.reason;
    }
    drawn.push_back(pictures(made.context->gl()));
  }
  context().make_current();
  for (std::size_t i = 0; i < drawn[0].size(); ++i) {
    int worst = 0;
    for (std::size_t byte = 0; byte < drawn[0][i].rgba.size(); ++byte)
      worst = std::max(worst, std::abs(drawn[0][i].rgba[byte] - drawn[1][i].rgba[byte]));
    EXPECT_LE(worst, 2) << i;
    EXPECT_NE(drawn[0][i], Image(80, 60)) << i;
    EXPECT_NE(drawn[0][i], drawn[0][(i + 1) % drawn[0].size()]) << i;
  }
}

}  // namespace
}  // namespace odontoscope::test
