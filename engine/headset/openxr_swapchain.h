#pragma once
// The pictures of one eye that the runtime takes turns with. Private to this room.

#include <openxr/openxr.h>

#include <vector>

#include "engine/gpu/gl_object.h"
#include "engine/headset/openxr_calls.h"
#include "engine/render/resolve_pass.h"

namespace odontoscope {

/// sRGB of 8 bits a channel, which the renderer encodes itself; the best that the runtime offers. Throws HeadsetError "headset-graphics" if it has none.
std::int64_t swapchain_format(XrSession session);

class EyePictures {
 public:
  EyePictures(const Gl& gl, XrSession session, std::int64_t format, PixelSize size);

  /// Waits until the runtime has read the next picture, and lends it to be drawn into.
  Target acquire();
  /// Gives it back. Nothing if none is lent.
  void release();
  XrSwapchainSubImage shown() const;

 private:
  const Gl* gl_;
  PixelSize size_;
  OwnedSwapchain swapchain_;
  std::vector<GlObject> framebuffers_;   // one an image
  GlObject depth_;
  bool lent_ = false;
};

}  // namespace odontoscope
