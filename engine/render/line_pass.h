#pragma once
// The overlay's lines: of one width in pixels wherever they are, lifted off the surface that they lie on, with a dark
// rim where the ground may have any colour. What a surface hides shines through faintly.

#include "engine/gpu/program.h"
#include "engine/render/frame_plan.h"
#include "engine/render/layer.h"

namespace odontoscope {

/// sRGB; for legends.
Colour colour_of(LineKind kind);

class LinePass {
 public:
  LinePass(const Gl& gl, const ShaderLibrary& shaders);

  /// The visible lines, into the layer that is bound.
  void draw(const FramePlan& plan) const;

  /// Empties `layer` and draws there, faintly, what lies behind `opaque`. Kinds that would only clutter the picture are
  /// left out.
  void draw_hidden(const FramePlan& plan, const Layer& opaque, const Layer& layer) const;

 private:
  enum class Lines { visible, hidden };
  void draw(const FramePlan& plan, const Program& program, Lines lines) const;

  const Gl* gl_;
  Program visible_, hidden_;
};

}  // namespace odontoscope
