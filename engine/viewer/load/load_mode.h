#pragma once
// A model in the making: asked for, shown as a draft, shown, or given up; and what went wrong.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/viewer/mode.h"

namespace odontoscope {

class LoadMode final : public Mode {
 public:
  using Mode::Mode;

  /// Stops what is being made. Other modes may take the request over.
  void open(LoadRequest request);

  bool put_away(PutAway what) override;
  bool answer() override;
  bool dialog_open() const override { return !state_.trouble.empty(); }
  void update() override;
  bool working() const override { return loading(); }
  bool loading() const override { return job_ != nullptr; }
  bool draw_dialog() override;

 private:
  void take_draft();
  void take_model(const LoadRequest& request, LoadedModel made);
  void give_up();
  void loading_dialog();
  void trouble_dialog();

  std::unique_ptr<LoadJob> job_;
  std::vector<std::unique_ptr<LoadJob>> stopped_;  // until they have noticed
  std::optional<Camera> draft_camera_;             // while a draft is shown: that it began with
  bool cancel_asked_ = false;
};

/// "Cutting the slices into triangles" for "conform".
std::string stage_in_words(std::string_view stage);

}  // namespace odontoscope
