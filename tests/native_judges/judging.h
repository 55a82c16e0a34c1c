#pragma once
// Models to be judged, files of them, and the programs that judge.

#include <gtest/gtest.h>

#include <string>

#include "recon/delaunay/reconstruct.h"
#include "tests/output/temporary_folder.h"

namespace odontoscope::judges {

enum class Tooth { sample_molar, ct_molar };

/// Each test runs on both teeth; where the CT is not there, it is skipped.
class Judge : public ::testing::TestWithParam<Tooth> {
 protected:
  /// Skips the test unless `program` is installed and the tooth's data are there.
  void need(const std::string& program);
  /// The tooth, reconstructed once for all tests.
  const Reconstruction& tooth() const;

  /// Writes the model as `name` and gives its path.
  std::string file_of(const Reconstruction& model, const std::string& name) const;
  /// All that the command says, run in the test's folder; fails the test if it does not end well.
  std::string said_by(const std::string& command) const;

  testing_support::TemporaryFolder folder;
};

/// The dentine of the sample molar, or the CT molar with fewer points: for the solver.
Reconstruction coarse_tooth(Tooth tooth);

/// The number behind `label`, spaces and one of ":" or "=" in what a program says; fails the test if it is not there.
double number_after(const std::string& text, const std::string& label);

/// The same model with one triangle turned over, or left out.
Reconstruction with_flipped_triangle(Reconstruction model);
Reconstruction without_a_triangle(Reconstruction model);
/// With one tetrahedron turned inside out, or left out.
Reconstruction with_inverted_tetrahedron(Reconstruction model);
Reconstruction without_a_tetrahedron(Reconstruction model);

std::size_t triangles_in(const Reconstruction& model);
std::size_t tetrahedra_in(const Reconstruction& model);
double volume_of(const Reconstruction& model);  // of the tetrahedra

std::string name_of(const ::testing::TestParamInfo<Tooth>& tooth);

}  // namespace odontoscope::judges
