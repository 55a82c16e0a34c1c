#pragma once
// The context that is current, as an OpenXR runtime wants to be told of it. Private to this room.

#include <openxr/openxr.h>

#include <memory>
#include <string>
#include <vector>

namespace odontoscope {

class CurrentGraphics {
 public:
  /// Looks at the calling thread's context, GLX or EGL. Throws HeadsetError "headset-graphics" if it is neither.
  CurrentGraphics();
  ~CurrentGraphics();

  std::vector<const char*> extensions() const;
  const char* words() const;  // "Xlib", "EGL"
  /// For XrSessionCreateInfo::next. Valid as long as this.
  const void* binding() const;

 private:
  struct Binding;
  std::unique_ptr<Binding> binding_;
};

/// OpenXR insists on being asked. Throws HeadsetError "headset-graphics" if the runtime wants a newer OpenGL than
/// `major`.`minor`.
void check_requirements(XrInstance instance, XrSystemId system, int major, int minor);

/// The OpenGL texture names of a swapchain's images.
std::vector<unsigned> images_of(XrSwapchain swapchain);

}  // namespace odontoscope
