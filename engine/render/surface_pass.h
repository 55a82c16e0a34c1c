#pragma once
// The structures' surfaces, lit: the opaque ones, or one layer of the translucent ones.

#include "engine/gpu/program.h"
#include "engine/render/frame_plan.h"
#include "engine/render/layer.h"

namespace odontoscope {

class SurfacePass {
 public:
  SurfacePass(const Gl& gl, const ShaderLibrary& shaders);

  /// Into the layer that is bound.
  void draw_opaque(const FramePlan& plan) const;

  /// The opaque ones as the finished picture shows them where nothing darkens or covers them, into the framebuffer that
  /// is bound. Precondition: none is drawn with its edges.
  void draw_finished(const FramePlan& plan) const;

  /// Empties `layer` and draws the nearest translucent surface behind `before` (null: behind the eye) and in front of
  /// `opaque` (depth peeling: Everitt, "Interactive order-independent transparency", NVIDIA 2001). Surfaces at exactly
  /// equal depth become one layer, the first structure's. Whether there was any left `any_drawn` knows, a query of
  /// make_query: to ask it at once is to wait for the drawing.
  void peel(const FramePlan& plan, const Layer& opaque, const Layer* before, const Layer& layer,
            const GlObject& any_drawn) const;

 private:
  /// Those parts that are drawn with their edges, or those that are not.
  enum class Edges { none, drawn };
  void draw(const FramePlan& plan, const std::vector<DrawnPart>& parts, const Program& program, Edges edges) const;

  const Gl* gl_;
  Program finished_, opaque_, opaque_wire_, peel_, peel_wire_;
};

GlObject make_query(const Gl& gl);
/// Waits until it is known.
bool any_drawn(const Gl& gl, const GlObject& query);

/// The rasteriser's culling for a way to treat back faces.
void set_culling(const Gl& gl, BackFaces back_faces);

}  // namespace odontoscope
