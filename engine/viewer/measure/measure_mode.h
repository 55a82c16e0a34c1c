#pragma once
// Distances and walls, measured by clicks.

#include <optional>
#include <vector>

#include "engine/measure/wall_thickness.h"
#include "engine/viewer/mode.h"

namespace odontoscope {

/// What a click in the picture does. Moving the camera works with every tool.
enum class Tool { look, distance, thickness };

/// What was measured last; the marks stay until something else is.
struct Measured {
  std::vector<Hit> ends;  // of a distance: one or two
  std::optional<Hit> wall_at;
  std::optional<WallThickness> wall;
};

class MeasureMode final : public Mode {
 public:
  using Mode::Mode;

  Tool tool() const { return tool_; }
  Measured& measured() { return measured_; }
  /// At the middle of the picture. Precondition: a tool is in hand.
  void measure_middle();
  /// The tool, or looking if it was already that.
  void choose(Tool tool);
  void lay_down_tool() { tool_ = Tool::look; }

  void leave() override;
  bool suspend() override {
    leave();
    return false;
  }
  bool perform(Action action) override;
  bool click(const Click& click) override;
  bool hover(const Hover& hover) override;
  bool put_away(PutAway what) override;
  std::string click_hint() const override;
  void draw(DrawLayer layer, const DrawnPane& pane) override;
  std::vector<PanelSection> panel() override;

 private:
  void measure_at(const Pickable& pickable, const Hit& hit);
  void section();

  Tool tool_ = Tool::look;
  Measured measured_;
};

}  // namespace odontoscope
