#include "truth_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace odontoscope::test {
namespace {

bool is_delaunay(const std::string& method) { return method.starts_with("DT"); }

std::string verdict(const MethodResult& result, const Topology& truth, bool visible) {
  if (is_right(result, truth)) return result.warned ? "right, warned" : "right";
  return std::string("wrong") + (result.warned ? ", warned" : "") + (visible ? "" : ", hidden from these slices");
}

}  // namespace

bool is_right(const MethodResult& result, const Topology& truth) { return result.topology == truth; }

std::string lines_of(const std::string& tooth, double spacing, const Truth& truth, const Results& results,
                     bool failing_only) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (std::size_t s = 0; s < truth.names.size(); ++s) {
    for (const std::string& method : method_names()) {
      const auto found = results.methods.find(method);
      if (found == results.methods.end()) continue;
      const MethodResult& result = found->second[s];
      const bool right = is_right(result, truth.topology[s]);
      if (failing_only && (right || !results.visible[s] || !is_delaunay(method))) continue;
      fmt::format_to(out, "{} {:.2f} {:8}true {:6} {:11}{:6} {}", tooth, spacing, truth.names[s],
                     in_short(truth.topology[s]), method, result.topology ? in_short(*result.topology) : "-",
                     verdict(result, truth.topology[s], results.visible[s]));
      if (result.own_area > 0)
        fmt::format_to(out, "  {:.2f} % wrong, most in slab {}", 100 * result.wrong_area / result.own_area,
                       result.worst_slab);
      if (result.mean) fmt::format_to(out, "  off {:.4f}, most {:.3f} mm", *result.mean, *result.largest);
      if (!result.refused.empty()) fmt::format_to(out, "  {}", result.refused);
      text += '\n';
    }
  }
  return text;
}

void Summary::add(double spacing, const Truth& truth, const Results& results) {
  if (structures_.empty()) structures_ = truth.names;
  for (const auto& [method, of] : results.methods) {
    for (std::size_t s = 0; s < truth.names.size(); ++s) {
      const MethodResult& result = of[s];
      Cell& cell = cells_[{method, truth.names[s], spacing}];
      const bool right = is_right(result, truth.topology[s]);
      if (results.visible[s]) {
        ++cell.visible;
        cell.right += right;
        cell.warned += !right && result.warned;
        cell.false_alarms += right && result.warned;
      } else {
        ++cell.hidden;
        cell.hidden_right += right;
      }
      cell.refused += !result.refused.empty();
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

std::vector<std::string> Summary::methods() const {
  std::vector<std::string> found;
  for (const std::string& method : method_names())
    if (std::any_of(cells_.begin(), cells_.end(), [&](const auto& cell) { return std::get<0>(cell.first) == method; }))
      found.push_back(method);
  return found;
}

std::string Summary::text() const {
  std::string text = fmt::format("{:11} {:9} {:>7} {:>10} {:>7} {:>7} {:>12} {:>9} {:>9} {:>9} {:>10}\n", "method",
                                 "structure", "spacing", "right", "warned", "refused", "hidden,right", "wrong %",
                                 "off, mm", "most, mm", "triangles");
  const auto out = std::back_inserter(text);
  std::map<std::pair<std::string, double>, Cell> sums;
  for (const auto& [key, cell] : cells_) {
    const auto& [method, structure, spacing] = key;
    Cell& sum = sums[{method, spacing}];
    sum.right += cell.right;
    sum.visible += cell.visible;
    sum.warned += cell.warned;
    sum.hidden += cell.hidden;
    sum.hidden_right += cell.hidden_right;
    fmt::format_to(out, "{:11} {:9} {:>7.3f} {:>10} {:>7} {:>7} {:>12}", method, structure, spacing,
                   fmt::format("{}/{}", cell.right, cell.visible), cell.warned, cell.refused,
                   fmt::format("{},{}", cell.hidden, cell.hidden_right));
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
    fmt::format_to(out, " {:>10.0f}\n", cell.triangles / static_cast<double>(cell.all()));
  }
  for (const auto& [key, sum] : sums) {
    fmt::format_to(out,
                   "{:11} {:9} {:>7.3f} {:>10} {:>7} {:>7} {:>12}  {:.1f} % of those visible right, {:.1f} % of all\n",
                   key.first, "together", key.second, fmt::format("{}/{}", sum.right, sum.visible), sum.warned, "",
                   fmt::format("{},{}", sum.hidden, sum.hidden_right),
                   sum.visible > 0 ? 100.0 * static_cast<double>(sum.right) / static_cast<double>(sum.visible) : 0.0,
                   100.0 * static_cast<double>(sum.right + sum.hidden_right) / static_cast<double>(sum.all()));
  }
  return text;
}

std::string Summary::table(const std::string& title, std::string (*in_words)(const Cell&)) const {
  std::string text = fmt::format("{}\n\n|", title), rule = "\n|---";
  for (const std::string& method : methods()) {
    text += " | " + method;
    rule += "|---";
  }
  text += " |" + rule + "|\n";
  std::set<double> spacings;
  for (const auto& [key, cell] : cells_) spacings.insert(std::get<2>(key));
  for (const std::string& structure : structures_) {
    for (const double spacing : spacings) {
      text += fmt::format("| {}, {} mm", structure, spacing);
      for (const std::string& method : methods()) {
        const auto cell = cells_.find({method, structure, spacing});
        text += " | " + (cell == cells_.end() ? std::string() : in_words(cell->second));
      }
      text += " |\n";
    }
  }
  return text + "\n";
}

std::string Summary::markdown() const {
  std::string text = table("Right pieces, handles and bubbles, of those that the slices can tell of:",
                           [](const Cell& cell) { return fmt::format("{} of {}", cell.right, cell.visible); });
  text += table("Amber where it is wrong; amber where it is right:", [](const Cell& cell) {
    return fmt::format("{} of {}; {} of {}", cell.warned, cell.visible - cell.right, cell.false_alarms, cell.right);
  });
  text += table("Hidden from the slices, of all, and right none the less:", [](const Cell& cell) {
    return fmt::format("{} of {}, {}", cell.hidden, cell.all(), cell.hidden_right);
  });
  text += table("Area in the wrong material, % of the structure's own:", [](const Cell& cell) {
    return cell.own > 0 ? fmt::format("{:.2f}", 100 * cell.wrong / cell.own) : std::string();
  });
  text += table("Mean distance to the true surface, mm:", [](const Cell& cell) {
    return cell.measured > 0 ? fmt::format("{:.4f}", cell.mean / static_cast<double>(cell.measured)) : std::string();
  });
  text += table("Largest distance over all teeth, mm:", [](const Cell& cell) {
    return cell.measured > 0 ? fmt::format("{:.2f}", cell.largest) : std::string();
  });
  text += table("Triangles, in the mean:", [](const Cell& cell) {
    return fmt::format("{:.0f}", cell.triangles / static_cast<double>(cell.all()));
  });
  return text;
}

}  // namespace odontoscope::test
