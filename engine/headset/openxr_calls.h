#pragma once
// OpenXR's results as errors in our words. Private to this room.

#include <openxr/openxr.h>

#include <string>

namespace odontoscope {

/// Throws HeadsetError for anything but success; `what` was being done, "waiting for the headset".
void check(XrResult result, const char* what);

/// "XR_ERROR_RUNTIME_FAILURE (-2)".
std::string words_of(XrResult result);

/// A handle of the runtime's, destroyed with its owner; what the runtime says to that is of no interest.
template <class Handle, XrResult(XRAPI_PTR* destroy)(Handle)>
class Owned {
 public:
  Owned() = default;
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  Owned(Owned&& other) noexcept : handle_(other.handle_) { other.handle_ = XR_NULL_HANDLE; }
  Owned& operator=(Owned&&) = delete;
  ~Owned() {
    if (handle_ != XR_NULL_HANDLE) destroy(handle_);
  }
  Handle get() const { return handle_; }
  Handle* fill() { return &handle_; }

 private:
  Handle handle_ = XR_NULL_HANDLE;
};

using OwnedInstance = Owned<XrInstance, xrDestroyInstance>;
using OwnedSession = Owned<XrSession, xrDestroySession>;
using OwnedSpace = Owned<XrSpace, xrDestroySpace>;
using OwnedSwapchain = Owned<XrSwapchain, xrDestroySwapchain>;
using OwnedActionSet = Owned<XrActionSet, xrDestroyActionSet>;

}  // namespace odontoscope
