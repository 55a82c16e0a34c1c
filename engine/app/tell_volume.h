#pragma once
// What a person is told of a volume and of the contours taken from it.

#include <string>
#include <vector>

#include "engine/app/console.h"
#include "engine/app/volume_options.h"
#include "recon/volume/thresholds.h"

namespace odontoscope::app {

/// Otsu's thresholds of a volume for several numbers of classes.
struct Thresholds {
  Histogram histogram;

  Thresholds() = default;
  explicit Thresholds(const Volume& volume);
  std::vector<double> all_of(std::size_t classes) const;
  /// Throws InputError nothing-crosses-iso where the volume has not so many values.
  double of(const AutoLevel& level) const;

 private:
  std::string source_;
};

/// Size, spacing, turn, and each of its remarks.
void tell_volume(const std::string& file, const Volume& volume, Console& console);

/// From where to where its voxels' centres lie: for a box to crop it to.
void tell_place(const Volume& volume, Console& console);

void tell_thresholds(const Thresholds& thresholds, Console& console);

/// That --iso runs between labels, and which there are.
void tell_label_map(const Volume& volume, Console& console);

/// Counts of each level, what --min-area left out of it, and warnings about canals that may be lost with that.
void tell_levels(const std::vector<LevelReport>& levels, const Volume& volume, const VolumeContourOptions& options,
                 Console& console);

}  // namespace odontoscope::app
