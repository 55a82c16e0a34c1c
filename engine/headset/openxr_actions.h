#pragma once
// The hands' buttons, sticks and poses. Private to this room.

#include <openxr/openxr.h>

#include <array>
#include <string>

#include "engine/headset/bindings.h"
#include "engine/headset/hands.h"
#include "engine/headset/openxr_calls.h"

namespace odontoscope {

Pose pose_of(const XrPosef& pose);
/// `where` in `base` at that time; nothing in `pose` changes and false is returned if it is not known.
bool locate(XrSpace where, XrSpace base, XrTime time, Pose& pose);

class HandActions {
 public:
  /// Offers every controller's bindings and attaches them: once a session, before the first frame.
  HandActions(XrInstance instance, XrSession session);

  /// Both hands as they will be at `time`. All at rest while the session has no focus.
  std::array<HandInput, 2> read(XrSpace room, XrTime time) const;
  /// Lets a hand feel something, if its controller can.
  void pulse(std::size_t hand, double strength, double seconds) const;
  /// In words, of the controllers that the runtime says are held.
  std::string controllers() const;

 private:
  XrAction action(HandAction which) const { return actions_[static_cast<std::size_t>(which)]; }
  bool suggest(const Bindings& bindings) const;
  XrPath path(const std::string& text) const;

  XrInstance instance_;
  XrSession session_;
  OwnedActionSet set_;
  std::array<XrAction, hand_actions> actions_{};  // gone with their set
  std::array<XrPath, 2> hands_{};
  std::array<OwnedSpace, 2> grips_, aims_;
};

}  // namespace odontoscope
