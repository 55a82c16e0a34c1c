// A renderer keeps no picture: what it drew before must not show in what it draws next.

#include "tests/render/drawing.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

class Frames : public DrawingTest {};

TEST_F(Frames, HoldNothingOfTheOneBefore) {
  const Model model = make_model({{"core", ball({{}, 2})}, {"mantle", ball({{}, 5})}});
  Scene first = usual_scene(model, 4.0 / 3), second = first;
  first.camera.field_of_view_deg = 12;                                // fills the picture
  second.camera.field_of_view_deg = 60;                               // small, and
  second.camera.target += glm::dvec3(6, 0, 5);                        // in a corner
  for (const bool occluded : {true, false}) {
    first.occlusion.on = second.occlusion.on = occluded;
    context().make_current();
    const GpuModel gpu_model = upload(gl(), model);
    Renderer used(gl(), ShaderLibrary{}), fresh(gl(), ShaderLibrary{});
    const PictureOptions options{{160, 120}, {2}};
    picture_of(gl(), used, gpu_model, model, first, options);
    const Image after = picture_of(gl(), used, gpu_model, model, second, options);
    EXPECT_TRUE(content_of(after).shows_something());
    EXPECT_EQ(after, picture_of(gl(), fresh, gpu_model, model, second, options));
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
