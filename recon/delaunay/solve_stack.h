#pragma once
// One structure's whole stack: slices conformed, regions and voids linked over all slices, each slab solved, plates
// added, overhangs trimmed. Slabs run in parallel; the result does not depend on how many at once.

#include <tbb/task_arena.h>

#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/delaunay/assemble.h"
#include "recon/delaunay/stack_blend.h"
#include "recon/input/validate.h"

namespace odontoscope::delaunay {

struct StackTask {
  const OrderedStack& input;  // validated
  const std::string& structure;
  const ReconstructOptions& options;  // links validated
};

struct SolvedStructure {
  SolvedStack stack;
  std::vector<MadeLink> links;
  std::vector<MadeVoidLink> void_links;
  std::vector<SlabTopology> topology;  // one a slab; `found` is left to whoever assembles
  std::vector<SlabChange> changes;     // what was trimmed
  std::vector<Doubt> doubts;           // by slab, lower, upper, material first
  std::vector<Link> remedies;          // tried
  ReconstructCounts counts;            // all but `slices` and `kept`
};

/// Throws InputError (slices-too-close, link-contradiction, link-impossible), Cancelled, InternalError.
SolvedStructure solve_stack(const StackTask& task, tbb::task_arena& arena, const Progress& progress);

/// A stack's links, without the solids.
struct SurveyedStructure {
  std::vector<ConformedSlice> slices;
  std::vector<SliceVoids> voids;               // one a slice
  std::vector<SlabSurvey> surveys;             // one a slab, as the next two
  std::vector<std::vector<RegionLink>> links;  // of material, that hold
  std::vector<Topology> implied;  // regions that are linked to nothing within the slab count as plates, in every slab
  std::vector<Doubt> doubts;      // as in SolvedStructure, if the links are built
};

/// The way of solve_stack up to the slabs' solids. Throws as solve_stack does.
SurveyedStructure survey_stack(const StackTask& task, tbb::task_arena& arena, const Progress& progress);

}  // namespace odontoscope::delaunay
