#pragma once
// What every test of the engine asks of a result.

#include <functional>
#include <string>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "tests/support/oracle.h"

namespace odontoscope::test {

struct Outcome {
  /// Empty if the stack was reconstructed and the oracle finds no fault; else the fault, or the message of what was
  /// thrown.
  std::string failure;
  std::vector<std::string> topology;  // as topology_of
};
Outcome outcome_of(const ContourStack& stack, const ReconstructOptions& options = {}, OracleOptions oracle = {});

/// Reconstructs, and adds a test failure for every fault that the oracle finds.
Reconstruction certified(const ContourStack& stack, const ReconstructOptions& options = {}, OracleOptions oracle = {});

/// "tooth external genus 0" n times and so on, sorted as topology_of does.
std::vector<std::string> shells(std::vector<std::string> lines);

/// Empty if the two results hold the same bytes (times and the number of threads apart), else what differs first.
std::string difference(const Reconstruction& a, const Reconstruction& b);

/// A stack that shows the same failure as `stack` in fewer points, as JSON text for the log.
std::string smallest_failing(const ContourStack& stack, const std::function<std::string(const ContourStack&)>& failure);

/// The stack with its slices by ascending z; contours as they are.
ContourStack sorted(ContourStack stack);

}  // namespace odontoscope::test
