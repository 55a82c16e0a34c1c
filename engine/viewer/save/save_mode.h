#pragma once
// Pictures and scenes that are saved.

#include <future>
#include <mutex>
#include <string>
#include <vector>

#include "engine/viewer/mode.h"

namespace odontoscope {

class SaveMode final : public Mode {
 public:
  using Mode::Mode;
  /// Finishes writing.
  ~SaveMode() override;

  bool perform(Action action) override;
  void update() override;
  bool working() const override { return !writing_.empty(); }
  std::vector<PanelSection> panel() override;

 private:
  void take_picture();
  /// In the window's context, which waits for it.
  void take_picture_here();
  void save_scene();
  void section();

  std::mutex one_picture_;                         // is drawn at a time
  std::vector<std::future<std::string>> writing_;  // each ends with words for a notice, or throws
};

}  // namespace odontoscope
