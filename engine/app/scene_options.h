#pragma once
// The options that tell a scene.

#include <CLI/CLI.hpp>

#include "engine/app/scene_words.h"

namespace odontoscope::app {

void add_scene_options(CLI::App& parser, SceneWords& words);

}  // namespace odontoscope::app
