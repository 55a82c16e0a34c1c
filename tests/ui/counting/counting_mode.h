#pragma once
// A mode as small as one can be, to see that a folder and a line are enough: K begins to count clicks on the tooth, Esc
// ends it.

#include "engine/ui/widgets.h"
#include "engine/viewer/workspace.h"

namespace odontoscope::testing_support {

class CountingMode final : public Mode {
 public:
  using Mode::Mode;

  bool on() const { return on_; }
  int clicks() const { return clicks_; }

  void leave() override { on_ = false; }
  bool handle(const Event& event) override {
    const auto* text = std::get_if<TextTyped>(&event);
    if (!text || text->character != U'k') return false;
    on_ = true;
    clicks_ = 0;
    return true;
  }
  bool click(const Click& click) override {
    if (on_ && at_.hit_at(click.pane, click.x, click.y)) ++clicks_;
    return on_;
  }
  bool put_away(PutAway what) override { return what == PutAway::step && std::exchange(on_, false); }
  ModeEffects effects() const override { return {.names = !on_}; }
  std::string click_hint() const override { return on_ ? "Click what is to be counted" : ""; }
  std::span<const Gesture> gestures() const override {
    static constexpr Gesture key{"K", "count clicks"};
    return {&key, 1};
  }
  std::vector<PanelSection> panel() override {
    return {{SectionPlace::others, [this] {
               if (widgets::section(at_.interface, "Counting") && widgets::wide_button("Begin anew")) clicks_ = 0;
             }}};
  }

 private:
  bool on_ = false;
  int clicks_ = 0;
};

}  // namespace odontoscope::testing_support
