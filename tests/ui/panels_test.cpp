// The panels, by what a click at the place where a control is drawn changes; each leaves a picture to be looked at.
#include <imgui_internal.h>

#include <chrono>
#include <glm/geometric.hpp>
#include <thread>

#include "engine/navigate/section_handle.h"
#include "engine/picture/image_difference.h"
#include "tests/ui/driver.h"

namespace odontoscope::testing_support {
namespace {

class Panels : public ViewerTest {
 protected:
  void SetUp() override {
    ViewerTest::SetUp();
    if (IsSkipped()) return;
    size_ = {760, 1500};  // all sections fit
    viewer_with_tooth();
  }
};

TEST_F(Panels, EyesHideStructures) {
  const Image before = picture();
  click_control("eye", {"pulp"});
  EXPECT_FALSE(viewer().state().scene.look_of("pulp")->visible);
  EXPECT_GT(compare(picture(), before).share, 0.001);
  keep_picture("structure-hidden");
  click_control("eye", {"pulp"});
  EXPECT_TRUE(viewer().state().scene.look_of("pulp")->visible);
}

TEST_F(Panels, SlidersMakeStructuresClear) {
  const glm::dvec2 slider = control("enamel", {"enamel"});  // near the right end
  click(slider.x, slider.y);
  EXPECT_GT(viewer().state().scene.look_of("enamel")->opacity, 0.8f);
  drag(slider.x, slider.y, 60, slider.y);
  EXPECT_EQ(viewer().state().scene.look_of("enamel")->opacity, 0);
}

TEST_F(Panels, OpacitiesAreRememberedAndGivenBack) {
  const Look usual = *viewer().state().shown->scene.look_of("enamel");
  const glm::dvec2 slider = control("enamel", {"enamel"});
  click(slider.x - 60, slider.y);
  const float chosen = viewer().state().scene.look_of("enamel")->opacity;
  ASSERT_NE(chosen, usual.opacity);
  const Settings settings =
      settings_from_json(to_json(viewer().state().settings)).settings;  // as the next run finds them
  viewer_with_tooth({.settings = settings});
  EXPECT_EQ(viewer().state().scene.look_of("enamel")->opacity, chosen);
  EXPECT_EQ(viewer().state().shown->scene.look_of("enamel")->opacity, usual.opacity);
  click_control("Usual colours and opacities");
  EXPECT_EQ(*viewer().state().scene.look_of("enamel"), usual);
  EXPECT_TRUE(viewer().state().settings.looks.empty());
  frames(2);
  for (const Interface::Place& place : viewer().interface().places)
    EXPECT_NE(place.id, control_id("Usual colours and opacities")) << "nothing to give back";

  LoadedModel given = toy_tooth();  // by the command line
  given.given.looks = true;
  ViewerOptions options{.load = [given](const LoadRequest&, const Progress&) { return given; }, .settings = settings};
  viewer_with_tooth(std::move(options));
  EXPECT_EQ(viewer().state().scene.look_of("enamel")->opacity, usual.opacity);
}

TEST_F(Panels, ColoursHaveAPicker) {
  click_control("swatch", {"pulp", "colour"});
  frames(3);
  keep_picture("picker");
  click(control("swatch", {"pulp", "colour"}).x + 110,
        control("swatch", {"pulp", "colour"}).y + 110);  // into the picker
  EXPECT_NE(viewer().state().scene.look_of("pulp")->colour, usual_colour("pulp", 0));
}

TEST_F(Panels, BackFacesAreChosen) {
  click_control("Tint", {"back faces"});
  EXPECT_EQ(viewer().state().scene.back_faces, BackFaces::tint);
  frame();
  EXPECT_EQ(viewer().state().settings.back_faces, BackFaces::tint);  // remembered
  keep_picture("tint");
}

TEST_F(Panels, TheSectionIsSwitchedOnAndLed) {
  click_control("Cut the model open");
  frames(2);
  ASSERT_TRUE(viewer().state().scene.section);
  click_control("Mesial", {"side"});
  EXPECT_EQ(viewer().state().scene.section->normal, AnatomicalFrame().mesial);
  const glm::dvec2 slider = control("Position");
  click(slider.x, slider.y);
  EXPECT_GT(offset_of(*viewer().state().scene.section, viewer().state().shown->model), 5);
  const glm::dvec3 normal = viewer().state().scene.section->normal;
  click_control("Cut away the other side");
  EXPECT_LT(glm::dot(viewer().state().scene.section->normal, normal), -0.999);
  keep_picture("section-panel");
}

TEST_F(Panels, TheCapShowsAVolumesValues) {
  viewer_with_tooth({.load = [](const LoadRequest&, const Progress&) {
    LoadedModel loaded = toy_tooth();
    Volume volume;
    volume.size = {2, 2, 2};
    volume.spacing = {12, 12, 12};
    volume.origin = {-6, -6, -6};
    volume.values = {0, 100, 0, 100, 0, 100, 0, 100};
    loaded.values = std::make_shared<const ValueGrid>(value_grid(volume, loaded.model.bounds_mm));
    return loaded;
  }});
  click_control("Cut the model open");
  frames(2);
  const Image material = picture();
  click_control("CT values", {"cap"});
  frames(2);
  EXPECT_EQ(viewer().state().scene.cap.shows, CapLook::Shows::ct);
  EXPECT_GT(compare(picture(), material).share, 0.02);
  keep_picture("cap-values");
  const glm::dvec2 white = control("White");
  drag(white.x, white.y, 0.5 * white.x, white.y);
  ASSERT_TRUE(viewer().state().scene.cap.window);
  EXPECT_LT(viewer().state().scene.cap.window->high, 60);
  EXPECT_EQ(viewer().state().scene.cap.window->low, 0);
  click_control("Material", {"cap"});
  EXPECT_EQ(viewer().state().scene.cap.shows, CapLook::Shows::material);
}

TEST_F(Panels, AModelWithoutAVolumeHasNoValuesForTheCap) {
  click_control("Cut the model open");
  frames(2);
  const ImGuiID id = ImHashStr("CT values", 0, ImHashStr("cap", 0, ImHashStr("panel")));
  for (const Interface::Place& place : viewer().interface().places) EXPECT_NE(place.id, id);
}

TEST_F(Panels, OverlaysAreSwitched) {
  click_control("Overlays");
  frames(2);
  click_control("Triangle edges");
  EXPECT_TRUE(viewer().state().scene.wire);
  click_control("Faulty edges");
  EXPECT_TRUE(viewer().state().scene.overlays.edges);
  keep_picture("overlays");
}

TEST_F(Panels, AMeshHasNoTetrahedraToShow) {
  click_control("Overlays");
  frames(2);
  EXPECT_FALSE(viewer().state().scene.overlays.slab);
  EXPECT_EQ(viewer().state().shown->overlays.slabs(), 0u);
}

TEST_F(Panels, TheBackdropIsChosen) {
  click_control("White", {"backdrop"});
  EXPECT_EQ(viewer().state().settings.backdrop, Backdrop::white);
  frame();
  EXPECT_EQ(picture().pixel(size_.width - 4, size_.height - 4), (std::array<std::uint8_t, 4>{255, 255, 255, 255}));
}

TEST_F(Panels, APictureIsTakenByTheButton) {
  const ScratchFolder scratch;
  viewer_with_tooth({.settings = {.picture = {200, 100, true, 1, false}}, .folder = scratch.path()});
  click_control("Picture");
  frames(2);
  keep_picture("picture-panel");
  click_control("Take a picture");
  frames(2);
  for (int i = 0; i < 3000 && viewer().wait_timeout() < 0.2; ++i) {  // until it is written
    frame(0);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_FALSE(viewer().state().notices.empty());
  EXPECT_NE(viewer().state().notices.back().words.find("Toy-tooth-001.png"), std::string::npos);
}

TEST_F(Panels, ClicksInThePanelDoNotReachThePicture) {
  const Camera before = viewer().state().scene.camera;
  drag(150, 1500, 250, 1400);
  scroll(150, 1000, 3);
  EXPECT_EQ(viewer().state().scene.camera, before);
}

TEST_F(Panels, HelpListsTheKeys) {
  type(U'?');
  EXPECT_TRUE(mode<HelpMode>().dialog_open());
  size_ = size;
  frames(3);
  keep_picture("help");
  press_key(Key::escape);
  EXPECT_FALSE(mode<HelpMode>().dialog_open());
}

TEST_F(Panels, DragsOnACardDoNotReachThePicture) {
  type(U'?');
  frames(3);
  const Camera before = viewer().state().scene.camera;
  const Area area = viewer().panes().front().area;
  drag(area.left + 60, size_.height / 2.0, area.left + 160, size_.height / 2.0 + 30);
  EXPECT_EQ(viewer().state().scene.camera, before);
}

TEST_F(Panels, TypingAFileNameIsNoCommand) {
  press_key(Key::o, {.control = true});
  ASSERT_TRUE(mode<OpenMode>().file_asked_for());
  frames(3);
  for (const char32_t c : {U'/', U's', U'b', U'5', U'?'}) type(c);
  EXPECT_EQ(*mode<OpenMode>().file_asked_for(), "/sb5?");
  EXPECT_FALSE(viewer().state().scene.section);
  EXPECT_FALSE(mode<HelpMode>().dialog_open());
  keep_picture("open");
  press_key(Key::escape);
  EXPECT_FALSE(mode<OpenMode>().file_asked_for());
}

TEST_F(Panels, EnterOpensTheFile) {
  std::string asked;
  viewer_with_tooth({.load = [&asked](const LoadRequest& request, const Progress&) {
    asked = request.file;
    return toy_tooth();
  }});
  press_key(Key::o, {.control = true});
  frames(3);
  for (const char32_t c : {U'a', U'.', U's'}) type(c);
  press_key(Key::enter);
  frame();
  wait_until_loaded();
  EXPECT_EQ(asked, "a.s");
}

TEST_F(Panels, AFaultyModelIsRed) {
  viewer_with_tooth({.load = [](const LoadRequest&, const Progress&) {
    LoadedModel loaded = toy_tooth();
    loaded.certificate = {Certificate::Verdict::wanting,
                          "Found wanting: not a closed oriented manifold",
                          {{Certificate::Mark::bad, "tooth: 12 boundary edges, 3 misoriented edges"},
                           {Certificate::Mark::bad, "tooth: open surface, 1,204 triangles, area 310 mm^2"}}};
    return loaded;
  }});
  frames(2);
  const auto redness = [](const Image& image) {
    std::size_t count = 0;
    for (int y = 50; y < 140; ++y)
      for (int x = 0; x < 300; ++x) count += image.pixel(x, y)[0] > image.pixel(x, y)[1] + 20 ? 1 : 0;
    return count;
  };
  EXPECT_GT(redness(picture()), 3000u);
  keep_picture("wanting");
  viewer_with_tooth();
  EXPECT_LT(redness(picture()), 300u);
}

TEST_F(Panels, AnAmberModelIsAmberAndItsPlacesLeadThere) {
  const glm::dvec3 place(0, 0, 5);
  const auto load = [&](const LoadRequest&, const Progress&) {
    LoadedModel loaded = toy_tooth();
    loaded.certificate = {Certificate::Verdict::look_here,
                          "Amber: certified, but look at 1 place",
                          {{Certificate::Mark::look,
                            "pulp, slices 3 and 4 (z 4.5 to 5.5 mm), near (0.00, 0.00, 5.00): one piece ends in slice "
                            "3 and another begins in slice 4, 0.62 mm aside.",
                            place}}};
    return loaded;
  };
  viewer_with_tooth({.load = load});
  frames(2);
  const auto amberness = [](const Image& image) {  // the edge of the headline
    std::size_t count = 0;
    for (int y = 50; y < 160; ++y)
      for (int x = 0; x < 40; ++x)
        count += image.pixel(x, y)[0] > 220 && image.pixel(x, y)[1] > 160 && image.pixel(x, y)[2] < 120 ? 1 : 0;
    return count;
  };
  EXPECT_GT(amberness(picture()), 60u);
  keep_picture("amber");
  EXPECT_FALSE(mode<LookMode>().looked_at());
  mode<LookMode>().look_at(place);
  frames(4, 0.2);
  ASSERT_TRUE(mode<LookMode>().looked_at());
  EXPECT_EQ(viewer().state().scene.camera.target, place);
  keep_picture("amber_place");
  press_key(Key::escape);
  frame();
  EXPECT_FALSE(mode<LookMode>().looked_at());
  viewer_with_tooth();
  EXPECT_EQ(amberness(picture()), 0u);
}

}  // namespace
}  // namespace odontoscope::testing_support
