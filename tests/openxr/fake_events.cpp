// In the library and in the test.
#include "tests/openxr/fake_runtime.h"

namespace odontoscope::testing_support {

void FakeRuntime::tell(XrSessionState next) {
  XrEventDataBuffer buffer{XR_TYPE_EVENT_DATA_BUFFER};
  auto& event = reinterpret_cast<XrEventDataSessionStateChanged&>(buffer);
  event.type = XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED;
  event.state = next;
  events.push_back(buffer);
}

void FakeRuntime::tell_lost_instance() { events.push_back({XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING}); }

void FakeRuntime::tell_recentred(XrReferenceSpaceType type) {
  XrEventDataBuffer buffer{XR_TYPE_EVENT_DATA_BUFFER};
  auto& event = reinterpret_cast<XrEventDataReferenceSpaceChangePending&>(buffer);
  event.type = XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING;
  event.referenceSpaceType = type;
  event.changeTime = time;
  events.push_back(buffer);
}

}  // namespace odontoscope::testing_support
