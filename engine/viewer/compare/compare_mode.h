#pragma once
// DT and DB of the same contours beside each other. The work is done by a DbWorker; a frame only asks whether something
// is ready.

#include <memory>
#include <optional>
#include <vector>

#include "engine/comparison/db_worker.h"
#include "engine/render/gpu_model.h"
#include "engine/render/gpu_overlay.h"
#include "engine/viewer/compare/comparison_state.h"
#include "engine/viewer/mode.h"

namespace odontoscope {

class CompareMode final : public Mode {
 public:
  using Mode::Mode;

  ComparisonState& state() { return compared_; }
  const ComparisonState& state() const { return compared_; }
  void enter();

  void leave() override;
  bool suspend() override;
  void resume() override { enter(); }
  void loaded(const LoadRequest& request) override;
  void load_failed() override { lesson_after_load_ = false; }
  bool perform(Action action) override;
  std::optional<Drag> press(const Press& press) override;
  bool hover(const Hover& hover) override;
  bool put_away(PutAway what) override;
  void update() override;
  bool working() const override { return compared_.run.working; }
  ModeEffects effects() const override;
  std::vector<ViewPane> panes(const Area& whole) const override;
  const OtherModel* other_model() const override { return compared_.made ? &other_ : nullptr; }
  void draw(DrawLayer layer, const DrawnPane& pane) override;
  std::vector<PanelSection> panel() override;

 private:
  void take_result(std::shared_ptr<const ComparisonResult> made);
  void draw_edges();
  bool on_split_line(double x, double y) const;

  // led.cpp
  void lead_to_artefact(std::size_t artefact);
  /// Shows again what was hidden for it.
  void put_artefact_away();
  void step_artefact(int by);
  void begin_lesson();
  void go_to_step(std::size_t step);

  ComparisonState compared_;
  std::unique_ptr<DbWorker> worker_;
  std::vector<std::unique_ptr<DbWorker>> left_workers_;  // until they have noticed
  std::optional<ComparisonOptions> asked_;               // of the worker
  OtherModel other_;
  GpuModel gpu_model_;
  GpuOverlay gpu_edges_;
  std::shared_ptr<const ComparisonResult> edges_of_;  // that the overlay was made from,
  std::optional<std::size_t> edges_near_;             // and of which artefact; none: all
  bool lesson_after_load_ = false, artefact_when_made_ = false;
};

}  // namespace odontoscope
