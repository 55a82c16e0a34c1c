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

/// One line for each structure and method: "   7 0.25 pulp    true 1/0/0  DT plain   2/0/0  wrong, warned". Only what
/// DT has wrong though the slices tell of it, if asked for.
std::string lines_of(const std::string& tooth, double spacing, const Truth& truth, const Results& results,
                     bool failing_only);

/// Sums over teeth. What the slices cannot tell of (visible.h) is counted apart; areas and distances take all in.
class Summary {
 public:
  void add(double spacing, const Truth& truth, const Results& results);

  /// By method, structure and spacing.
  std::string text() const;
  /// Tables in Markdown, one a measure: structures and spacings down, methods across.
  std::string markdown() const;

 private:
  struct Cell {
    std::size_t visible = 0, right = 0, warned = 0, false_alarms = 0;  // warned: wrong; false alarms: right, and warned
    std::size_t refused = 0;
    std::size_t hidden = 0, hidden_right = 0;
    double wrong = 0, own = 0, mean = 0, largest = 0, triangles = 0;
    std::size_t measured = 0;
    std::size_t all() const { return visible + hidden; }
  };
  using Key = std::tuple<std::string, std::string, double>;  // method, structure, spacing
  std::vector<std::string> methods() const;
  std::string table(const std::string& title, std::string (*text)(const Cell&)) const;

  std::map<Key, Cell> cells_;
  std::vector<std::string> structures_;  // in the order of the first truth
};

}  // namespace odontoscope::test
