// The panel as it is drawn and operated: a scripted hand finds its controls, and both eyes see it where it stands.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/headset/eye_painter.h"
#include "engine/headset_viewer/headset_texture.h"
#include "engine/picture/png.h"
#include "engine/view/offscreen.h"
#include "tests/headset/drawing.h"
#include "tests/headset/worlds.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

constexpr double tick = 1.0 / 90;

class Sheet : public Drawing {
 protected:
  static constexpr PixelSize size{800, 760};
  std::unique_ptr<HeadsetTexture> sheet;
  const MolarWorld& molar = MolarWorld::once();
  const Model& model = molar.model;
  const VisitWorld world = molar.world();
  const ComfortRules rules;
  const HeadsetPanelWords words{
      "Small molar",           true, "DB on a grid of 64: 1 234 edges of cracks, 56 misoriented.", "",
      Certificate::Mark::good, true};
  HeadsetInput input = person();
  Visit visit;

  void begin() override {
    sheet = std::make_unique<HeadsetTexture>(context->gl(), ShaderLibrary{});
    step(3);
  }
  void finish() override { sheet.reset(); }
  void step(int times = 1) {
    for (int i = 0; i < times; ++i) {
      visit = advance_visit(std::move(visit), input, world, rules, tick);
      sheet->update(visit, input, world, words, tick);
    }
  }
  /// Near the end of the control with this label, inside the ids given, as PanelPlace counts.
  glm::dvec2 control(const std::string& label, const std::vector<std::string>& inside = {}, double share = 0.9) {
    sheet->update(visit, input, world, words, 1);  // as after a while
    ImGuiID id = ImHashStr("room panel");
    for (const std::string& part : inside) id = ImHashStr(part.c_str(), 0, id);
    id = ImHashStr(label.c_str(), 0, id);
    for (const Interface::Place& place : sheet->interface().places)
      if (place.id == id)
        return HeadsetTexture::on_panel(place.left + share * (place.right - place.left),
                                        0.5 * (place.top + place.bottom));
    ADD_FAILURE() << "there is no control " << label;
    return {0.5, 0.5};
  }
  void point(const glm::dvec2& at) {
    const double trigger = input.hands[1].trigger;
    input.hands[1] = pointing_at(place_of(*visit.panel, at), input.head.position + glm::dvec3(0.2, -0.3, -0.2));
    input.hands[1].trigger = trigger;
    step(2);
  }
  void click(const std::string& label, const std::vector<std::string>& inside = {}) {
    point(control(label, inside));
    input.hands[1].trigger = 1;
    step(3);
    input.hands[1].trigger = 0;
    step(3);
  }
  std::pair<Image, Image> both_eyes(bool with_panel = true) {
    EyePainter painter(context->gl(), ShaderLibrary{}, model);
    Framebuffer pixels[2];
    for (Framebuffer& eye : pixels) eye = Framebuffer(context->gl(), {size, {GL_SRGB8_ALPHA8}, GL_DEPTH_COMPONENT32F});
    const Target targets[2] = {{pixels[0].id(), 0, 0, size, true}, {pixels[1].id(), 0, 0, size, true}};
    painter.draw(
        visit, input, world, eyes_of(input.head), targets,
        with_panel ? [&](const EyeView& eye, const Target& target) { sheet->draw(eye, target); } : EyePainter::Over{});
    return {read_pixels(context->gl(), pixels[0].id(), size), read_pixels(context->gl(), pixels[1].id(), size)};
  }
  static void keep(const std::string& name, const Image& image) {
    std::filesystem::create_directories(ODONTOSCOPE_HEADSET_PICTURES);
    write_png(image, std::string(ODONTOSCOPE_HEADSET_PICTURES) + "/" + name + ".png");
  }
};

TEST_F(Sheet, AHandOperatesItsControls) {
  const float enamel_before = visit.scene.look_of("dentine")->opacity;
  click("dentine", {"dentine"});
  EXPECT_NE(visit.scene.look_of("dentine")->opacity, enamel_before);
  EXPECT_NEAR(visit.scene.look_of("dentine")->opacity, 0.9, 0.05);
  click("eye", {"pulp"});
  EXPECT_FALSE(visit.scene.look_of("pulp")->visible);
  click("Tint", {"back faces"});
  EXPECT_EQ(visit.scene.back_faces, BackFaces::tint);
  click("Cut it open");
  EXPECT_TRUE(visit.scene.section);
  click("DB", {"method"});
  EXPECT_TRUE(visit.chosen.db);
  click("DT", {"method"});
  EXPECT_FALSE(visit.chosen.db);
  click("Both", {"volume shows"});
  EXPECT_EQ(visit.scene.volume.shows, VolumeLook::Shows::both);
  EXPECT_LE(visit.scene.look_of("dentine")->opacity, around_volume);
  click("Surfaces", {"volume shows"});
  EXPECT_FALSE(visit.scene.volume.shows_volume());
  click("True size");
  EXPECT_EQ(visit.stage.magnification, 1);
  click("Enlarge it");
  EXPECT_EQ(visit.stage.magnification, usual_magnification);
  const auto drawn = [&] { return read_pixels(context->gl(), sheet->pixels().id(), sheet->pixels().size()); };
  const Image tooth_page = drawn();
  both_eyes();  // being looked at does not stop it from being drawn
  click("Measure", {"page"});
  EXPECT_NE(drawn(), tooth_page);
  click("Measures", {"tool"});
  EXPECT_EQ(visit.chosen.tool, HandTool::distance);
  click("Help", {"page"});
  click("Leave the headset");
  EXPECT_TRUE(visit.leaving);
}

TEST_F(Sheet, ADragGoesOnBesideThePanel) {
  const glm::dvec2 start = control("dentine", {"dentine"}, 0.5);
  point(start);
  input.hands[1].trigger = 1;
  step(2);
  EXPECT_NEAR(visit.scene.look_of("dentine")->opacity, 0.5, 0.05);
  point({1.2, start.y});
  EXPECT_EQ(visit.scene.look_of("dentine")->opacity, 1);
  input.hands[1].trigger = 0;
  step(2);
  point({start.x, start.y});
  EXPECT_EQ(visit.scene.look_of("dentine")->opacity, 1);
}

TEST_F(Sheet, LeadsInsideSaysWhereOneIsAndLeadsOut) {
  click("Go inside");
  step(80);
  ASSERT_TRUE(visit.cavity);
  click("Canals", {"page"});
  const auto lines = rideable(world.cavities[0].lines);
  ASSERT_FALSE(lines.empty());
  const double length = lines[0]->length_to_wall();
  char button[80];
  std::snprintf(button, sizeof button, "%s   %.1f mm", lines[0]->name.c_str(), length);
  click(button);
  step(80);
  ASSERT_TRUE(visit.tour.ride);
  EXPECT_TRUE(visit.tour.ride->playing);
  point(control("Stop here"));
  const Ride& tour = *visit.tour.ride;
  visit.tour.ride->along = 0.4 * tour.track.points.back().along;
  input.head.turn = glm::angleAxis(-0.25, glm::dvec3(0, 1, 0));
  step(3);
  const auto [left, right] = both_eyes();
  keep("tour-left", left);
  keep("tour-right", right);
  EXPECT_NE(left, right);
  click("Stop here");
  EXPECT_FALSE(visit.tour.ride->playing);
  click("Leave it here", {"two"});
  EXPECT_FALSE(visit.tour.ride);
  click("Out again");
  step(80);
  EXPECT_FALSE(visit.cavity);
}

TEST_F(Sheet, CapitalLettersAreADegreeHigh) {
  const ImFontGlyph& letter = *sheet->interface().regular->FindGlyph('H');
  const double pixels = letter.Y1 - letter.Y0;
  const double metres = visit.panel->size.y * (HeadsetTexture::on_panel(0, pixels).y);
  EXPECT_GE(glm::degrees(std::atan(metres / panel_distance)), 0.95);
  // As wide as high: letters are not stretched.
  const glm::dvec2 square = HeadsetTexture::on_panel(100, 100) * visit.panel->size;
  EXPECT_NEAR(square.x / square.y, 1, 0.01);
}

TEST_F(Sheet, BothEyesSeeItWhereItStandsAndNothingElseChanges) {
  input.head.turn = glm::angleAxis(-0.3, glm::dvec3(0, 1, 0));
  point({0.5, 0.55});
  const auto [left, right] = both_eyes();
  const auto [bare_left, bare_right] = both_eyes(false);
  keep("panel-left", left);
  keep("panel-right", right);
  const auto eyes = eyes_of(input.head);
  for (std::size_t e = 0; e < 2; ++e) {
    const Image &with = e == 0 ? left : right, &without = e == 0 ? bare_left : bare_right;
    // Changed pixels fill what the corners span, but for the hand's ray.
    std::vector<glm::dvec2> corners;
    for (const glm::dvec2& corner : {glm::dvec2(0, 0), glm::dvec2(0, 1), glm::dvec2(1, 1), glm::dvec2(1, 0)}) {
      const glm::dvec3 in_eye =
          glm::conjugate(eyes[e].pose.turn) * (place_of(*visit.panel, corner) - eyes[e].pose.position);
      const FieldOfView& field = eyes[e].field;
      corners.emplace_back(
          size.width * (in_eye.x / -in_eye.z - std::tan(field.left)) / (std::tan(field.right) - std::tan(field.left)),
          size.height * (std::tan(field.up) - in_eye.y / -in_eye.z) / (std::tan(field.up) - std::tan(field.down)));
    }
    std::size_t inside = 0, inside_changed = 0, outside_changed = 0;
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        double least = 1e9;  // pixels inside the nearest edge
        for (std::size_t k = 0; k < 4; ++k) {
          const glm::dvec2 edge = corners[(k + 1) % 4] - corners[k], to = glm::dvec2(x + 0.5, y + 0.5) - corners[k];
          least = std::min(least, (edge.y * to.x - edge.x * to.y) / glm::length(edge));
        }
        const bool changed = with.pixel(x, y) != without.pixel(x, y);
        if (least > 12) {  // its corners are round
          ++inside;
          inside_changed += changed ? 1u : 0u;
        } else if (least < -1) {
          outside_changed += changed ? 1u : 0u;
        }
      }
    EXPECT_GT(inside, 40000u);
    EXPECT_GT(inside_changed, inside * 99 / 100);
    EXPECT_LT(outside_changed, 2500u);
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
