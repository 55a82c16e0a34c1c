#include "tests/render/drawing.h"

namespace odontoscope::testing_support {

PerhapsContext try_context(Backend backend) {
  try {
    return {make_context({.backend = backend, .debug = true}), {}};
  } catch (const GraphicsError& error) {
    return {nullptr, error.what()};
  }
}

void DrawingTest::SetUp() {
  PerhapsContext made = try_context(Backend::automatic);
  if (!made.context) GTEST_SKIP() << "no picture can be drawn here: " << made.reason;
  context_ = std::move(made.context);
}

void DrawingTest::TearDown() {
  if (!context_) return;
  for (const std::string& message : context_->debug_messages()) ADD_FAILURE() << "OpenGL says: " << message;
  EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

Image DrawingTest::draw(const Model& model, const Scene& scene, PixelSize size, int side) {
  PictureOptions options;
  options.size = size;
  options.render.side = side;
  return picture_of(*context_, model, scene, options);
}

Scene plain_scene(const Model& model, double height_mm) {
  Scene scene = usual_scene(model, 1);
  scene.camera = {Camera::Projection::parallel, {0, 60, 0}, {0, 0, 0}, {0, 0, 1}, 24, height_mm};
  scene.occlusion.on = false;
  scene.background.kind = Background::Kind::transparent;
  return scene;
}

}  // namespace odontoscope::testing_support
