#pragma once
// The grey values of a volume, the model beside them, and X-ray films of either.

#include <memory>
#include <optional>
#include <vector>

#include "engine/viewer/mode.h"
#include "engine/viewer/volume/volume_layout.h"

namespace odontoscope {

class VolumeMode final : public Mode {
 public:
  using Mode::Mode;

  VolumeAsked& asked() { return asked_; }
  const VolumeLayout& layout() const { return layout_; }

  void model_shown() override;
  void take_requests() override;
  void update() override;
  bool working() const override { return deviation_job_ != nullptr; }
  std::vector<PanelSection> panel() override;

 private:
  /// Looks from where an X-ray tube would stand, from as far as now.
  void swing_tube(double degrees);
  /// Goes so far back that the film's edge is in the picture, too.
  void show_film();
  void take_deviations(std::shared_ptr<const LoadedModel> marked);

  VolumeLayout layout_;
  VolumeAsked asked_;
  std::unique_ptr<Job<LoadedModel>> deviation_job_;
  std::shared_ptr<const LoadedModel> deviations_of_;  // that the job is about
};

}  // namespace odontoscope
