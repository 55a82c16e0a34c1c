#pragma once
// The tooth of the figures, reconstructed by each method when first asked for.

#include <optional>
#include <string>
#include <vector>

#include "engine/scene/model.h"
#include "recon/core/progress.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/input/contour_stack.h"

namespace odontoscope::figures {

struct ToothOptions {
  /// Contours of a tooth that the user gives; none: the sample molar.
  std::optional<ContourStack> contours;
  std::size_t grid = 80;  // points along x and y of the DB method
  int threads = 0;
};

/// A tooth's surfaces by one method.
struct ToothModel {
  std::vector<NamedSurface> surfaces;
  std::size_t triangles = 0;
};

class ToothModels {
 public:
  explicit ToothModels(ToothOptions options, Progress progress = {});

  const std::string& name() const { return inner_.source; }
  bool is_sample() const { return !options_.contours; }  // what captions say of its shape is known to be true
  std::size_t grid() const { return options_.grid; }
  int threads() const { return options_.threads; }
  const Progress& progress() const { return progress_; }

  /// With its inside: enamel, hollow dentine and pulp of the sample.
  const ContourStack& whole_contours() const { return inner_; }
  /// What is seen from outside. Of the sample, enamel and filled dentine; of other contours, all.
  const ContourStack& outer_contours() const { return outer_; }

  const ToothModel& dt();                // of outer_contours
  const ToothModel& db();                // the paper's: classic table, hybrid field
  const ToothModel& decimated();         // db to the most possible
  const ToothModel& whole_dt();          // of whole_contours; cavities apart from outsides
  const ToothModel& whole_unoriented();  // classic-unoriented

 private:
  ToothModel by_distance(const ContourStack& stack, CaseTable cases,
                         const std::optional<DecimateOptions>& decimation = {}) const;

  ToothOptions options_;
  Progress progress_;
  ContourStack inner_, outer_;
  std::optional<ToothModel> dt_, db_, decimated_, whole_dt_, whole_unoriented_;
};

}  // namespace odontoscope::figures
