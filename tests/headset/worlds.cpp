#include "tests/headset/worlds.h"

#include <glm/geometric.hpp>

#include "tests/render/shapes.h"

namespace odontoscope::testing_support {

namespace {

std::vector<NamedSurface> balls() { return {{"dentine", ball({{1, 2, 30}, 5})}, {"pulp", ball({{1, 2, 30}, 2})}}; }

}  // namespace

BallWorld::BallWorld()
    : model(make_model(balls())),
      pickable(model),
      scene(usual_scene(model, 1)),
      cavities(flight_spaces(balls(), model).cavities) {}

const BallWorld& BallWorld::once() {
  static const BallWorld balls;
  return balls;
}

const MolarWorld& MolarWorld::once() {
  static const MolarWorld molar{small_molar(), Pickable(small_molar()), usual_scene(small_molar(), 1),
                                flight_spaces(small_molar_surfaces(), small_molar()).cavities};
  return molar;
}

HeadsetInput person() {
  HeadsetInput input;
  input.head.position = {0.3, 1.6, 0.2};
  input.head_tracked = input.focused = true;
  for (std::size_t i = 0; i < 2; ++i) {
    HandInput& hand = input.hands[i];
    hand.tracked = true;
    hand.grip.position = hand.aim.position = input.head.position + glm::dvec3(i == 0 ? -0.2 : 0.2, -0.3, -0.3);
    // At the floor, where nothing is.
    hand.aim.turn = glm::angleAxis(-1.5, glm::dvec3(1, 0, 0));
  }
  return input;
}

HandInput pointing_at(const glm::dvec3& place, const glm::dvec3& from) {
  HandInput hand;
  hand.tracked = true;
  hand.grip.position = hand.aim.position = from;
  hand.aim.turn = glm::quatLookAt(glm::normalize(place - from), glm::dvec3(0, 1, 0));
  return hand;
}

FieldOfView lopsided(bool left) {
  constexpr double temple = 0.9, nose = 0.7;
  return {left ? -temple : -nose, left ? nose : temple, -0.85, 0.75};
}

std::vector<EyeView> eyes_of(const Pose& head, double apart) {
  std::vector<EyeView> eyes;
  for (const bool left : {true, false})
    eyes.push_back(
        {{head.position + head.turn * glm::dvec3(left ? -apart / 2 : apart / 2, 0, 0), head.turn}, lopsided(left)});
  return eyes;
}

}  // namespace odontoscope::testing_support
