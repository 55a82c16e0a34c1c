#include "engine/figures/tooth_models.h"

#include <utility>

#include "engine/figures/papers_way.h"
#include "engine/scene/shells.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::figures {
namespace {

ToothModel counted(std::vector<NamedSurface> surfaces) {
  ToothModel model{std::move(surfaces), 0};
  for (const NamedSurface& named : model.surfaces) model.triangles += named.surface.triangles.size();
  return model;
}

ToothModel by_delaunay(const ContourStack& stack, int threads, const Progress& progress) {
  ReconstructOptions options = papers_way();
  options.threads = threads;
  std::vector<NamedSurface> surfaces;
  for (const Solid& solid : reconstruct(stack, options, progress).solids)
    add_shells(solid.structure, solid.surface, solid.report, surfaces);
  return counted(std::move(surfaces));
}

/// Outer contours of enamel and filled dentine: what one sees of the tooth.
ContourStack outside_of_sample() {
  ContourStack stack = sample_tooth(ToothKind::molar, {.walls = SampleWalls::apart, .hollow_dentine = false});
  for (Slice& slice : stack.slices)
    std::erase_if(slice.contours, [](const Contour& contour) { return contour.structure == "pulp"; });
  return stack;
}

template <class Make>
const ToothModel& made(std::optional<ToothModel>& kept, Make make) {
  if (!kept) kept = make();
  return *kept;
}

}  // namespace

ToothModels::ToothModels(ToothOptions options, Progress progress)
    : options_(std::move(options)),
      progress_(std::move(progress)),
      inner_(options_.contours ? *options_.contours : sample_tooth(ToothKind::molar, {.walls = SampleWalls::apart})),
      outer_(options_.contours ? inner_ : outside_of_sample()) {}

ToothModel ToothModels::by_distance(const ContourStack& stack, CaseTable cases,
                                    const std::optional<DecimateOptions>& decimation) const {
  DbOptions db;
  db.grid.columns = db.grid.rows = options_.grid;
  db.cases = cases;
  db.threads = options_.threads;
  db.decimation = decimation;
  std::vector<NamedSurface> surfaces;
  for (DbSurface& one : reconstruct_by_distance(stack, db, progress_).surfaces)
    surfaces.push_back({one.structure, std::move(one.surface), one.structure});
  return counted(std::move(surfaces));
}

const ToothModel& ToothModels::dt() {
  return made(dt_, [this] { return by_delaunay(outer_, options_.threads, progress_); });
}
const ToothModel& ToothModels::db() {
  return made(db_, [this] { return by_distance(outer_, CaseTable::classic); });
}
const ToothModel& ToothModels::decimated() {
  return made(decimated_, [this] { return by_distance(outer_, CaseTable::classic, DecimateOptions{}); });
}
const ToothModel& ToothModels::whole_dt() {
  return made(whole_dt_, [this] { return by_delaunay(inner_, options_.threads, progress_); });
}
const ToothModel& ToothModels::whole_unoriented() {
  return made(whole_unoriented_, [this] { return by_distance(inner_, CaseTable::classic_unoriented); });
}

}  // namespace odontoscope::figures
