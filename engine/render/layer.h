#pragma once
// One layer of the picture: at every sample the light, ambient light and depth of one surface.

#include "engine/gpu/framebuffer.h"

namespace odontoscope {

class Layer {
 public:
  Layer() = default;
  Layer(const Gl& gl, PixelSize size);

  /// Empty, and drawn into from now on.
  void begin() const;
  void bind_light(int unit) const { pixels_.bind_colour(0, unit); }
  void bind_ambient(int unit) const { pixels_.bind_colour(1, unit); }
  /// Window depth as the fragments computed it, so that a later pass can compare exactly; 1 where there is nothing.
  void bind_depth(int unit) const { pixels_.bind_colour(2, unit); }
  GLuint depth() const { return pixels_.colour(2); }

 private:
  const Gl* gl_ = nullptr;
  Framebuffer pixels_;
};

}  // namespace odontoscope
