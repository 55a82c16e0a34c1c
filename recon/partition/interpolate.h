#pragma once
// Planar partitions between two given ones.
//
// Structures are ordered from the inside out. What the first one fills, what the first two fill, and so on are
// interpolated as solids of their own (recon/between), and a place belongs to the first of them that holds it. So
// interpolated neighbours never gape, and never overlap.
//
// What only a structure's own contours tell (that a canal leaves through dentine's wall between two slices) is lost on
// the way. So where that does not give the implied topology, each structure is interpolated as it is, hollow, as well,
// and what lies within the filled ones and in none of these goes to the next structure inwards if it borders on that.

#include <tbb/task_arena.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/delaunay/solve_stack.h"
#include "recon/input/validate.h"
#include "recon/partition/contour_overlay.h"

namespace odontoscope::partition {

struct InterpolatedBorders {
  double z = 0;
  Borders borders;
};

/// How a slab is interpolated.
struct Interpolation {
  std::size_t slices = 0;  // none: its two slices alone
  between::BlendOptions options = {};
  bool late = false;  // costs several times all others: for what is nearly as it should be
  /// By the structures' own contours, too; which of them keeps a place that two hold.
  enum class Own { none, inner_first, outer_first } own = Own::none;
};

class Interpolator {
 public:
  /// `borders` of the slices of `given`; all must outlive this. Follows links over all slices.
  Interpolator(const std::vector<Borders>& borders, const Materials& materials, const OrderedStack& given,
               tbb::task_arena& arena, const Progress& progress);

  /// In the order in which they are worth trying for slab k; late ones only where outlines are few and fine.
  std::vector<Interpolation> attempts(std::size_t k) const;

  /// Those by the structures' own contours. Precondition: survey_own was called.
  std::vector<Interpolation> own_attempts(std::size_t k) const;

  /// Follows the links of each structure as it is, hollow.
  void survey_own(tbb::task_arena& arena, const Progress& progress);

  /// Ascending; a slice in which nothing is left is missing. May be called for several slabs at once.
  std::vector<InterpolatedBorders> between(std::size_t k, const Interpolation& how) const;

 private:
  using Surveyed = delaunay::SurveyedStructure;
  bool deserves_more(std::size_t k) const;
  OrderedStack contours_of(const std::string& name, const std::function<bool(Label)>& chosen) const;
  Materials stand_ins(Interpolation::Own own) const;
  void blend(const Surveyed& one, std::size_t k, const std::vector<double>& shares,
             const between::BlendOptions& options, const std::string& name, std::vector<Slice>& contours) const;

  const std::vector<Borders>& borders_;
  const Materials& materials_;
  const OrderedStack& given_;
  std::vector<double> heights_;
  std::vector<std::size_t> structures_;  // of what is filled: the outermost structure
  std::vector<Surveyed> filled_;
  std::vector<std::optional<Surveyed>> own_;  // of each of these, hollow; none of the first, which is
};

}  // namespace odontoscope::partition
