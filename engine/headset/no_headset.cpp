// In place of the other files where OpenXR is left out (ODONTOSCOPE_XR=OFF).
#include "engine/headset/headset.h"

namespace odontoscope {

bool headsets_built_in() { return false; }

std::unique_ptr<Headset> open_headset(const Gl&, const HeadsetOptions&) {
  throw HeadsetError("headset-not-built", "this program was built without OpenXR",
                     "Install libopenxr-dev and build again with -DODONTOSCOPE_XR=ON.");
}

}  // namespace odontoscope
