#pragma once
// Draws flat things that stand in the room over the picture of an eye: panels and labels from one sheet, and hands'
// rays. They hide what is behind and what is before them, since the eyes' pictures keep no depth: who places them sees
// to it that little is before them.

#include <glm/vec4.hpp>
#include <span>

#include "engine/gpu/program.h"
#include "engine/headset/pose.h"
#include "engine/render/resolve_pass.h"

namespace odontoscope {

/// A part of the sheet, in pixels from its upper left corner, as a rectangle in the room; its middle is at `pose`, +x
/// to the right, +z towards who reads it.
struct SheetPiece {
  Pose pose;
  glm::dvec2 size{0};  // metres
  double left = 0, top = 0, width = 0, height = 0;
};

/// A line as wide from every side.
struct Beam {
  glm::dvec3 from{0}, to{0};
  double width = 0.003;  // metres
  glm::vec4 colour{1};   // sRGB, opacity
};

class BillboardPass {
 public:
  BillboardPass(const Gl& gl, const ShaderLibrary& shaders);
  /// Over what `target` shows, with `light` of its brightness. `sheet`: its first colours, premultiplied; they are
  /// filtered from now on.
  void draw(const Framebuffer& sheet, std::span<const SheetPiece> pieces, std::span<const Beam> beams,
            const EyeView& eye, const Target& target, double light = 1) const;

 private:
  const Gl* gl_;
  Program program_;
  GlObject no_vertices_;
};

}  // namespace odontoscope
