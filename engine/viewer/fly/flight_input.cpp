#include "engine/viewer/fly/flight_input.h"

#include <utility>

namespace odontoscope {

GamepadChanged FlightInput::take(const GamepadChanged& gamepad) { return std::exchange(gamepad_, gamepad); }

FlightWish FlightInput::wish() const {
  const auto either = [&](int a, int b) { return held_.contains(a) || held_.contains(b) ? 1.0 : 0.0; };
  const auto key = [&](Key one) { return either(number_of(one), 0); };
  FlightWish wish;
  wish.move = {either('d', 'l') - either('a', 'j'), either('e', 'o') - either('q', 'u'),
               either('w', 'i') - either('s', 'k')};
  wish.turn = {key(Key::right) - key(Key::left), key(Key::up) - key(Key::down)};
  wish.move += glm::dvec3(gamepad_.move_right, gamepad_.rise, gamepad_.move_ahead);
  wish.turn += glm::dvec2(gamepad_.turn_right, gamepad_.turn_up);
  return wish;
}

}  // namespace odontoscope
