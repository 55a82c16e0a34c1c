// DT and DB in the headset: made when asked for, shown in place of each other.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "engine/gpu/context.h"
#include "engine/headset/eye_painter.h"
#include "engine/headset_viewer/headset_comparison.h"
#include "engine/view/offscreen.h"
#include "tests/headset/worlds.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

std::shared_ptr<const LoadedModel> loaded_molar(bool with_contours = true) {
  auto loaded = std::make_shared<LoadedModel>();
  loaded->model = small_molar();
  if (with_contours) loaded->overlays.contours = small_molar_overlays().contours;
  loaded->scene = usual_scene(loaded->model, 1);
  return loaded;
}

ComparisonState coarse() {
  ComparisonState compared;
  compared.wanted.grid = 24;
  return compared;
}

TEST(HeadsetComparison, MakesDbWhenItIsFirstWantedAndKeepsIt) {
  HeadsetComparison compared(loaded_molar(), coarse());
  EXPECT_TRUE(compared.possible());
  compared.update(false);
  EXPECT_EQ(compared.in_words(), "");  // nobody asked
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  compared.update(true);
  EXPECT_FALSE(compared.made());
  EXPECT_EQ(compared.in_words().rfind("Making DB", 0), 0u);
  while (!compared.made() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    compared.update(false);  // looked away meanwhile
  }
  ASSERT_TRUE(compared.made());
  EXPECT_EQ(compared.made()->options.grid, 24u);
  EXPECT_GT(compared.made()->cracks() + compared.made()->misoriented(), 0u);  // what the mode is there to show
  EXPECT_NE(compared.in_words().find("grid of 24"), std::string::npos) << compared.in_words();
  const auto made = compared.made();
  compared.update(true);
  EXPECT_EQ(compared.made(), made);

  // Both models in the same place, and the eyes see another one.
  std::unique_ptr<GlContext> context;
  try {
    context = make_context({});
  } catch (const GraphicsError& error) {
    GTEST_SKIP() << error.what();
  }
  const MolarWorld& molar = MolarWorld::once();
  const VisitWorld dt = molar.world(), db{made->model, *made->pickable, molar.scene, molar.cavities};
  HeadsetInput input = person();
  input.hands = {};
  Visit visit = advance_visit({}, input, dt, {}, 0.01);
  visit.pending_actions = {VisitAction::show_db};
  visit = advance_visit(visit, input, dt, {}, 0.01);
  EXPECT_TRUE(visit.chosen.db);
  EXPECT_EQ(visit.scene.back_faces, BackFaces::cull);
  for (const Look& look : visit.scene.looks) EXPECT_EQ(look.opacity, 1) << look.structure;
  constexpr PixelSize size{200, 180};
  const Framebuffer pixels(context->gl(), {size, {GL_SRGB8_ALPHA8}, GL_DEPTH_COMPONENT32F});
  EyePainter painter(context->gl(), ShaderLibrary{}, dt.model);
  const auto seen = [&](const VisitWorld& world) {
    const Target target{pixels.id(), 0, 0, size, true};
    painter.draw(visit, input, world, std::vector<EyeView>{eyes_of(input.head)[0]}, {&target, 1});
    return read_pixels(context->gl(), pixels.id(), size);
  };
  const Image with_dt = seen(dt);
  painter.take(made->model);
  const Image with_db = seen(db);
  std::size_t differ = 0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) differ += with_dt.pixel(x, y) != with_db.pixel(x, y) ? 1u : 0u;
  EXPECT_GT(differ, 100u);
  EXPECT_LT(differ, static_cast<std::size_t>(size.width * size.height) / 4);  // the same tooth
  painter.take(dt.model);
  EXPECT_EQ(seen(dt), with_dt);
  visit.pending_actions = {VisitAction::show_dt};
  EXPECT_FALSE(advance_visit(visit, input, db, {}, 0.01).chosen.db);
}

TEST(HeadsetComparison, WithoutContoursThereIsNoDb) {
  HeadsetComparison compared(loaded_molar(false), {});
  EXPECT_FALSE(compared.possible());
  compared.update(true);
  EXPECT_EQ(compared.in_words(), "");
}

TEST(HeadsetComparison, WhatTheDesktopMadeIsTaken) {
  ComparisonState state;
  auto result = std::make_shared<ComparisonResult>();
  result->options.grid = 40;
  state.made = result;
  HeadsetComparison compared(loaded_molar(), state);
  EXPECT_EQ(compared.made(), result);
}

}  // namespace
}  // namespace odontoscope::testing_support
