#pragma once
// Figures as pictures.

#include <functional>
#include <string>
#include <vector>

#include "engine/figures/figure.h"
#include "engine/gpu/context.h"
#include "engine/gpu/shader_library.h"
#include "engine/picture/image.h"
#include "engine/render/renderer.h"

namespace odontoscope::figures {

/// "figure-07c.png"; without a letter if there is but one panel.
std::string picture_name(const Figure& figure, std::size_t panel);

/// The picture's size when its longer side has this many pixels.
PixelSize panel_size(const Figure& figure, int longer_side);

/// One for each panel, in order. The context is current. Throws GraphicsError.
std::vector<Image> draw(const Gl& gl, Renderer& renderer, const Figure& figure, int longer_side,
                        const RenderOptions& options = {});

/// Side by side, a gap of white between. Precondition: equal heights, at least one.
Image side_by_side(const std::vector<Image>& images);

}  // namespace odontoscope::figures
