#pragma once
// Flight: into the pulp and around the tooth, and rides along canals.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/navigate/ride.h"
#include "engine/viewer/fly/flight_input.h"
#include "engine/viewer/fly/fly_state.h"
#include "engine/viewer/fly/inset.h"
#include "engine/viewer/mode.h"

namespace odontoscope {

class FlyMode final : public Mode {
 public:
  using Mode::Mode;

  bool on() const { return fly_.on; }
  FlyState& state() { return fly_; }
  const FlyState& state() const { return fly_; }
  /// The cavity that one is in; null: one is outside.
  const FlightSpace* inside() const;
  bool riding() const { return fly_.on && fly_.ride; }
  /// By its name; empty: one is in none.
  std::string canal_here() const;
  bool possible() const { return state_.shown && state_.shown->flight; }

  /// The view that leaving brings back is the one now, if one does not fly yet.
  void remember_view();
  /// From the view as it is, in the dark; and do `then` once there, if anything.
  void dive(std::size_t cavity, std::function<void()> then = {});
  /// Into its cavity if one is not there, and along it.
  void ride_canal(std::size_t cavity, std::size_t line);
  /// At once: the eye is there, and sees what is to be seen there. `cavity` none: outdoors.
  void arrive(std::optional<std::size_t> cavity, const Flight& flight);
  /// The camera that the flight has now.
  void see();
  /// With this angle of view, until one arrives elsewhere or changes one's own.
  void see_as(double field_of_view_deg);
  /// No key is held any more, nor the mouse.
  void let_go();

  void leave() override;
  bool perform(Action action) override;
  bool handle(const Event& event) override;
  std::optional<Drag> press(const Press& press) override;
  bool click(const Click& click) override;
  bool hover(const Hover& hover) override;
  bool put_away(PutAway what) override;
  bool catches_mouse() const override { return fly_.on && fly_.mouse_caught; }
  void take_requests() override;
  void advance(double seconds) override;
  bool moving() const override;
  ModeEffects effects() const override;
  const KeyTable* keys() const override;
  void draw_inset(const Target& target) override;
  void draw(DrawLayer layer, const DrawnPane& pane) override;
  std::vector<PanelSection> panel() override;

 private:
  void enter_cavity(std::size_t cavity, std::function<void()> then = {});
  void enter_outdoors();
  /// In the dark: the view from before.
  void go_out();
  void pass_wall();
  FlightRules rules() const;
  const Walls& walls() const;
  void note_turning(double seconds);

  // flying_by_hand.cpp
  bool on_key(const KeyChanged& key);
  void on_gamepad(const GamepadChanged& gamepad);
  void look_by(const glm::dvec2& pixels);
  std::optional<CanalPick> canal_in_inset(double x, double y) const;

  // ride.cpp
  bool perform_on_ride(Action action);
  void control_ride(Action action);
  void begin_ride(std::size_t line);
  /// Where the ball fits through; empty, and told why, if there is nothing to ride.
  Track rideable_track(std::size_t cavity, std::size_t line);
  void start_ride(std::size_t line, Track track);
  void advance_ride(const FlightWish& wish, double seconds);
  void leave_ride();

  FlyState fly_;
  FlightInput input_;
  Inset inset_;
  std::optional<Camera> view_before_dive_;
  std::vector<Mode*> suspended_;  // that come back afterwards
};

}  // namespace odontoscope
