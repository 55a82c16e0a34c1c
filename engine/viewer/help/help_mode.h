#pragma once
// The list of keys, and hints for the first run.

#include "engine/viewer/help/first_hints.h"
#include "engine/viewer/mode.h"

namespace odontoscope {

class HelpMode final : public Mode {
 public:
  using Mode::Mode;

  void close() { open_ = false; }
  const FirstHints& hints() const { return hints_; }
  bool hints_shown() const;

  bool perform(Action action) override;
  bool put_away(PutAway what) override;
  bool answer() override;
  bool dialog_open() const override { return open_; }
  void advance(double seconds) override;
  void draw(DrawLayer layer, const DrawnPane& pane) override;
  bool draw_dialog() override;

 private:
  void gamepad_dialog();
  void keys_dialog();

  bool open_ = false;
  FirstHints hints_;
};

}  // namespace odontoscope
