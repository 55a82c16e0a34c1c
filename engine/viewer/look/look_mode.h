#pragma once
// Looking at the model from outside: turning it, cutting it open, choosing looks. It takes what no other mode takes.

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "engine/viewer/mode.h"

namespace odontoscope {

class LookMode final : public Mode {
 public:
  using Mode::Mode;

  /// The camera goes there, and the place is marked; mm. In the next frame.
  void look_at(const glm::dvec3& place) { look_at_ = place; }
  const std::optional<glm::dvec3>& looked_at() const { return looked_at_; }

  void leave() override;
  bool perform(Action action) override;
  bool handle(const Event& event) override;
  std::optional<Drag> press(const Press& press) override;
  bool click(const Click& click) override;
  std::optional<int> grip_at(const Hover& hover) const override;
  bool put_away(PutAway what) override;
  void take_requests() override;
  void draw(DrawLayer layer, const DrawnPane& pane) override;
  bool draw_dialog() override;
  std::vector<PanelSection> panel() override;

 private:
  bool handle_shown() const;
  void lead_to(const glm::dvec3& place);
  void toggle_section();
  void toggle_wall_thickness();
  void toggle_projection();
  void scroll(double notches);
  bool on_arrow(const KeyChanged& key);
  bool on_letter(char32_t character);

  std::optional<glm::dvec3> look_at_, looked_at_;  // asked for, and marked
  std::optional<Section> section_put_away_;        // what switching the section off and on again brings back
};

}  // namespace odontoscope
