#include "recon/output/element_model.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "recon/mesh/complex_parts.h"
#include "recon/mesh/surface_report.h"
#include "recon/partition/interfaces.h"

namespace odontoscope {
namespace {

/// One structure as a complex of one material.
LabelledComplex complex_of(const Solid& solid) {
  LabelledComplex complex{{solid.structure}, solid.tetrahedra, {}};
  complex.mesh.labels.assign(complex.mesh.tetrahedra.size(), 1);
  complex.interfaces = partition::interfaces_of(complex.mesh);
  return complex;
}

void replace(Solid& solid, const LabelledComplex& made, Label label) {
  solid.tetrahedra = tetrahedra_of(made, label);
  solid.surface = surface_of(made, label);
  solid.report = inspect(solid.surface);
  for (Shell& shell : solid.report.shells) shell.structure = solid.structure;
}

class Meshing {
 public:
  Meshing(const Reconstruction& reconstruction, std::optional<double> size, const Progress& progress)
      : solids_(reconstruction.solids), complex_(reconstruction.complex), size_(size), progress_(progress) {}

  void run() {
    if (complex_) {
      complex_ = meshed(*complex_);
      for (Solid& solid : solids_) replace(solid, *complex_, label_of(*complex_, solid.structure));
    } else {
      for (Solid& solid : solids_) replace(solid, meshed(complex_of(solid)), 1);
    }
  }

  /// Nothing of the reconstruction has changed before.
  ModelElements hand_over(Reconstruction& reconstruction) {
    reconstruction.solids = std::move(solids_);
    reconstruction.complex = std::move(complex_);
    reconstruction.counts.kept = 0;
    for (const Solid& solid : reconstruction.solids) reconstruction.counts.kept += solid.tetrahedra.tetrahedra.size();
    return std::move(done_);
  }

 private:
  LabelledComplex meshed(const LabelledComplex& exact) {
    const double asked = size_.value_or(elements::suggested_size(exact));
    elements::Elements made = elements::make_elements(exact, asked, progress_);
    done_.size = done_.materials.empty() ? made.size : std::min(done_.size, made.size);
    done_.asked = done_.materials.empty() ? asked : std::min(done_.asked, asked);
    std::move(made.materials.begin(), made.materials.end(), std::back_inserter(done_.materials));
    return std::move(made.complex);
  }

  std::vector<Solid> solids_;
  std::optional<LabelledComplex> complex_;
  const std::optional<double> size_;
  const Progress& progress_;
  ModelElements done_;
};

}  // namespace

ModelElements mesh_elements(Reconstruction& reconstruction, std::optional<double> size, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  Meshing meshing(reconstruction, size, progress);
  meshing.run();
  ModelElements done = meshing.hand_over(reconstruction);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  reconstruction.seconds.push_back({"elements", taken.count()});
  return done;
}

}  // namespace odontoscope
