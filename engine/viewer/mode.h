#pragma once
// A mode of the viewer: one thing that a person does in it (look, fly, compare, measure, be given a lesson), with all
// that it remembers.
//
// The viewer knows no mode by name. It asks all of them in the order of modes.cpp: what happens goes to the first that
// takes it; what is drawn over the picture goes from the last to the first, so that who is asked first lies on top.
// Whatever a mode leaves out does nothing. How to add one: docs/architecture.md, "A viewer's mode".

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/render/gpu_model.h"
#include "engine/render/gpu_overlay.h"
#include "engine/render/resolve_pass.h"
#include "engine/ui/interface_pass.h"
#include "engine/viewer/actions.h"
#include "engine/viewer/pointing.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

class Workspace;

/// What a mode changes for all others while it is on.
struct ModeEffects {
  bool from_outside = true;          // the model is seen from outside, by a camera that anybody may move
  bool names = true;                 // may stand beside the tooth
  bool section_handle = true;        // may be seen, and be dragged
  bool first_hints = true;           // may be given
  bool remember_looks = true;        // of structures, as a person changes them
  bool shadows_while_moving = true;  // ambient occlusion also in pictures that move on a slow machine
};

/// Where a section stands in the panel, from top to bottom.
enum class SectionPlace {
  entrance,
  lessons,
  compared,
  faults,
  structures,
  section,
  volume,
  film,
  measure,
  view,
  comparison,
  notes,
  picture,
  report,
  faces,
  overlays,
  others
};

struct PanelSection {
  SectionPlace place = SectionPlace::others;
  std::function<void()> draw;
  bool also_inside = false;  // where the model is not seen from outside
};

/// What is drawn over the picture, from below to the top. ground: once, in the first pane. marks, front: in each pane.
/// windows: once; lists: once, over dialogs.
enum class DrawLayer { ground, marks, front, windows, lists };

struct DrawnPane {
  const ViewPane& pane;
  bool first = true, last = true;
  bool again = false;  // the other half of a split view: over the same places as the first
};

/// What Escape puts away, one thing after another: all dialogs before all steps, these before marks in the picture.
enum class PutAway { dialog, step, mark };

/// A second model, for panes that ask for it (ViewPane::db).
struct OtherModel {
  const Model* model = nullptr;
  const Pickable* pickable = nullptr;
  const GpuModel* gpu = nullptr;
  const GpuOverlay* overlay = nullptr;
  std::size_t version = 0;  // another one, another picture
};

class Mode {
 public:
  explicit Mode(Workspace& workspace);
  virtual ~Mode() = default;
  Mode(const Mode&) = delete;
  Mode& operator=(const Mode&) = delete;

  /// At once, as if it had never been entered: another model comes. How it is entered is each mode's own affair.
  virtual void leave() {}
  /// The model is no longer seen from outside. true: it was on, and wants resume() once that is over.
  virtual bool suspend() { return false; }
  virtual void resume() {}
  /// A model, or a draft of one, has just been put in ViewerState::shown.
  virtual void model_shown() {}
  /// A request was fulfilled and its model shown; or it came to nothing.
  virtual void loaded(const LoadRequest&) {}
  virtual void load_failed() {}
  /// true: the request is this mode's to answer, and nothing is to be loaded. It may also be changed.
  virtual bool takes_request(LoadRequest&) { return false; }

  // What happens.
  virtual bool perform(Action) { return false; }
  virtual bool handle(const Event&) { return false; }
  /// A button went down in a pane: what the hand drags from there.
  virtual std::optional<Drag> press(const Press&) { return {}; }
  virtual bool click(const Click&) { return false; }
  /// Which of its marks in the picture could be held there.
  virtual std::optional<int> grip_at(const Hover&) const { return {}; }
  /// What lies under the pointer, and its shape. true: nobody else is asked.
  virtual bool hover(const Hover&) { return false; }
  virtual bool put_away(PutAway) { return false; }
  /// Enter, before an open dialog: its first button.
  virtual bool answer() { return false; }
  /// Something has to be read or answered first.
  virtual bool dialog_open() const { return false; }
  /// Letters choose from a list that is open.
  virtual bool chooses_by_letter() const { return false; }
  /// Letters are for what is being written.
  virtual bool writing() const { return false; }
  /// Every move of the mouse is this mode's.
  virtual bool catches_mouse() const { return false; }

  // A frame.
  /// Does what its panel asked for in the frame before.
  virtual void take_requests() {}
  /// Passes work on, and takes what others made of it.
  virtual void update() {}
  virtual void advance(double) {}
  /// The next frame comes at once.
  virtual bool moving() const { return false; }
  /// Others work for it, and it wants to know how far they are.
  virtual bool working() const { return false; }
  /// A model is being made.
  virtual bool loading() const { return false; }
  /// Nothing would be lost by closing; otherwise it asks, and ViewerState::close follows once the person agrees.
  virtual bool may_close() { return true; }

  // What is seen.
  virtual ModeEffects effects() const { return {}; }
  /// Keys that mean something else while it is on; null: what they always mean.
  virtual const KeyTable* keys() const { return nullptr; }
  /// For the list of keys: what else the hand can do.
  virtual std::span<const Gesture> gestures() const { return {}; }
  /// What a click in the picture is for, in words; empty: nothing in particular.
  virtual std::string click_hint() const { return {}; }
  /// Of the lower edge of the picture, in pixels.
  virtual double dock_height() const { return 0; }
  /// Views in the area; nothing: one of all of it.
  virtual std::vector<ViewPane> panes(const Area&) const { return {}; }
  virtual const OtherModel* other_model() const { return nullptr; }
  /// Into the picture, below all that is written.
  virtual void draw_inset(const Target&) {}
  virtual void draw(DrawLayer, const DrawnPane&) {}
  /// What grey_picture() stands for in what it draws.
  virtual std::optional<GreyPicture> slice() const { return {}; }
  /// true: it has drawn one, and no other is.
  virtual bool draw_dialog() { return false; }
  virtual std::vector<PanelSection> panel() { return {}; }

 protected:
  void notice(std::string words, NoticeKind kind = NoticeKind::told, double seconds = Notice{}.seconds_left);

  Workspace& at_;
  ViewerState& state_;
};

}  // namespace odontoscope
