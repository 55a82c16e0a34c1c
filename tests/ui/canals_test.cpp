// Canals clicked from outside, through the tooth or in a section, and on the small picture in flight.

#include "engine/viewer/names/canals.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "engine/navigate/screen.h"
#include "engine/viewer/fly/fly_annotations.h"
#include "engine/viewer/look/annotations.h"
#include "tests/ui/flight_fixture.h"

namespace odontoscope::testing_support {
namespace {

class CanalsTest : public FlightTest {
 protected:
  void SetUp() override {
    FlightTest::SetUp();
    if (!IsSkipped()) viewer_with(sample_tooth_loaded(), {.settings = {.panel = false}});
  }
  const std::optional<CanalPick>& canal() { return mode<NamesMode>().canal(); }
  const ViewPane& pane() { return viewer().panes().front(); }
  std::vector<const CentreLine*> lines() { return rideable(spaces().cavities.at(0).lines); }
  /// A place on the canal, part of the way from its orifice to its end.
  glm::dvec3 place_on_canal(std::size_t line, double part) {
    const CentreLine& canal = *lines().at(line);
    const auto first = static_cast<double>(canal.orifice), last = static_cast<double>(canal.points.size() - 1);
    const CentrePoint& point = canal.points[static_cast<std::size_t>(first + part * (last - first))];
    return {point.at.x, point.at.y, point.at.z};
  }
  glm::dvec2 pixel(const glm::dvec3& place) { return pixel_of(pane().area, place_of(pane().camera, place).value()); }
  /// Where the chamber is seen farthest from all lines that leave it.
  glm::dvec2 clear_of_lines() {
    const CentreLines& known = spaces().cavities[0].lines;
    const glm::dvec3 middle(known.chamber.x, known.chamber.y, known.chamber.z);
    glm::dvec2 best = pixel(middle);
    double farthest = 0;
    for (const double aside : {-0.6, -0.3, 0.0, 0.3, 0.6})
      for (const double up : {-0.5, 0.0, 0.5}) {
        const glm::dvec2 at = pixel(middle + known.chamber_radius * glm::dvec3(aside, 0, up));
        double nearest = 1e9;
        for (const CentreLine* line : lines())
          for (const CentrePoint& point : line->points) {
            const glm::dvec3 place(point.at.x, point.at.y, point.at.z);
            if (glm::length(place - middle) > known.chamber_radius)
              nearest = std::min(nearest, glm::length(pixel(place) - at));
          }
        if (nearest > farthest) farthest = nearest, best = at;
      }
    return best;
  }
  void look_from(char32_t key) {
    viewer().handle(TextTyped{key});
    frame(1);
    frame(1);
  }
  void double_click(double x, double y) {
    move(x, y);
    for (int i = 0; i < 2; ++i) {
      press();
      release();
    }
  }
};

TEST_F(CanalsTest, AreNamedByAClickFromEverySide) {
  std::size_t hit = 0, tried = 0;
  for (const char32_t side : {U'0', U'1', U'3', U'6'}) {
    look_from(side);
    for (std::size_t line = 0; line < spaces().cavities[0].lines.canals.size(); ++line) {
      for (const double part : {0.4, 0.9}) {
        const glm::dvec3 place = place_on_canal(line, part);
        const glm::dvec2 at = pixel(place);
        click(at.x, at.y);
        frame(1);  // the next one is no double click
        ++tried;
        ASSERT_TRUE(canal()) << "view " << static_cast<int>(side - U'0') << ", canal " << line << " at " << part;
        if (canal()->line == line) ++hit;
        // Another one, or the chamber, only where it lies before this one.
        else
          EXPECT_LT(depth_of(pane().camera, canal()->at), depth_of(pane().camera, place) + 0.2);
      }
    }
    if (side == U'1') keep_picture("canal-clicked");
  }
  EXPECT_GT(hit, tried * 3 / 5);
  click(20, 160);  // beside the tooth
  EXPECT_FALSE(canal());
}

TEST_F(CanalsTest, HideBehindWhatIsOpaqueAndShowInASection) {
  for (Look& look : viewer().state().scene.looks) look.opacity = 1;
  look_from(U'1');
  // The one that lies farthest back: where all of it is cut away, so are the others.
  std::size_t hindmost = 0;
  for (std::size_t line = 1; line < spaces().cavities[0].lines.canals.size(); ++line)
    if (place_on_canal(line, 0.5).y < place_on_canal(hindmost, 0.5).y) hindmost = line;
  const glm::dvec3 place = place_on_canal(hindmost, 0.5);
  const glm::dvec2 at = pixel(place);
  click(at.x, at.y);
  EXPECT_FALSE(canal());
  frame(1);
  const glm::dvec3 aside(6, 0, 0);  // its handle would take the click
  viewer().state().scene.section = Section{place + aside, {0, 1, 0}};
  frame(1);
  click(at.x, at.y);
  ASSERT_TRUE(canal());
  EXPECT_EQ(canal()->line, hindmost);
  keep_picture("canal-in-section");
  viewer().state().scene.section =
      Section{place + aside - glm::dvec3(0, 3, 0), {0, 1, 0}};  // all of the canal is cut away here
  frame(1);
  click(at.x, at.y);
  EXPECT_FALSE(canal());
}

TEST_F(CanalsTest, ADoubleClickOrEnterRidesDown) {
  look_from(U'1');
  const glm::dvec2 at = pixel(place_on_canal(2, 0.6));
  double_click(at.x, at.y);
  fade();
  ASSERT_TRUE(fly().on);
  ASSERT_TRUE(fly().ride);
  EXPECT_EQ(fly().ride->line, 2u);
  type(U'c');
  fade();
  ASSERT_FALSE(fly().on);
  const glm::dvec2 other = pixel(place_on_canal(1, 0.6));
  click(other.x, other.y);
  const auto chosen = canal();
  ASSERT_TRUE(chosen);
  const Camera before = viewer().state().scene.camera;
  press_key(Key::enter);
  fade();
  ASSERT_TRUE(fly().ride);
  EXPECT_EQ(fly().ride->line, chosen->line);
  press_key(Key::escape);
  fade();
  EXPECT_EQ(viewer().state().scene.camera, before);
  press_key(Key::escape);
  EXPECT_FALSE(canal());
  press_key(Key::enter);
  fade();
  EXPECT_FALSE(fly().on) << "none is chosen";
}

TEST_F(CanalsTest, TheChamberIsNamedAndEnteredByEnterWhileADoubleClickTurnsRoundIt) {
  look_from(U'1');
  const glm::dvec2 at = clear_of_lines();
  double_click(at.x, at.y);
  fade();
  EXPECT_FALSE(fly().on);
  ASSERT_TRUE(canal());
  EXPECT_TRUE(canal()->in_chamber);
  EXPECT_EQ(name_of(*canal(), spaces()), "pulp chamber");
  press_key(Key::enter);
  fade();
  EXPECT_TRUE(fly().on);
  EXPECT_FALSE(fly().ride);
}

TEST_F(CanalsTest, TheSmallPictureCanBeClickedInFlight) {
  size_ = {640, 480};  // it needs room
  type(U'c');
  fade();
  for (std::size_t line = 0; line < 3; ++line) {
    const Area area = inset_area(pane(), scale_);
    ASSERT_GT(area.width, 0);
    const Camera small = inset_camera(viewer().state().shown->model, fly().habits.inset_from, area);
    const glm::dvec3 place = place_on_canal(line, 0.8);
    const glm::dvec2 at = pixel_of(area, place_of(small, place).value());
    click(at.x, at.y);
    fade();
    frame(1);
    ASSERT_TRUE(fly().ride) << line;
    const Point3& end = lines()[fly().ride->line]->points.back().at;
    const glm::dvec2 end_at = pixel_of(area, place_of(small, {end.x, end.y, end.z}).value());
    EXPECT_LT(glm::distance(end_at, at), 40) << "it rides a canal of another root";
  }
}

TEST_F(CanalsTest, ThePanelListsThemOutside) {
  viewer_with(sample_tooth_loaded());
  click_control("Canals");
  const CentreLine& canal = *lines()[1];
  const double length = canal.length_to_wall();  // as the anatomy tells it
  char words[100];
  std::snprintf(words, sizeof words, "%s   %.1f mm", canal.name.c_str(), length);
  click_control(words);
  fade();
  ASSERT_TRUE(fly().ride);
  EXPECT_EQ(fly().ride->line, 1u);
}

}  // namespace
}  // namespace odontoscope::testing_support
