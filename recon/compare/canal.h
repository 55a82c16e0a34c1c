#pragma once
// The canal experiment: when does a thin root canal survive? A tooth of 10 mm with a canal of 0.25 mm, reconstructed by
// DT once and by DB on many grids.

#include <cstddef>
#include <vector>

#include "recon/core/progress.h"
#include "recon/distance/cases.h"
#include "recon/input/contour_stack.h"

namespace odontoscope {

/// A root 10 mm high whose round sections widen from 6 mm at the apex to 10 mm, with one canal of even width all the
/// way through, open at both ends. The canal lies off the axis and winds slowly, by less than half its width from slice
/// to slice, so that no grid can fit it by chance. Structure "tooth", 41 slices. Truth: one surface of genus 1.
struct CanalTooth {
  double canal = 0.25;  // its width, mm: 0.05 to 2
};
ContourStack tooth_with_canal(const CanalTooth& tooth = {});

struct CanalResult {
  std::size_t grid = 0;         // points along x and y; 0: DT
  std::size_t open_slices = 0;  // in which the canal is a hole of the model's section
  bool open_through = false;    // one closed surface, of genus 1
  std::size_t surfaces = 0, triangles = 0;
  long genus = 0;  // sum over closed surfaces
};

struct CanalExperiment {
  CanalTooth tooth;
  CaseTable cases = CaseTable::consistent;
  std::size_t slices = 0;
  CanalResult dt;
  std::vector<CanalResult> db;  // in order of CanalOptions::grids
};

struct CanalOptions {
  CanalTooth tooth{};
  std::vector<std::size_t> grids{};  // empty: 16 to 128 in steps of 4
  /// So that topology is defined: with the classic tables cracks make the genus meaningless.
  CaseTable cases = CaseTable::consistent;
  int threads = 0;
};

/// UsageError for a canal or grid out of range. Deterministic. Stage: "canal".
CanalExperiment canal_experiment(const CanalOptions& options = {}, const Progress& progress = {});

}  // namespace odontoscope
