#pragma once
// Closes what the section plane opened, so that a solid looks solid.
//
// Behind every point of the plane the surface that is left is counted: a back face adds one, a front face takes one
// away. What remains is how often the solid goes round the point, exactly, since the rasteriser draws each shared edge
// once. No triangulation of the section is needed, and moving the plane costs nothing. Structures that are not closed
// get caps with gaps or streaks.
//
// A cap shows its solid's colour, with a grain or plain, lit like any surface, or the grey values of a volume, which
// neither light nor occlusion changes.

#include "engine/gpu/program.h"
#include "engine/render/frame_plan.h"

namespace odontoscope {

class CapPass {
 public:
  CapPass(const Gl& gl, const ShaderLibrary& shaders);

  /// Into the layer that is bound, whose stencil is 0 and stays so.
  void draw(const FramePlan& plan) const;

 private:
  void count(const FramePlan& plan, const CappedSolid& solid) const;
  void cover(const FramePlan& plan, const CappedSolid& solid) const;
  void set_material(const Program& program, const FramePlan& plan, const CappedSolid& solid) const;
  void set_values(const FramePlan& plan) const;

  const Gl* gl_;
  Program count_, cover_, cover_plain_, cover_values_;
  GlObject no_vertices_;
};

}  // namespace odontoscope
