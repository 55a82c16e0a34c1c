#include "engine/headset/openxr_calls.h"

#include <fmt/format.h>
#include <openxr/openxr_reflection.h>

#include "engine/headset/headset.h"

namespace odontoscope {

std::string words_of(XrResult result) {
  switch (result) {
#define ODONTOSCOPE_NAME_OF(name, value) \
  case name:                             \
    return fmt::format("{} ({})", #name, static_cast<int>(value));
    XR_LIST_ENUM_XrResult(ODONTOSCOPE_NAME_OF)
#undef ODONTOSCOPE_NAME_OF
  }
  return fmt::format("result {}", static_cast<int>(result));
}

void check(XrResult result, const char* what) {
  if (result >= 0) return;
  const std::string said = words_of(result);
  switch (result) {
    case XR_ERROR_RUNTIME_UNAVAILABLE:
      throw HeadsetError("no-openxr-runtime", fmt::format("no OpenXR runtime is installed or chosen: {}", said),
                         "Install the headset's software (SteamVR, Monado, WiVRn) and make it the active OpenXR "
                         "runtime; docs/headset.md tells how.");
    case XR_ERROR_FORM_FACTOR_UNAVAILABLE:
    case XR_ERROR_FORM_FACTOR_UNSUPPORTED:
      throw HeadsetError("no-headset", fmt::format("the OpenXR runtime finds no headset: {}", said),
                         "Switch it on, connect it, and try again.");
    case XR_ERROR_INSTANCE_LOST:
    case XR_ERROR_SESSION_LOST:
      throw HeadsetError("headset-lost", fmt::format("the headset's runtime has gone while {}: {}", what, said),
                         "Start the runtime again, then enter the headset again.");
    default:
      throw HeadsetError("openxr-failed", fmt::format("the OpenXR runtime failed while {}: {}", what, said),
                         "Start the runtime again; its own window or log says more.");
  }
}

}  // namespace odontoscope
