#pragma once
// The viewer: events and time in, pictures out. A window's loop and a test without a display drive the very same
// object. What there is to do in it, modes know (mode.h).

#include <exception>
#include <string>
#include <vector>

#include "engine/ui/interface_pass.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

class Viewer {
 public:
  /// The context of `gl` is current now and at every call, and outlives this. Throws GraphicsError, InternalError.
  /// Going, it stops a running load and finishes writing pictures.
  Viewer(const Gl& gl, const ShaderLibrary& shaders, ViewerOptions options);

  /// Begins to load; the model that is shown stays until the new one is ready.
  void open(LoadRequest request) { at_.open(std::move(request)); }
  /// Kept until the next frame.
  void handle(const Event& event) { events_.push_back(event); }
  /// Does what was asked for since the last frame, and draws.
  void draw(const FrameInput& input, const Target& target);

  /// How long the next frame may wait for an event; 0 while something moves.
  double wait_timeout() const;
  bool loading() const { return at_.modes.loading(); }
  /// What the last load ended with, if it failed; the person has been told.
  const std::exception_ptr& failure() const { return at_.state.failure; }
  Pointer pointer() const { return at_.pointing.pointer; }
  std::string title() const;
  /// Nothing would be lost by closing; otherwise the person is asked, and ViewerState::close follows once they agree.
  bool may_close();
  /// The views in the part of the picture that the panel leaves, as last drawn.
  const std::vector<ViewPane>& panes() const { return at_.layout.panes; }
  const Pointing& pointing() const { return at_.pointing; }
  const Fade& fade() const { return at_.fade; }

  /// What F12 saves, as it is now: the model by the settings for pictures, without the interface. Precondition: a model
  /// is shown. Throws GraphicsError.
  Image picture() { return at_.image(); }
  /// Its scene, with size and samples: `render --scene` draws the same picture.
  Scene scene_of_picture() const { return at_.scene_of_picture(); }

  const Interface& interface() const { return at_.interface; }
  ViewerState& state() { return at_.state; }
  const ViewerState& state() const { return at_.state; }
  template <class M>
  M& mode() const {
    return at_.modes.get<M>();
  }

 private:
  void follow_language();
  void lay_out(const FrameInput& input);
  void advance(double seconds);
  void perform(Action action);
  void put_away();
  void show_hovered();

  // viewer_events.cpp: mouse and keys
  void react(const Event& event);
  bool offer(const Event& event);
  void on_move(const MouseMoved& move);
  void on_button(const MouseButtonChanged& button);
  void on_press(const MouseButtonChanged& button);
  void on_click(double x, double y);
  void on_scroll(const Scrolled& scroll);
  void on_key(const KeyChanged& key);
  void on_text(const TextTyped& text);
  bool on_panel_key(const KeyChanged& key);
  bool answer_by_enter();

  // viewer_interface.cpp: what is written over the picture
  void draw_interface(const FrameInput& input, const Target& target);
  void draw_panes();
  void draw_panel(const Area& area);
  void draw_dialogs();

  Workspace at_;
  InterfacePass interface_pass_;
  std::vector<Event> events_;
  int steps_by_tab_ = 0;  // asked for: controls on, or back
  char last_place_ = 0;   // of the key pressed last, for keyboards without Latin letters
};

}  // namespace odontoscope
