#include "tests/ui/driver.h"

#include <imgui_internal.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "engine/navigate/thickness_colours.h"
#include "engine/navigate/wall_depth.h"
#include "engine/picture/png.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {

LoadedModel toy_tooth() {
  LoadedModel loaded;
  loaded.title = "Toy tooth";
  const std::vector<NamedSurface> surfaces = {
      {"enamel", ball({{0, 0, 4}, 6})}, {"dentine", ball({{0, 0, 1}, 5})}, {"pulp", ball({{0.5, 0, 1}, 2})}};
  loaded.model = make_model(surfaces);
  loaded.overlays.faulty_edges = faulty_edges(surfaces, loaded.model);
  loaded.scene = usual_scene(loaded.model, 1.2);
  loaded.scene.occlusion.on = false;
  FlightSpaces spaces = flight_spaces(surfaces, loaded.model);
  mark_wall_depths(loaded.model, spaces);
  mark_wall_thicknesses(loaded.model, spaces);
  loaded.flight = std::make_shared<const FlightSpaces>(std::move(spaces));
  loaded.pickable = std::make_shared<const Pickable>(loaded.model);
  loaded.certificate = {Certificate::Verdict::certified,
                        "Certified: closed, manifold, facing outwards",
                        {{Certificate::Mark::good, "Each of its tetrahedra has positive volume."}}};
  for (const ModelPart& part : loaded.model.parts) loaded.triangles += part.indices.size() / 3;
  return loaded;
}

void ViewerTest::SetUp() {
  try {
    context_ = make_context({.debug = true});
  } catch (const GraphicsError& error) {
    GTEST_SKIP() << "nothing can be drawn here: " << error.what();
  }
}

void ViewerTest::TearDown() {
  if (!context_) return;
  for (const std::string& message : context_->debug_messages()) ADD_FAILURE() << "OpenGL says: " << message;
  EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
  viewer_.reset();
  pixels_ = {};
}

Viewer& ViewerTest::make_viewer(ViewerOptions options) {
  if (!options.load) options.load = [](const LoadRequest&, const Progress&) { return toy_tooth(); };
  options.coarse_when_slow = false;
  options.side = 1;
  if (!first_run_) options.settings.hints = false;
  viewer_.reset();
  viewer_ = std::make_unique<Viewer>(gl(), ShaderLibrary{}, std::move(options));
  return *viewer_;
}

Viewer& ViewerTest::viewer_with_tooth(ViewerOptions options) {
  make_viewer(std::move(options)).open({});
  wait_until_loaded();
  return *viewer_;
}

void ViewerTest::frame(double seconds) {
  if (!(pixels_.size() == size_)) pixels_ = Framebuffer(gl(), {size_, {GL_RGBA8}});
  viewer_->draw({size_, scale_, seconds}, {pixels_.id(), 0, 0, size_});
}

void ViewerTest::frames(int count, double seconds) {
  for (int i = 0; i < count; ++i) frame(seconds);
}

void ViewerTest::wait_until_loaded() {
  for (int i = 0; i < 3000 && viewer_->loading(); ++i) {
    frame(0);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ASSERT_FALSE(viewer_->loading());
  frames(3);
}

void ViewerTest::move(double x, double y) {
  viewer_->handle(MouseMoved{x, y});
  frame();
}

void ViewerTest::press(MouseButton button, Modifiers with) {
  viewer_->handle(MouseButtonChanged{button, true, with});
  frame();
}

void ViewerTest::release(MouseButton button) {
  viewer_->handle(MouseButtonChanged{button, false});
  frame();
}

void ViewerTest::click(double x, double y) {
  move(x, y);
  press();
  release();
  frame();
}

void ViewerTest::drag(double x, double y, double to_x, double to_y, MouseButton button, Modifiers with) {
  move(x, y);
  press(button, with);
  constexpr int steps = 4;
  for (int i = 1; i <= steps; ++i) move(x + (to_x - x) * i / steps, y + (to_y - y) * i / steps);
  release(button);
  frame();
}

void ViewerTest::scroll(double x, double y, double notches) {
  move(x, y);
  viewer_->handle(Scrolled{0, notches, {}});
  frame();
}

void ViewerTest::type(char32_t character) {
  viewer_->handle(TextTyped{character});
  frames(2);
}

void ViewerTest::press_key(Key key, Modifiers with) {
  viewer_->handle(KeyChanged{key, true, with});
  frame();
  viewer_->handle(KeyChanged{key, false, {}});
  frames(2);
}

unsigned ViewerTest::control_id(const std::string& label, const std::vector<std::string>& inside,
                                const std::string& window) {
  ImGuiID id = ImHashStr(window.c_str());
  for (const std::string& part : inside) id = ImHashStr(part.c_str(), 0, id);
  return label.empty() ? id : ImHashStr(label.c_str(), 0, id);
}

glm::dvec2 ViewerTest::control(const std::string& label, const std::vector<std::string>& inside,
                               const std::string& window) {
  const ImGuiID id = control_id(label, inside, window);
  for (const Interface::Place& place : viewer_->interface().places)
    if (place.id == id) return {0.96 * place.right + 0.04 * place.left, 0.5 * (place.top + place.bottom)};
  ADD_FAILURE() << "there is no control " << label;
  return {0, 0};
}

void ViewerTest::click_control(const std::string& label, const std::vector<std::string>& inside,
                               const std::string& window) {
  glm::dvec2 place = control(label, inside, window);
  for (int turns = 0; turns < 30 && place.y > static_cast<double>(size_.height) - 12;
       ++turns) {  // below what the panel shows
    scroll(place.x, size_.height / 2.0, -1);
    place = control(label, inside, window);
  }
  click(place.x, place.y);
}

Image ViewerTest::picture() { return read_pixels(gl(), pixels_.id(), size_); }

void ViewerTest::keep_picture(const std::string& name) {
  const std::filesystem::path folder = ODONTOSCOPE_UI_PICTURES;
  std::filesystem::create_directories(folder);
  write_png(picture(), (folder / (name + ".png")).string());
}

ScratchFolder::ScratchFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "odontoscope-ui-XXXXXX").string();
  if (!::mkdtemp(pattern.data())) throw std::runtime_error("no scratch folder");
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

}  // namespace odontoscope::testing_support
