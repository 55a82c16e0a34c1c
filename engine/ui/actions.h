#pragma once
// Every command that has a key, with what it does in words: the keyboard and the list under `?` read the same table.

#include <optional>
#include <span>
#include <string_view>

#include "engine/ui/viewer_state.h"
#include "engine/view/input.h"

namespace odontoscope {

struct ActionKey {
  std::string_view printed;  // as on the keyboard
  Action action;
  std::string_view words;
  char32_t character = 0;  // typed; small and capital letters alike
  Key key = Key::other;    // or pressed
  bool control = false;
};

std::span<const ActionKey> action_keys();
/// While one flies letters mean this instead. (Those that fly are held down, see viewer_fly.cpp.)
std::span<const ActionKey> flight_keys();
/// What is meant, by either of these lists.
std::optional<Action> action_for(const TextTyped& text, std::span<const ActionKey> known = action_keys());
std::optional<Action> action_for(const KeyChanged& key, std::span<const ActionKey> known = action_keys());

/// What the mouse does, for the list.
struct Gesture {
  std::string_view printed, words;
};
std::span<const Gesture> gestures();
std::span<const Gesture> flight_gestures();
/// What a gamepad does, in flight or not.
std::span<const Gesture> gamepad_gestures();

std::optional<NamedView> view_of(Action action);

}  // namespace odontoscope
