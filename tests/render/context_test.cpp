// Contexts as values, and what is said when there is none.

#include "engine/gpu/program.h"
#include "tests/render/drawing.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

using Contexts = DrawingTest;

TEST_F(Contexts, SayWhatTheyAre) {
  EXPECT_NE(context().in_words().find("OpenGL 4."), std::string::npos) << context().in_words();
  EXPECT_NE(context().backend(), Backend::automatic);
}

TEST_F(Contexts, LiveSideBySideAndTakeTurns) {
  const PerhapsContext other = try_context(context().backend());
  ASSERT_TRUE(other.context) << other.reason;
  const Model model = make_model({{"ball", ball({{}, 5})}});
  const Scene scene = usual_scene(model, 4.0 / 3);
  const Image here = draw(model, scene);
  const Image there = picture_of(*other.context, model, scene, {{160, 120}, {1}});
  EXPECT_EQ(here, there);
  EXPECT_EQ(draw(model, scene), here);
}

TEST_F(Contexts, ReportTheDriversComplaints) {
  const PerhapsContext made = try_context(context().backend());
  made.context->make_current();
  if (!made.context->gl().KHR_debug) GTEST_SKIP() << "this driver has no KHR_debug";
  made.context->gl().Enable(GL_TEXTURE_2D_ARRAY);  // no such capability
  EXPECT_FALSE(made.context->debug_messages().empty());
  context().make_current();
}

TEST_F(Contexts, AShaderThatFailsShowsItsNumberedSource) {
  const PerhapsContext other = try_context(context().backend());  // it will report the failure, as it should
  const ShaderLibrary shaders;
  try {
    const Program program(other.context->gl(), shaders,
                          {"fullscreen.vert", "fullscreen.vert", {}, {"gl_Position gl_Nothing"}});
    FAIL() << "that must not link or compile";
  } catch (const InternalError& error) {
    const std::string words = error.what();
    EXPECT_NE(words.find("fullscreen.vert does not compile"), std::string::npos) << words;
    EXPECT_NE(words.find("   1 #version 410 core"), std::string::npos) << words;
    EXPECT_NE(words.find("gl_Nothing"), std::string::npos) << words;
  }
  context().make_current();
}

TEST_F(Contexts, AnUnknownShaderIsNamed) {
  EXPECT_THROW(ShaderLibrary{}.source("no_such.frag"), InternalError);
  EXPECT_THROW(ShaderLibrary{"/no/such/folder"}.source("surface.frag"), FileError);
}

TEST_F(Contexts, APictureThatIsTooLargeIsRefusedInWords) {
  const Model model = make_model({{"ball", ball({{}, 5})}});
  Scene scene = usual_scene(model, 1);
  GLint most = 0;
  gl().GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  try {
    draw(model, scene, {most, 1}, 2);
    FAIL();
  } catch (const GraphicsError& error) {
    EXPECT_EQ(error.cause(), "picture-too-large") << error.what();
    EXPECT_EQ(error.exit_code(), ExitCode::graphics);
  }
}

TEST_F(Contexts, APictureThatWouldTakeTooMuchMemoryIsRefusedInWords) {
  EXPECT_NO_THROW(refuse_undrawable(gl(), {3840, 2160}, {2}));
  EXPECT_THROW(refuse_undrawable(gl(), {8192, 8192}, {1}), GraphicsError);
}

TEST(BackendNames, AreThoseOfTheCommandLine) {
  for (const Backend backend : {Backend::automatic, Backend::egl, Backend::osmesa})
    EXPECT_EQ(backend_named(name(backend)), backend);
  EXPECT_THROW(backend_named("directx"), UsageError);
}

}  // namespace
}  // namespace odontoscope::testing_support
