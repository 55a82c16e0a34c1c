// The hints of the first run, and what a newcomer reaches without them.

#include "engine/navigate/screen.h"
#include "tests/ui/flight_fixture.h"

namespace odontoscope::testing_support {
namespace {

class FirstRunTest : public FlightTest {
 protected:
  void SetUp() override {
    FlightTest::SetUp();
    first_run_ = true;
    size_ = {900, 500};
  }
};

TEST_F(FirstRunTest, HintsAreTickedAndGoForGood) {
  viewer_with(sample_tooth_loaded());
  ASSERT_TRUE(mode<HelpMode>().hints_shown());
  frames(2);
  keep_picture("first-run");
  EXPECT_FALSE(mode<HelpMode>().hints().turned());
  const Area area = viewer().panes().front().area;
  drag(area.left + 300, area.top + 300, area.left + 400, area.top + 300);
  EXPECT_TRUE(mode<HelpMode>().hints().turned());
  type(U'c');
  fade();
  EXPECT_TRUE(mode<HelpMode>().hints().flown());
  EXPECT_TRUE(viewer().state().settings.hints);
  type(U'1');  // a canal by its number
  fade();
  EXPECT_FALSE(viewer().state().settings.hints);
  const Settings next = settings_from_json(to_json(viewer().state().settings)).settings;
  EXPECT_FALSE(next.hints);
}

TEST_F(FirstRunTest, HintsCanBeClosed) {
  viewer_with_tooth();
  frames(2);
  click_control("Got it", {}, "hints");
  EXPECT_FALSE(mode<HelpMode>().hints_shown());
  EXPECT_FALSE(viewer().state().settings.hints);
}

TEST_F(FirstRunTest, TheTitleNamesTheTooth) {
  LoadedModel tooth = toy_tooth();
  tooth.tooth = "lower left first molar: FDI 36, Universal 19";
  viewer_with(tooth);
  EXPECT_NE(viewer().title().find("FDI 36, Universal 19"), std::string::npos);
}

/// From start to the inside of a canal in two actions.
TEST_F(FirstRunTest, ANewcomerIsInACanalAfterTwoActions) {
  viewer_with(sample_tooth_loaded(), {.settings = {.panel = false}});
  const Point3& half_way = [&]() -> const Point3& {
    const CentreLine& canal = spaces().cavities.front().lines.canals.front();
    return canal.points[canal.points.size() / 2].at;
  }();
  const ViewPane& pane = viewer().panes().front();
  const auto place = place_of(pane.camera, {half_way.x, half_way.y, half_way.z});
  ASSERT_TRUE(place);
  const glm::dvec2 pixel = pixel_of(pane.area, *place);
  click(pixel.x, pixel.y);
  press_key(Key::enter);
  fade();
  EXPECT_TRUE(fly().on);
  EXPECT_TRUE(fly().ride);
}

}  // namespace
}  // namespace odontoscope::testing_support
