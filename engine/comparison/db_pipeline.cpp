#include "engine/comparison/db_pipeline.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>
#include <thread>
#include <utility>

#include "engine/comparison/ridges.h"
#include "recon/distance/limits.h"
#include "recon/input/validate.h"

namespace odontoscope {

namespace {

std::size_t at(ComparisonStage stage) { return static_cast<std::size_t>(stage); }

double lowest(const SurfaceMesh& mesh) {
  double least = std::numeric_limits<double>::max();
  for (const Triangle& triangle : mesh.triangles)
    for (const PointIndex point : triangle) least = std::min(least, mesh.points[point].z);
  return mesh.triangles.empty() ? 0 : least;
}

template <class Count>
std::size_t sum(const std::vector<ComparisonStructure>& structures, Count count) {
  std::size_t total = 0;
  for (const ComparisonStructure& one : structures) total += one.report.*count;
  return total;
}

/// One core is left to whoever draws.
int comparison_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1); }

}  // namespace

std::size_t ComparisonResult::triangles() const { return sum(structures, &SurfaceReport::triangles); }
std::size_t ComparisonResult::cracks() const { return sum(structures, &SurfaceReport::boundary_edges); }
std::size_t ComparisonResult::misoriented() const { return sum(structures, &SurfaceReport::misoriented_edges); }
std::size_t ComparisonResult::nonmanifold() const { return sum(structures, &SurfaceReport::nonmanifold_edges); }

void DbPipeline::forget_from(ComparisonStage stage) {
  for (std::size_t i = at(stage); i < done_.size(); ++i) done_[i] = false;
}

void DbPipeline::prepare(const Progress& progress) {
  if (prepared_) return;
  validate(*stack_, progress);
  sorted_ = ordered(*stack_).stack;
  structures_ = structures_of(sorted_);
  prepared_ = true;
}

void DbPipeline::make_fields(FieldKind kind, const Progress& progress) {
  fields_.clear();
  for (const std::string& structure : structures_)
    fields_.push_back(sample_field(sorted_, structure, grid_, {kind}, progress));
}

void DbPipeline::make_surfaces(CaseTable cases, const Progress& progress) {
  marched_.clear();
  for (const Field& field : fields_) marched_.push_back(march(grid_, field, cases, progress));
}

void DbPipeline::thin_out(ComparisonDecimation decimation, const Progress& progress) {
  decimated_.clear();
  if (decimation == ComparisonDecimation::none) return;
  for (const MarchedSurface& marched : marched_) {
    progress.check();
    progress.tell("decimate", static_cast<double>(decimated_.size()) / static_cast<double>(marched_.size()));
    DecimateOptions options;
    if (decimation == ComparisonDecimation::most)
      options.largest_error = limits::decimation_error * std::max(grid_.dx, grid_.dy);
    else
      options.triangles = marched.mesh.triangles.size() / (decimation == ComparisonDecimation::half ? 2 : 10);
    decimated_.push_back(decimate(marched.mesh, options));
  }
}

std::shared_ptr<const ComparisonResult> DbPipeline::look_at(const ComparisonOptions& options,
                                                            std::vector<ComparisonStage> ran,
                                                            const Progress& progress) const {
  auto result = std::make_shared<ComparisonResult>();
  result->options = options;
  result->ran = std::move(ran);
  result->spacing_mm = std::max(grid_.dx, grid_.dy);
  std::vector<NamedSurface> surfaces;
  for (std::size_t i = 0; i < structures_.size(); ++i) {
    progress.check();
    progress.tell("inspect", static_cast<double>(i) / static_cast<double>(structures_.size()));
    const std::string& structure = structures_[i];
    const bool thinned = !decimated_.empty();
    const SurfaceMesh& mesh = thinned ? decimated_[i].surface : marched_[i].mesh;
    result->structures.push_back(
        {structure, thinned ? decimated_[i].report : inspect(mesh), lowest(mesh), ridges_mm(mesh)});
    const std::vector<ComparisonArtefact> found =
        thinned ? artefacts_of(structure, mesh)
                : artefacts_of(structure, grid_, fields_[i], defects_of(grid_, fields_[i], marched_[i]));
    result->artefacts.insert(result->artefacts.end(), found.begin(), found.end());
    surfaces.push_back({structure, mesh, structure});
  }
  result->artefacts = in_telling_order(std::move(result->artefacts));
  progress.check();
  progress.tell("shade", 0.5);
  result->model = make_model(surfaces);
  progress.check();
  result->faulty_edges = faulty_edges(surfaces, result->model);
  result->pickable = std::make_shared<const Pickable>(result->model, progress);
  result->artefacts = cracks_on_walls_first(std::move(result->artefacts), result->spacing_mm, *result->pickable,
                                            usual_scene(result->model, 1));
  return result;
}

std::shared_ptr<const ComparisonResult> DbPipeline::run(const ComparisonOptions& options, const Progress& progress) {
  tbb::task_arena arena(comparison_threads());
  return arena.execute([&] {
    prepare(progress);
    if (made_with_.grid != options.grid) forget_from(ComparisonStage::grid);
    if (made_with_.field != options.field) forget_from(ComparisonStage::field);
    if (made_with_.cases != options.cases) forget_from(ComparisonStage::surface);
    if (made_with_.decimation != options.decimation) forget_from(ComparisonStage::decimation);
    made_with_ = options;
    std::vector<ComparisonStage> ran;
    const auto once = [&](ComparisonStage stage, auto work) {
      if (done_[at(stage)]) return;
      progress.check();
      work();
      done_[at(stage)] = true;
      ran.push_back(stage);
    };
    once(ComparisonStage::grid, [&] {
      grid_ = make_grid(sorted_, {options.grid, options.grid, {}}, structures_.size());
    });
    once(ComparisonStage::field, [&] { make_fields(options.field, progress); });
    once(ComparisonStage::surface, [&] { make_surfaces(options.cases, progress); });
    once(ComparisonStage::decimation, [&] { thin_out(options.decimation, progress); });
    if (done_[at(ComparisonStage::inspection)]) {
      auto same = std::make_shared<ComparisonResult>(*last_);
      same->ran.clear();
      return std::shared_ptr<const ComparisonResult>(std::move(same));
    }
    ran.push_back(ComparisonStage::inspection);
    last_ = look_at(options, std::move(ran), progress);
    done_[at(ComparisonStage::inspection)] = true;
    return last_;
  });
}

}  // namespace odontoscope
