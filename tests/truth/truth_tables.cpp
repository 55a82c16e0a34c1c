#include "truth_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace odontoscope::test {

bool is_right(const MethodResult& result, const Topology& truth) { return result.topology == truth; }

std::string lines_of(const std::string& tooth, double spacing, const Truth& truth, const Results& results,
                     bool failing_only) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (std::size_t s = 0; s < truth.names.size(); ++s) {
    for (const auto& [method, of] : results) {
      const MethodResult& result = of[s];
      const bool right = is_right(result, truth.topology[s]);
      if (failing_only && (right || method != "DT")) continue;
      fmt::format_to(out, "{} {:.2f} {:8}true {:6} {:11}{:6} {}", tooth, spacing, truth.names[s],
                     in_short(truth.topology[s]), method, result.topology ? in_short(*result.topology) : "-",
                     right ? "right" : result.warned ? "wrong, warned" : "wrong");
      if (result.own_area > 0) fmt::format_to(out, "  {:.2f} % wrong", 100 * result.wrong_area / result.own_area);
      if (result.mean) fmt::format_to(out, "  off {:.4f}, most {:.3f} mm", *result.mean, *result.largest);
      if (!result.refused.empty()) fmt::format_to(out, "  {}", result.refused);
      text += '\n';
    }
  }
  return text;
}

void Summary::add(double spacing, const Truth& truth, const Results& results) {
  for (const auto& [method, of] : results) {
    for (std::size_t s = 0; s < truth.names.size(); ++s) {
      const MethodResult& result = of[s];
      Cell& cell = cells_[{method, truth.names[s], spacing}];
      ++cell.all;
      if (is_right(result, truth.topology[s])) {
        ++cell.right;
      } else if (result.warned) {
        ++cell.warned;
      }
      if (!result.refused.empty()) ++cell.refused;
      cell.wrong += result.wrong_area;
      cell.own += result.own_area;
      cell.triangles += static_cast<double>(result.triangles);
      if (!result.mean) continue;
      ++cell.measured;
      cell.mean += *result.mean;
      cell.largest = std::max(cell.largest, *result.largest);
    }
  }
}

std::string Summary::text() const {
  std::string text = fmt::format("{:11} {:8} {:>7} {:>12} {:>7} {:>7} {:>9} {:>9} {:>9} {:>10}\n", "method", "structure",
                                 "spacing", "right", "warned", "refused", "wrong %", "off, mm", "most, mm", "triangles");
  const auto out = std::back_inserter(text);
  std::map<std::pair<std::string, double>, std::pair<std::size_t, std::size_t>> sums;
  for (const auto& [key, cell] : cells_) {
    const auto& [method, structure, spacing] = key;
    auto& [right, all] = sums[{method, spacing}];
    right += cell.right;
    all += cell.all;
    fmt::format_to(out, "{:11} {:9} {:>7.3f} {:>12} {:>7} {:>7}", method, structure, spacing,
                   fmt::format("{}/{}", cell.right, cell.all), cell.warned, cell.refused);
    if (cell.own > 0) {
      fmt::format_to(out, " {:>9.2f}", 100 * cell.wrong / cell.own);
    } else {
      fmt::format_to(out, " {:>9}", "");
    }
    if (cell.measured > 0) {
      fmt::format_to(out, " {:>9.4f} {:>9.3f}", cell.mean / static_cast<double>(cell.measured), cell.largest);
    } else {
      fmt::format_to(out, " {:>9} {:>9}", "", "");
    }
    fmt::format_to(out, " {:>10.0f}\n", cell.triangles / static_cast<double>(cell.all));
  }
  for (const auto& [key, counts] : sums) {
    fmt::format_to(out, "{:11} {:9} {:>7.3f} {:>12} {:>6.1f} %\n", key.first, "together", key.second,
                   fmt::format("{}/{}", counts.first, counts.second),
                   100.0 * static_cast<double>(counts.first) / static_cast<double>(counts.second));
  }
  return text;
}

}  // namespace odontoscope::test
