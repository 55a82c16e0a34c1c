#pragma once
// The pictures of one eye that the runtime takes turns with. Private to this room.

#include <openxr/openxr.h>

#include <optional>
#include <vector>

#include "engine/gpu/gl_object.h"
#include "engine/headset/openxr_calls.h"
#include "engine/render/resolve_pass.h"

namespace odontoscope {

/// sRGB of 8 bits a channel, which the renderer encodes itself, and the finest depth that the runtime offers. Throws
/// HeadsetError "headset-graphics" if it has no such colours.
struct SwapchainFormats {
  std::int64_t colour = 0;
  std::int64_t depth = 0;  // 0: the runtime takes none
};
/// `with_depth`: it takes depths at all.
SwapchainFormats swapchain_formats(XrSession session, bool with_depth);

/// One kind of picture, of which one at a time is lent.
class Swapchain {
 public:
  Swapchain(XrSession session, std::int64_t format, PixelSize size, XrSwapchainUsageFlags usage);
  /// Waits until the runtime has read the next one. Which of `images` it is.
  std::size_t acquire();
  /// Gives it back. Nothing if none is lent.
  void release();
  const std::vector<unsigned>& images() const { return images_; }
  XrSwapchainSubImage shown() const { return {swapchain_.get(), {{0, 0}, {size_.width, size_.height}}, 0}; }

 private:
  PixelSize size_;
  OwnedSwapchain swapchain_;
  std::vector<unsigned> images_;
  bool lent_ = false;
};

class EyePictures {
 public:
  EyePictures(const Gl& gl, XrSession session, const SwapchainFormats& formats, PixelSize size);

  /// Waits until the runtime has read the next picture, and lends it to be drawn into.
  Target acquire();
  /// Gives it back. Nothing if none is lent.
  void release();
  XrSwapchainSubImage shown() const { return colours_.shown(); }
  /// Null if the runtime takes no depths.
  const Swapchain* depths() const { return depths_ ? &*depths_ : nullptr; }

 private:
  const Gl* gl_;
  PixelSize size_;
  Swapchain colours_;
  std::optional<Swapchain> depths_;
  std::vector<GlObject> framebuffers_;  // one a picture
  GlObject own_depth_;                  // where the runtime takes none
};

}  // namespace odontoscope
