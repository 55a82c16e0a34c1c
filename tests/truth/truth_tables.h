#pragma once
// Results of many teeth, line by line and summed up.

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "measure.h"

namespace odontoscope::test {

/// Pieces, handles and bubbles as they are.
bool is_right(const MethodResult& result, const Topology& truth);

/// One line for each structure: "   7 0.25 pulp     true 1/1/0  DT 2/0/0 wrong". Only what is wrong, if asked for.
std::string lines_of(const std::string& tooth, double spacing, const Truth& truth, const Results& results,
                     bool failing_only);

class Summary {
 public:
  void add(double spacing, const Truth& truth, const Results& results);
  /// Right of all, by method, structure and spacing; and if they were measured, areas and distances.
  std::string text() const;

 private:
  struct Cell {
    std::size_t all = 0, right = 0, warned = 0, refused = 0;
    double wrong = 0, own = 0, mean = 0, largest = 0;
    std::size_t measured = 0;
    double triangles = 0;
  };
  std::map<std::tuple<std::string, std::string, double>, Cell> cells_;  // method, structure, spacing
};

}  // namespace odontoscope::test
