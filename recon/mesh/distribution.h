#pragma once
// Minimum, median, mean, maximum and histogram of one quality measure.

#include <vector>

#include "recon/mesh/surface_report.h"

namespace odontoscope {

/// `values` are finite; they are reordered. The first and the last bin also count what lies beyond `low` and `high`.
/// With an even number of values the median is the mean of the two middle ones. All zeros if there is no value.
Distribution distribution_of(std::vector<double>& values, double low, double high);

}  // namespace odontoscope
