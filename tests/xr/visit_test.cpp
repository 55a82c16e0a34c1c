// A whole visit with a real runtime: what both eyes see, where the head is, a trigger that leads inside, and the
// desktop afterwards.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <thread>

#include "engine/headset_viewer/headset_loop.h"
#include "engine/headset_viewer/headset_texture.h"
#include "engine/picture/png.h"
#include "engine/view/offscreen.h"
#include "engine/viewer/window_loop.h"
#include "tests/render/shapes.h"
#include "tests/xr/monado.h"
#include "tests/xr/validation.h"

namespace odontoscope::testing_support {
namespace {

/// Beside the build, since the root's own folders vanish.
void keep_picture(const std::string& name, const Image& left, const Image& right) {
  Image both(left.width + right.width + 8, left.height);
  for (int y = 0; y < left.height; ++y)
    for (int x = 0; x < left.width; ++x) {
      both.set_pixel(x, y, left.pixel(x, y));
      both.set_pixel(left.width + 8 + x, y, right.pixel(x, y));
    }
  std::filesystem::create_directories(ODONTOSCOPE_XR_PICTURES);
  write_png(both, std::string(ODONTOSCOPE_XR_PICTURES) + "/" + name + ".png");
}

LoadedModel loaded_from(Model model, const std::string& title) {
  LoadedModel loaded;
  loaded.title = title;
  loaded.model = std::move(model);
  loaded.scene = usual_scene(loaded.model, 1);
  loaded.pickable = std::make_shared<const Pickable>(loaded.model);
  return loaded;
}

/// A visit in a window on the display in memory. `watch` is called for every frame and returns false to end it.
class VisitTest : public ::testing::Test {
 protected:
  using Watch = std::function<bool(const HeadsetFrame&, const Visit&)>;
  std::unique_ptr<Monado> monado;
  std::unique_ptr<Window> window;
  std::unique_ptr<Viewer> viewer;

  void SetUp() override {
    monado = std::make_unique<Monado>();
    window = std::make_unique<Window>(WindowOptions{.size = {800, 600}, .debug = true});
  }
  void TearDown() override {
    for (const std::string& message : window->context().debug_messages()) ADD_FAILURE() << "OpenGL says: " << message;
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
    viewer.reset();
    window.reset();
  }
  const Gl& gl() const { return window->context().gl(); }

  bool visit(const std::function<LoadedModel()>& load, const Watch& watch, HeadsetVisitOptions options = {}) {
    viewer =
        std::make_unique<Viewer>(gl(), ShaderLibrary{},
                                 ViewerOptions{.load = [load](const LoadRequest&, const Progress&) { return load(); },
                                               .side = 1,
                                               .coarse_when_slow = false});
    viewer->open({});
    std::stop_source stop;
    options.watch = [&](const HeadsetFrame& frame, const Visit& now) {
      if (!watch(frame, now)) stop.request_stop();
    };
    options.say = [](const std::string& words) { std::printf("measured: %s\n", words.c_str()); };
    return visit_in_headset(*viewer, *window, ShaderLibrary{}, stop.get_token(), options);
  }
  std::pair<Image, Image> seen(const HeadsetFrame& frame) const {
    return {read_pixels(gl(), frame.targets[0].framebuffer, frame.targets[0].size),
            read_pixels(gl(), frame.targets[1].framebuffer, frame.targets[1].size)};
  }
  /// The window's own frames, as after any visit.
  void expect_the_desktop_goes_on() {
    std::stop_source stop;
    std::jthread closer([&stop] {
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
      stop.request_stop();
    });
    run_in_window(*viewer, *window, stop.get_token());
    const PixelSize size = window->size();
    viewer->draw({size, window->scale(), 0}, {0, 0, 0, size});
    EXPECT_TRUE(content_of(read_pixels(gl(), 0, size)).shows_something());
  }
};

/// The middle of the pixels near `foretold` that the ball covers, against the background; x from the left, y from the
/// bottom. Farther off the panel stands.
glm::dvec2 middle_of_covered(const Image& image, const glm::dvec2& foretold) {
  constexpr double near = 18;  // pixels; the ball has half of that
  glm::dvec2 sum(0);
  double count = 0;
  const auto background = image.pixel(0, 0);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto pixel = image.pixel(x, y);
      const glm::dvec2 place(x + 0.5, image.height - y - 0.5);
      if (glm::length(place - foretold) > near) continue;
      if (std::abs(pixel[0] - background[0]) + std::abs(pixel[1] - background[1]) + std::abs(pixel[2] - background[2]) <
          12)
        continue;
      sum += place;
      count += 1;
    }
  return count > 0 ? sum / count : glm::dvec2(-1e9);
}

/// Where an eye sees a place of the room, in pixels, by nothing but its pose and its field of view.
glm::dvec2 foretold(const EyeView& eye, const glm::dvec3& place, PixelSize size) {
  const glm::dvec3 in_eye = glm::conjugate(eye.pose.turn) * (place - eye.pose.position);
  const auto share = [](double tangent, double low, double high) {
    return (tangent - std::tan(low)) / (std::tan(high) - std::tan(low));
  };
  return {size.width * share(in_eye.x / -in_eye.z, eye.field.left, eye.field.right),
          size.height * share(in_eye.y / -in_eye.z, eye.field.down, eye.field.up)};
}

TEST_F(VisitTest, BothEyesDifferByWhatPoseAndDepthPredictAndFollowTheHead) {
  const std::vector<Pose> heads = {{{0, 1.6, 0}, {1, 0, 0, 0}},
                                   {{0.15, 1.7, 0.1}, {1, 0, 0, 0}},
                                   {{-0.1, 1.5, -0.15}, glm::angleAxis(-0.25, glm::dvec3(0, 1, 0))},
                                   {{0, 1.6, 0.2}, glm::angleAxis(0.2, glm::normalize(glm::dvec3(1, 0.3, 0.5)))}};
  std::size_t head = 0;
  int since = 0, compared = 0;
  double worst = 0, widest = 0;
  std::vector<glm::dvec2> places;
  RemoteBody body;
  body.left.there = body.right.there = false;
  std::optional<Stage> stood;
  const bool well = visit(
      [] {
        return loaded_from(make_model({{"ball", ball({{1, 2, 3}, 1.2, 32})}}), "Ball");
      },
      [&](const HeadsetFrame& frame, const Visit& now) {
        if (!frame.draw || !frame.input.focused) return true;
        if (head == heads.size()) return false;
        body.head = heads[head];
        monado->say(body);
        if (++since < 30) return true;  // the runtime predicts, and needs a while to believe that the head stands still
        since = 0;
        ++head;
        EXPECT_EQ(now.stage, stood.value_or(now.stage)) << "the ball moved with the head";
        stood = now.stage;
        const auto [left, right] = seen(frame);
        keep_picture("ball-" + std::to_string(head), left, right);
        const glm::dvec3 centre = to_room(now.stage, {1, 2, 3});
        const PixelSize size = frame.targets[0].size;
        const glm::dvec2 left_foretold = foretold(frame.eyes[0], centre, size),
                         right_foretold = foretold(frame.eyes[1], centre, size);
        const glm::dvec2 in_left = middle_of_covered(left, left_foretold),
                         in_right = middle_of_covered(right, right_foretold);
        const double disparity = in_left.x - in_right.x, predicted = left_foretold.x - right_foretold.x;
        worst = std::max({worst, std::abs(disparity - predicted),
                          std::abs((in_left.y - in_right.y) - (left_foretold.y - right_foretold.y))});
        widest = std::max(widest, std::abs(disparity));
        EXPECT_LT(glm::length(in_left - left_foretold), 2.0)
            << "pose " << head;  // a ball near the edge is no circle, so that its middle is not quite its centre's
        places.push_back(in_left);
        ++compared;
        return true;
      });
  EXPECT_TRUE(well) << viewer->state().trouble;
  EXPECT_EQ(compared, 4);
  EXPECT_LT(worst, 1.0);
  EXPECT_GT(widest, 8.0);
  for (std::size_t i = 1; i < places.size(); ++i)
    EXPECT_GT(glm::length(places[i] - places[0]), 5.0) << "the picture does not follow the head";
  std::printf("measured: disparity up to %.1f pixels, off the prediction by %.2f at most\n", widest, worst);
}

/// Aims at what it is told, when Monado's controllers aim along -z of their pose, tilted as the runtime has it.
void aim(RemoteBody::Hand& hand, const HandInput& reported, const glm::dvec3& at) {
  // Turns the told pose by what is missing between where the runtime says it aims and where it should.
  const glm::dvec3 now = reported.aim.ahead(), wanted = glm::normalize(at - reported.aim.position);
  const glm::dvec3 axis = glm::cross(now, wanted);
  if (glm::length(axis) < 1e-6) return;
  const double angle = std::atan2(glm::length(axis), glm::dot(now, wanted));
  hand.pose.turn = glm::normalize(glm::angleAxis(angle, glm::normalize(axis)) * hand.pose.turn);
}

TEST_F(VisitTest, AScriptedTriggerEntersThePulpAndMenuLeadsOut) {
  RemoteBody body;
  body.left.there = false;
  int step = 0, frames_here = 0, most_frames_here = 400;
  double least_wall = 1e9, moved = 0;
  glm::dvec3 entered_at(0);
  std::vector<FlightSpace> cavities;
  HeadsetVisitOptions options;
  options.headset.layers = {validation_layer};
  options.headset.resolution = 1.5;  // Monado's pictures are small unless asked for larger ones
  report_validation_to("/tmp/visit.txt");
  const auto next = [&] {
    ++step;
    frames_here = 0;
    return true;
  };
  const bool well = visit(
      [&] {
        LoadedModel loaded = loaded_from(small_molar(), "Small molar");
        loaded.flight = std::make_shared<const FlightSpaces>(flight_spaces(small_molar_surfaces(), loaded.model));
        cavities = loaded.flight->cavities;
        return loaded;
      },
      [&](const HeadsetFrame& frame, const Visit& now) {
        if (!frame.input.focused) return true;
        if (++frames_here > most_frames_here) return false;  // stuck; the expectations below say where
        monado->say(body);
        const HandInput& hand = frame.input.hands[1];
        switch (step) {
          case 0: {  // look at the tooth, take its picture
            if (frames_here < 20 || !frame.draw) return true;
            body.right.pose.position = frame.input.head.position;
            const auto [left, right] = seen(frame);
            keep_picture("outside", left, right);
            EXPECT_TRUE(content_of(left).shows_something());
            EXPECT_NE(left, right);
            return next();
          }
          case 1:  // point at the pulp's roomiest place until the ray meets it
            if (frames_here % 10 != 0 || !hand.tracked || cavities.empty()) return true;
            if (now.hands.pointed[1] && now.hands.pointed[1]->structure == "pulp") {
              const auto [left, right] = seen(frame);
              keep_picture("pointing", left, right);
              body.right.trigger = 1;
              return next();
            }
            aim(body.right, hand, to_room(now.stage, cavities[0].middle));
            return true;
          case 2:  // the fade, then inside
            if (!now.cavity || now.seen.dark > 0) return true;
            body.right.trigger = 0;
            entered_at = now.eye_mm;
            if (frame.draw && frames_here > 60) {
              const auto [left, right] = seen(frame);
              keep_picture("inside", left, right);
              EXPECT_TRUE(content_of(left).shows_something());
              return next();
            }
            return true;
          case 3:  // glide down, towards the canals
            aim(body.right, hand, frame.input.head.position + glm::dvec3(0.15, -3, 0));
            body.right.trigger = 1;
            least_wall = std::min(least_wall, cavities[0].walls.nearest(now.eye_mm).distance / mm_per_metre(now.stage));
            moved = std::max(moved, glm::length(now.eye_mm - entered_at) / mm_per_metre(now.stage));
            if (frames_here < 150 || !frame.draw) return true;
            {
              const auto [left, right] = seen(frame);
              keep_picture("deep-inside", left, right);
            }
            body.right.trigger = 0;
            body.right.b = true;
            return next();
          default:
            return now.cavity.has_value();
        }
      },
      options);
  EXPECT_TRUE(well) << viewer->state().trouble;
  EXPECT_EQ(step, 4);
  expect_silent_validation("/tmp/visit.txt");
  EXPECT_GT(moved, 0.3);
  EXPECT_GE(least_wall, ComfortRules{}.clearance * (1 - 1e-6));
  std::printf("measured: glided %.2f m in the room, never nearer than %.3f m to a wall\n", moved, least_wall);
  expect_the_desktop_goes_on();
  EXPECT_EQ(viewer->state().trouble, "");
}

/// Where a control of the panel is, as PanelPlace counts: found on a sheet of the test's own, which looks the same.
std::optional<glm::dvec2> control_on(const Gl& gl, Visit visit, const HeadsetPage page, const VisitWorld& world,
                                     const std::string& title, const std::vector<std::string>& ids) {
  HeadsetTexture sheet(gl, ShaderLibrary{}, page);
  for (int i = 0; i < 3; ++i) sheet.update(visit, {}, world, {title, false, ""}, 1);
  ImGuiID id = ImHashStr("room panel");
  for (const std::string& part : ids) id = ImHashStr(part.c_str(), 0, id);
  for (const Interface::Place& place : sheet.interface().places)
    if (place.id == id)
      return HeadsetTexture::on_panel(0.5 * (place.left + place.right), 0.5 * (place.top + place.bottom));
  return std::nullopt;
}

TEST_F(VisitTest, APanelInTheRoomIsOperatedByARayOutsideAndOnATour) {
  RemoteBody body;
  body.left.there = false;
  body.head.turn = glm::angleAxis(-0.3, glm::dvec3(0, 1, 0));  // towards the panel, so that the picture has all of it
  const std::string title = "Small molar";
  std::vector<FlightSpace> cavities;
  const Model& model = small_molar();
  const Pickable pickable(model);
  const Scene scene = usual_scene(model, 1);
  struct Click {
    HeadsetPage page;
    std::vector<std::string> ids;
    std::function<bool(const Visit&)> done;
    std::string picture;
  };
  std::vector<Click> clicks;
  std::size_t step = 0;
  int frames_here = 0, waited = 0;
  std::optional<glm::dvec2> wanted;
  HeadsetVisitOptions options;
  options.headset.layers = {validation_layer};
  options.headset.resolution = 2.2;  // for letters
  report_validation_to("/tmp/panel.txt");
  const bool well = visit(
      [&] {
        LoadedModel loaded = loaded_from(small_molar(), title);
        loaded.flight = std::make_shared<const FlightSpaces>(flight_spaces(small_molar_surfaces(), loaded.model));
        cavities = loaded.flight->cavities;
        const CentreLine& line = *rideable(cavities[0].lines)[0];
        char words[80];
        std::snprintf(words, sizeof words, "%s   %.1f mm", line.name.c_str(), line.length_to_wall());
        clicks = {{HeadsetPage::tooth,
                   {"Cut it open"},
                   [](const Visit& now) { return now.scene.section.has_value(); },
                   "panel-outside"},
                  {HeadsetPage::tooth, {"page", "Canals"}, [](const Visit&) { return true; }, ""},
                  {HeadsetPage::canals,
                   {words},
                   [](const Visit& now) { return now.tour.ride && now.seen.dark == 0; },
                   "panel-on-tour"},
                  {HeadsetPage::canals,
                   {"Out again"},
                   [](const Visit& now) { return !now.cavity && now.seen.dark == 0; },
                   ""}};
        return loaded;
      },
      [&](const HeadsetFrame& frame, const Visit& now) {
        if (!frame.input.focused) return true;
        monado->say(body);
        if (step == clicks.size() || ++frames_here > 150) return false;
        const Click& click = clicks[step];
        const HandInput& hand = frame.input.hands[1];
        if (!hand.tracked || !now.panel || frames_here < 6) return true;
        if (body.right.trigger == 0 && waited == 0) {  // aim, until the ray is there
          if (frames_here % 6 != 0) return true;
          if (!wanted) wanted = control_on(gl(), now, click.page, {model, pickable, scene, cavities}, title, click.ids);
          if (!wanted) return false;
          if (now.hands.on_panel[1] && glm::length(now.hands.on_panel[1]->at - *wanted) < 0.012)
            body.right.trigger = 1;
          else
            aim(body.right, hand, place_of(*now.panel, *wanted));
          return true;
        }
        if (++waited == 4) body.right.trigger = 0;
        const int rest = click.picture.empty() ? 8 : 30;
        if (waited < rest || !click.done(now) || (!click.picture.empty() && !frame.draw)) return true;
        if (!click.picture.empty()) {
          const auto [left, right] = seen(frame);
          keep_picture(click.picture, left, right);
          EXPECT_NE(left, right);
        }
        ++step;
        frames_here = waited = 0;
        wanted.reset();
        return true;
      },
      options);
  EXPECT_TRUE(well) << viewer->state().trouble;
  EXPECT_EQ(step, 4u);
  expect_silent_validation("/tmp/panel.txt");
  EXPECT_EQ(viewer->state().trouble, "");
  expect_the_desktop_goes_on();
}

TEST_F(VisitTest, ServiceKilledIsToldAndTheDesktopGoesOn) {
  int frames = 0;
  const bool well = visit([] { return loaded_from(small_molar(), "Small molar"); },
                          [&](const HeadsetFrame& frame, const Visit&) {
                            if (frame.input.focused && ++frames == 10) monado->kill();
                            return frames < 500;
                          });
  EXPECT_FALSE(well);
  EXPECT_NE(viewer->state().trouble.find("[headset-lost]"), std::string::npos) << viewer->state().trouble;
  expect_the_desktop_goes_on();
}

TEST_F(VisitTest, WithoutAServiceTheDesktopGoesOn) {
  monado.reset();
  EXPECT_FALSE(visit([] { return loaded_from(small_molar(), "Small molar"); },
                     [](const HeadsetFrame&, const Visit&) { return false; }));
  EXPECT_NE(viewer->state().trouble.find("[openxr-service-absent]"), std::string::npos) << viewer->state().trouble;
  expect_the_desktop_goes_on();
}

}  // namespace
}  // namespace odontoscope::testing_support
