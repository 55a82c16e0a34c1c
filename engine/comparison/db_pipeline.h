#pragma once
// The DB engine for somebody who turns its knobs and looks: only what a change touches is done again.
//
// Five stages in a row: grid, field, surface, decimation, inspection (see recon/distance). What each made is kept until
// an option of it, or of one before it, changes. A run that is cancelled keeps the stages that it had finished. Not for
// several threads at once: see db_worker.h.

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/comparison/artefacts.h"
#include "engine/measure/pick.h"
#include "engine/scene/model.h"
#include "engine/scene/overlay.h"
#include "recon/core/progress.h"
#include "recon/distance/decimate.h"
#include "recon/distance/field.h"
#include "recon/distance/grid.h"
#include "recon/distance/marching_cubes.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {

/// How many of the triangles stay: all, a half, a tenth, or as few as half a grid spacing allows.
enum class ComparisonDecimation { none, half, tenth, most };
inline constexpr NameTable<ComparisonDecimation, 4> comparison_decimations{{{"none", ComparisonDecimation::none},
                                                                            {"half", ComparisonDecimation::half},
                                                                            {"tenth", ComparisonDecimation::tenth},
                                                                            {"most", ComparisonDecimation::most}}};
inline const char* name(ComparisonDecimation decimation) { return word_of(comparison_decimations, decimation); }

struct ComparisonOptions {
  std::size_t grid = 64;  // points along x and along y, comparison_limits::least_grid to most_grid
  FieldKind field = FieldKind::hybrid;
  /// The table that leaves complements as they are: what it gets wrong is what the mode is there to show.
  CaseTable cases = CaseTable::classic_unoriented;
  ComparisonDecimation decimation = ComparisonDecimation::none;
  friend bool operator==(const ComparisonOptions&, const ComparisonOptions&) = default;
};

namespace comparison_limits {
/// Coarser, and teeth have no canals at all; finer, and a run takes tens of seconds while somebody looks on.
inline constexpr std::size_t least_grid = 8, most_grid = 256;
}  // namespace comparison_limits

enum class ComparisonStage { grid, field, surface, decimation, inspection };
inline constexpr NameTable<ComparisonStage, 5> comparison_stages{{{"grid", ComparisonStage::grid},
                                                                  {"field", ComparisonStage::field},
                                                                  {"surface", ComparisonStage::surface},
                                                                  {"decimation", ComparisonStage::decimation},
                                                                  {"inspection", ComparisonStage::inspection}}};
inline const char* name(ComparisonStage stage) { return word_of(comparison_stages, stage); }

/// One structure, as the judge of all meshes sees it.
struct ComparisonStructure {
  std::string structure;
  SurfaceReport report;
  double lowest_mm = 0;  // least z of its surface; 0 if it has none
  double ridges_mm = 0;  // see ridges.h
};

/// What a run made, ready to be shown.
struct ComparisonResult {
  ComparisonOptions options;
  Model model;
  std::vector<LineSet> faulty_edges;
  std::shared_ptr<const Pickable> pickable;  // never null
  std::vector<ComparisonStructure> structures;
  std::vector<ComparisonArtefact> artefacts;  // cracks first, those on broad walls before others, then non-manifold
                                              // edges, then misoriented ones far apart from each other
  double spacing_mm = 1;                      // of the grid, the larger of x and y
  std::vector<ComparisonStage> ran;           // that this run had to do; empty if nothing had changed

  std::size_t triangles() const;
  std::size_t cracks() const;  // boundary edges
  std::size_t misoriented() const;
  std::size_t nonmanifold() const;  // edges
};

class DbPipeline {
 public:
  explicit DbPipeline(std::shared_ptr<const ContourStack> stack) : stack_(std::move(stack)) {}

  /// Throws InputError (validate; nothing-to-show where no contour holds a grid point), UsageError (make_grid, march),
  /// Cancelled.
  std::shared_ptr<const ComparisonResult> run(const ComparisonOptions& options, const Progress& progress = {});

 private:
  void prepare(const Progress& progress);
  void make_fields(FieldKind kind, const Progress& progress);
  void make_surfaces(CaseTable cases, const Progress& progress);
  void thin_out(ComparisonDecimation decimation, const Progress& progress);
  std::shared_ptr<const ComparisonResult> look_at(const ComparisonOptions& options, std::vector<ComparisonStage> ran,
                                                  const Progress& progress) const;
  void forget_from(ComparisonStage stage);

  std::shared_ptr<const ContourStack> stack_;
  bool prepared_ = false;
  ContourStack sorted_;
  std::vector<std::string> structures_;
  Grid grid_;
  std::vector<Field> fields_;
  std::vector<MarchedSurface> marched_;
  std::vector<DecimatedSurface> decimated_;  // empty if not decimated
  std::array<bool, 5> done_{};
  ComparisonOptions made_with_;  // of the stages that are done
  std::shared_ptr<const ComparisonResult> last_;
};

}  // namespace odontoscope
