#pragma once
// Which button does what, controller by controller: data that the runtime is offered. Paths are those of the OpenXR
// specification, section 6.4.

#include <span>

namespace odontoscope {

enum class HandAction { grip, aim, trigger, grab, stick, menu, haptic };
inline constexpr int hand_actions = 7;

struct Binding {
  HandAction action = HandAction::grip;
  const char* left = nullptr;  // below /user/hand/left; null: this hand has none
  const char* right = nullptr;
};

struct Bindings {
  const char* profile = nullptr;  // below /interaction_profiles
  const char* words = nullptr;    // for people
  std::span<const Binding> bindings;
};

std::span<const Bindings> all_bindings();

}  // namespace odontoscope
