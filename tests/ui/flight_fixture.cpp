#include "tests/ui/flight_fixture.h"

#include "engine/render/face_count.h"

namespace odontoscope::testing_support {

void FlightTest::expect_closed_in() {
  const ViewerState& state = viewer().state();
  constexpr PixelSize pixels{240, 180};
  const GpuModel model = upload(gl(), state.shown->model);
  const FaceCounter counter(gl(), ShaderLibrary{});
  // With all of the solid each line of sight meets as many fronts as backs, which tells ties at folds from wrong sides.
  Scene scene = state.scene;
  std::string solid;
  for (const ModelPart& part : state.shown->model.parts)
    if (part.structure == spaces().cavities.at(fly().cavity.value()).structure) solid = part.solid;
  for (const ModelPart& part : state.shown->model.parts) scene.look_of(part.structure)->visible = part.solid == solid;
  const FaceVerdict verdict =
      judge(counter.count(model, scene, view_of(state.scene.camera, state.shown->model, 4.0 / 3), pixels));
  EXPECT_EQ(verdict.covered, static_cast<std::size_t>(pixels.width) * pixels.height) << "background seen";
  // A body that fills the void is shown inside out: its backs are the wall's fronts.
  const bool body = spaces().cavities.at(fly().cavity.value()).body;
  EXPECT_EQ(verdict.back_nearest - verdict.ties, body ? verdict.covered : 0u) << "the wrong side of a wall is seen";
}

}  // namespace odontoscope::testing_support
