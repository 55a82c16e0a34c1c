// A mode of the viewer is a folder and a line: here one that the program does not have.
#include "tests/ui/counting/counting_mode.h"
#include "tests/ui/driver.h"

namespace odontoscope::testing_support {
namespace {

class AddedMode : public ViewerTest {
 protected:
  static ViewerOptions with_counting() {
    ViewerOptions options;
    options.modes.insert(options.modes.begin(), odontoscope::mode<CountingMode>);  // the line
    return options;
  }
  bool has_control(const std::string& label) {
    const auto& places = viewer().interface().places;
    return std::any_of(places.begin(), places.end(),
                       [&](const Interface::Place& place) { return place.id == control_id(label); });
  }
};

TEST_F(AddedMode, TakesKeysClicksAndEscape) {
  viewer_with_tooth(with_counting());
  const Camera before = viewer().state().scene.camera;
  type(U'k');
  EXPECT_TRUE(mode<CountingMode>().on());
  const Area& area = viewer().panes().front().area;
  const double x = area.left + area.width / 2, y = area.top + area.height / 2;
  click(x, y);
  click(x, y);
  frames(30);
  EXPECT_EQ(mode<CountingMode>().clicks(), 2);
  EXPECT_EQ(viewer().state().scene.camera, before) << "a double click turned the tooth round this point";
  click(area.left + 5, y);
  EXPECT_EQ(mode<CountingMode>().clicks(), 2) << "there is no tooth";
  press_key(Key::escape);
  EXPECT_FALSE(mode<CountingMode>().on());
}

TEST_F(AddedMode, ChangesWhatOthersShow) {
  viewer_with_tooth(with_counting());
  EXPECT_TRUE(mode<NamesMode>().names_shown());
  type(U'k');
  EXPECT_FALSE(mode<NamesMode>().names_shown());
  press_key(Key::escape);
  EXPECT_TRUE(mode<NamesMode>().names_shown());
}

TEST_F(AddedMode, HasItsSectionInThePanel) {
  viewer_with_tooth(with_counting());
  EXPECT_TRUE(has_control("Counting"));
  type(U'c');  // into the pulp, where the panel is the flight's
  frames(60);
  EXPECT_FALSE(has_control("Counting"));
  viewer_with_tooth();
  EXPECT_FALSE(has_control("Counting"));
}

TEST_F(AddedMode, IsLeftWhenAnotherModelComes) {
  viewer_with_tooth(with_counting());
  type(U'k');
  viewer().open({});
  wait_until_loaded();
  EXPECT_FALSE(mode<CountingMode>().on());
}

TEST_F(AddedMode, IsAskedBeforeThoseBehindItOnly) {
  ViewerOptions options;
  options.modes.push_back(odontoscope::mode<CountingMode>);  // behind NamesMode and LookMode
  viewer_with_tooth(std::move(options));
  type(U'k');
  const Area& area = viewer().panes().front().area;
  const double x = area.left + area.width / 2, y = area.top + area.height / 2;
  click(x, y);
  EXPECT_EQ(mode<CountingMode>().clicks(), 1) << "nobody else takes a single click";
  click(x, y);
  EXPECT_EQ(mode<CountingMode>().clicks(), 1) << "a double click is LookMode's";
}

}  // namespace
}  // namespace odontoscope::testing_support
