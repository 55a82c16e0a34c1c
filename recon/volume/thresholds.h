#pragma once
// Where the grey values of a volume part: its histogram, and Otsu's thresholds on it.
//
// Otsu, "A threshold selection method from gray-level histograms", IEEE Trans. SMC 9(1), 1979, for any number of
// classes: the thresholds that make the variance between the classes greatest. Found exactly on the histogram by
// dynamic programming.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "recon/volume/volume.h"

namespace odontoscope {

struct Histogram {
  /// Bin n holds values from low + n * width on; beyond the last and below the first bin lie outliers, which count to
  /// those.
  double low = 0, width = 1;
  std::vector<std::uint64_t> counts;
  ValueRange range;

  double value(std::size_t bin) const { return low + static_cast<double>(bin) * width; }
};

/// One bin a value where they are few whole numbers; else limits::histogram_fineness bins over all but the outermost
/// limits::histogram_outliers of the voxels at either end (metal would squeeze the rest into a few bins). `volume`
/// passes validate_volume.
Histogram histogram_of(const Volume& volume, ValueRange range);

/// The classes - 1 thresholds, ascending: a voxel belongs to the class above from the threshold on. Fewer where there
/// are not so many values. 2 to 5 classes.
std::vector<double> otsu_thresholds(const Histogram& histogram, std::size_t classes);

/// Whole numbers from 0 on, few of them: labels rather than grey values. A mask of 0 and one other value counts, too.
bool looks_like_labels(const Volume& volume);

/// A picture for a terminal: one bar a line, at most `lines` of them, with the values that they begin at. Marked are
/// the thresholds given.
std::vector<std::string> histogram_lines(const Histogram& histogram, const std::vector<double>& marks,
                                         std::size_t lines = 32);

}  // namespace odontoscope
