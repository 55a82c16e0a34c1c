#pragma once
// What is known of a model because it was made here.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "recon/delaunay/verdict.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope::app {

/// What was proven of solids by the reconstruction that made them.
struct Proven {
  std::vector<std::string> structures;
  std::vector<SurfaceReport> reports;  // one a structure
  std::size_t tetrahedra = 0, slices = 0;
  Verdict verdict = Verdict::green;
  std::string headline;
  std::vector<Attention> attention;
  std::string changes;  // in words; empty: none
};

/// With the reports that it holds now.
Proven proven_by(const Reconstruction& made);

}  // namespace odontoscope::app
