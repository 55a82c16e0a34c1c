#pragma once
// Keys that are held and sticks that are pushed, as a wish to fly.

#include <set>

#include "engine/navigate/flight.h"
#include "engine/view/input.h"

namespace odontoscope {

class FlightInput {
 public:
  void press(const KeyChanged& key) { held_.insert(number_of(key)); }
  void release(const KeyChanged& key) { held_.erase(number_of(key)); }
  void release_all() { held_.clear(); }
  /// What was pushed before.
  GamepadChanged take(const GamepadChanged& gamepad);

  FlightWish wish() const;
  /// Three times as fast.
  bool hurries() const { return held_.contains(number_of(Key::shift)) || gamepad_.faster; }

 private:
  /// Letters by place, other keys beyond them.
  static int number_of(const KeyChanged& key) { return key.place ? key.place : number_of(key.key); }
  static int number_of(Key key) { return 256 + static_cast<int>(key); }

  std::set<int> held_;
  GamepadChanged gamepad_;
};

}  // namespace odontoscope
