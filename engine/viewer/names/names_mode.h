#pragma once
// Structures and canals pointed at from outside: names beside the tooth, of which a click tells what they are, and
// canals, which a double click rides along.

#include <optional>
#include <vector>

#include "engine/navigate/canal_pick.h"
#include "engine/viewer/mode.h"
#include "engine/viewer/names/structure_labels.h"

namespace odontoscope {

class NamesMode final : public Mode {
 public:
  using Mode::Mode;

  bool names_shown() const;
  const StructureNames& names() const { return names_; }
  /// That was clicked.
  const std::optional<CanalPick>& canal() const { return canal_; }
  std::optional<CanalPick> canal_at(const ViewPane& pane, double x, double y) const;
  /// Of the name that was clicked, or no longer. false: none was, and nothing is told.
  bool tell_name(const Click& click);
  void forget();

  void leave() override;
  void model_shown() override;
  bool perform(Action action) override;
  bool click(const Click& click) override;
  bool hover(const Hover& hover) override;
  bool put_away(PutAway what) override;
  void draw(DrawLayer layer, const DrawnPane& pane) override;

 private:
  void enter_canal();

  StructureNames names_;
  std::optional<CanalPick> canal_;
};

}  // namespace odontoscope
