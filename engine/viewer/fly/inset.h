#pragma once
// The small picture of the tooth from outside, while one is in it.

#include <memory>

#include "engine/gpu/framebuffer.h"
#include "engine/render/resolve_pass.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

class Workspace;

/// Where it stands in the pane, and how the tooth is seen there; an empty area where the pane is too small for it.
Area inset_area(const ViewPane& pane, float scale);
Camera inset_camera(const Model& model, NamedView from, const Area& area);

/// Drawn once, and then shown.
class Inset {
 public:
  void draw(Workspace& at, NamedView from, const Target& target);

 private:
  Framebuffer picture_;
  std::shared_ptr<const LoadedModel> of_;
  NamedView from_ = NamedView::buccal;
};

}  // namespace odontoscope
