// Names beside the tooth: a line to a place on each structure that is seen, and two sentences about it on a click.

#include <algorithm>

#include "engine/viewer/names/structure_labels.h"
#include "tests/ui/driver.h"

namespace odontoscope::testing_support {
namespace {

class Names : public ViewerTest {
 protected:
  void SetUp() override {
    ViewerTest::SetUp();
    if (!IsSkipped()) viewer_with_tooth();
  }
  std::vector<DrawnName> drawn() {
    return drawn_names(mode<NamesMode>().names(), viewer().state(), viewer().panes().front(), viewer().interface(), 1);
  }
  const std::string& structure(const DrawnName& name) { return mode<NamesMode>().names().places[name.which].structure; }
  std::vector<std::string> seen() {
    std::vector<std::string> all;
    for (const DrawnName& name : drawn()) all.push_back(structure(name));
    std::sort(all.begin(), all.end());
    return all;
  }
  Scene& scene() { return viewer().state().scene; }
  using Strings = std::vector<std::string>;
};

TEST_F(Names, StandBesideWhatTheyName) {
  EXPECT_EQ(seen(), (Strings{"dentine", "enamel", "pulp"}));
  const Area& area = viewer().panes().front().area;
  const auto all = drawn();
  for (const DrawnName& name : all) {
    EXPECT_TRUE(area.holds(name.place.x, name.place.y)) << structure(name);
    EXPECT_TRUE(area.holds(name.box.left, name.box.top) &&
                area.holds(name.box.left + name.box.width - 1, name.box.top + name.box.height - 1))
        << structure(name);
    for (const DrawnName& other : all) {
      if (other.which <= name.which) continue;
      const bool apart =
          name.box.left + name.box.width <= other.box.left || other.box.left + other.box.width <= name.box.left ||
          name.box.top + name.box.height <= other.box.top || other.box.top + other.box.height <= name.box.top;
      EXPECT_TRUE(apart) << structure(name) << " over " << structure(other);
    }
  }
}

TEST_F(Names, AreOfWhatIsSeen) {
  scene().look_of("dentine")->visible = false;
  frame();
  EXPECT_EQ(seen(), (Strings{"enamel", "pulp"}));
  scene().look_of("dentine")->visible = true;
  scene().look_of("dentine")->opacity = 1;  // the pulp is inside
  frame();
  EXPECT_EQ(seen(), (Strings{"dentine", "enamel"}));
  type(U's');
  frames(2);
  EXPECT_EQ(seen(), (Strings{"dentine", "enamel", "pulp"})) << "the section lays it open";
}

TEST_F(Names, AClickTellsWhatItIsAndEscapePutsItAway) {
  const auto all = drawn();
  ASSERT_FALSE(all.empty());
  const DrawnName& first = all.front();
  click(first.box.left + first.box.width / 2, first.box.top + first.box.height / 2);
  EXPECT_EQ(mode<NamesMode>().names().told, std::optional(first.which));
  EXPECT_FALSE(mode<NamesMode>().canal());
  keep_picture("name-told");
  press_key(Key::escape);
  EXPECT_FALSE(mode<NamesMode>().names().told);
  type(U'h');
  frame();
  EXPECT_FALSE(viewer().state().settings.names);
  click(first.box.left + first.box.width / 2, first.box.top + first.box.height / 2);
  EXPECT_FALSE(mode<NamesMode>().names().told);
}

TEST_F(Names, AreNotForTheFlight) {
  type(U'c');
  for (int i = 0; i < 8; ++i) frame(0.2);
  ASSERT_TRUE(mode<FlyMode>().state().on);
  EXPECT_FALSE(mode<NamesMode>().names_shown());
}

TEST(NamesTold, EveryTissueHasTwoSentences) {
  for (const char* name : {"enamel", "dentine", "Dentin", "PULP", "cementum", "tooth", "dentine cavity", "bone"}) {
    const std::string_view told = told_of(name);
    EXPECT_GE(std::count(told.begin(), told.end(), '.'), 2) << name;
  }
  EXPECT_NE(told_of("dentine cavity"), told_of("dentine"));
  EXPECT_TRUE(told_of("structure 7").empty());
}

}  // namespace
}  // namespace odontoscope::testing_support
