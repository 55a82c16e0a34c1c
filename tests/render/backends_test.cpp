// The same scene, the same pixels, whatever made the context: all of them draw in software here or are skipped.

#include "engine/picture/image_difference.h"
#include "tests/render/drawing.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

bool in_software(const GlContext& context) { return context.in_words().find("llvmpipe") != std::string::npos; }

void expect_equal_on_both(const Model& model, const Scene& scene) {
  const PerhapsContext egl = try_context(Backend::egl), osmesa = try_context(Backend::osmesa);
  if (!egl.context) GTEST_SKIP() << "EGL: " << egl.reason;
  if (!osmesa.context) GTEST_SKIP() << "OSMesa: " << osmesa.reason;
  if (!in_software(*egl.context) || !in_software(*osmesa.context))
    GTEST_SKIP() << "different processors draw: " << egl.context->in_words() << "; " << osmesa.context->in_words();
  const PictureOptions options{{240, 180}, {2}};
  const Image a = picture_of(*egl.context, model, scene, options),
              b = picture_of(*osmesa.context, model, scene, options);
  osmesa.context->make_current();
  EXPECT_TRUE(content_of(a).shows_something());
  const ImageDifference difference = compare(a, b, {0, 0});
  EXPECT_EQ(difference.pixels, 0u) << "the most by " << difference.largest;
  EXPECT_TRUE(egl.context->debug_messages().empty());
  EXPECT_TRUE(osmesa.context->debug_messages().empty());
}

TEST(Backends, AgreeOnATranslucentTooth) { expect_equal_on_both(small_molar(), usual_scene(small_molar(), 4.0 / 3)); }

TEST(Backends, AgreeOnASectionWithWires) {
  Scene scene = usual_scene(small_molar(), 4.0 / 3);
  scene.section = Section{{0, 0, 10}, {0.2, 1, 0.1}};
  scene.wire = true;
  for (Look& look : scene.looks) look.opacity = 1;
  expect_equal_on_both(small_molar(), scene);
}

TEST(Backends, AgreeOnTintedBackFaces) {
  const Model model = make_model({{"inside-out", reversed(ring({}))}, {"ball", ball({{}, 2})}});
  Scene scene = usual_scene(model, 4.0 / 3);
  scene.back_faces = BackFaces::tint;
  scene.camera.projection = Camera::Projection::parallel;
  expect_equal_on_both(model, scene);
}

}  // namespace
}  // namespace odontoscope::testing_support
