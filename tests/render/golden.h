#pragma once
// Stored pictures: tests/goldens/NAME.json is the scene, NAME.png what it must look like.
//
// A scene file says what differs from the usual scene of the model. To accept new pictures, after looking at them, run
// the test with ODONTOSCOPE_ACCEPT_GOLDENS=1. A failed comparison leaves NAME.png, NAME-difference.png and NAME.txt in
// the build's folder tests/render/failed.

#include <functional>
#include <string>
#include <vector>

#include "engine/picture/image_difference.h"
#include "engine/scene/scene.h"
#include "engine/view/offscreen.h"

namespace odontoscope::testing_support {

struct GoldenCase {
  const char* name;
  std::function<std::vector<NamedSurface>()> surfaces;
  std::function<OverlaySource()> overlays = {};  // none; faulty edges are found in the surfaces
};
const std::vector<GoldenCase>& golden_cases();

/// Something that must not go unnoticed, done before drawing.
struct Mutation {
  std::function<void(std::vector<NamedSurface>&, const Scene&)> surfaces;
  std::function<void(Model&)> model;
  std::function<void(Scene&)> scene;
  struct Edit {
    std::string shader, from, to;
  };
  std::vector<Edit> shaders;
};

Image draw_golden(GlContext& context, const GoldenCase& golden, const Mutation& mutation = {});

std::string golden_file(const GoldenCase& golden, const char* ending);

/// What the same program draws on other processors, doubled (see ImageTolerance).
inline constexpr ImageTolerance golden_tolerance{2, 0.01};

}  // namespace odontoscope::testing_support
