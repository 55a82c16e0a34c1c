#pragma once
// Planar partitions between two given ones.
//
// Structures are ordered from the inside out. What the first one fills, what the first two fill, and so on are interpolated as solids of their own
// (recon/between), and a place belongs to the first of them that holds it. So interpolated neighbours never gape, and never overlap.

#include <tbb/task_arena.h>

#include <cstddef>
#include <vector>

#include "recon/core/progress.h"
#include "recon/delaunay/solve_stack.h"
#include "recon/input/validate.h"
#include "recon/partition/overlay.h"

namespace odontoscope::partition {

struct InterpolatedBorders {
  double z = 0;
  Borders borders;
};

/// How a slab is interpolated.
struct Interpolation {
  std::size_t slices = 0;   // none: its two slices alone
  between::BlendOptions options = {};
};

class Interpolator {
 public:
  /// `borders` of the slices of `given`. Follows links over all slices.
  Interpolator(const std::vector<Borders>& borders, const Materials& materials, const OrderedStack& given, tbb::task_arena& arena,
               const Progress& progress);

  /// In the order in which they are worth trying for slab k.
  std::vector<Interpolation> attempts(std::size_t k) const;

  /// Ascending; a slice in which nothing is left is missing. May be called for several slabs at once.
  std::vector<InterpolatedBorders> between(std::size_t k, const Interpolation& how) const;

 private:
  const Materials& materials_;
  std::vector<double> heights_;
  std::vector<std::size_t> structures_;                      // of what is filled: the outermost structure
  std::vector<delaunay::SurveyedStructure> filled_;
};

}  // namespace odontoscope::partition
