#pragma once
// Surfaces in the colours of how they lie to the CT that they were made from: words, what is told, and the legend.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/shown_input.h"
#include "engine/picture/image.h"
#include "engine/scene/scene.h"

namespace odontoscope::app {

void add_colour_by_option(CLI::App& parser, std::string& words);

/// "distance", "distance=0.2", "slope", "slope=300". UsageError for anything else.
void refuse_senseless_colour_by(const std::string& words);

/// Marks the model (engine/scene/deviation.h), sets the scene's colours, makes the surfaces solid of which `opacities`
/// (of --opacity) say nothing, and tells distances. `words` may be empty: then only what the scene says. UsageError
/// where no surface was taken from a volume at a value.
void colour_by_data(const std::string& words, const std::vector<std::string>& opacities, Shown& shown, Scene& scene,
                    Session& session);

/// A bar of the colours with its numbers and unit, in the picture's lower left corner.
void draw_legend(const DataColours& colours, Image& image);

/// The same of walls that tell how thick they are, `own` being the colour of those that are thick.
void draw_thickness_legend(const Colour& own, const odontoscope::Model& model, Image& image);

}  // namespace odontoscope::app
