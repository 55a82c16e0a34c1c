// The comparison as lines of a table.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "recon/compare/compare.h"
#include "recon/core/grouped.h"

namespace odontoscope {
namespace {

std::string measured(double value) {
  if (value == 0) return "0";
  constexpr double readable = 1e-4, whole_from = 1000;
  if (std::abs(value) >= whole_from)
    return fmt::format("{}{}", value < 0 ? "-" : "", grouped(static_cast<std::size_t>(std::llround(std::abs(value)))));
  return std::abs(value) < readable ? fmt::format("{:.1e}", value) : fmt::format("{:.3g}", value);
}

/// Below a millionth of a nanometre only the rounding of coordinates is told.
std::string distance(const OneWayDistance& d) {
  const auto words = [](double mm) { return mm > 0 && mm < 1e-12 ? std::string("<1e-12") : measured(mm); };
  return fmt::format("{} / {}", words(d.mean), words(d.largest));
}

std::size_t shells_of(const SurfaceReport& report, Shell::Kind kind) {
  std::size_t count = 0;
  for (const Shell& shell : report.shells) count += shell.kind == kind;
  return count;
}

std::string genus(const SurfaceReport& report) {
  long sum = 0;
  for (const Shell& shell : report.shells) {
    if (shell.kind == Shell::Kind::open) return "undefined";
    sum += shell.genus;
  }
  return fmt::format("{}", sum);
}

double area(const SurfaceReport& report) {
  double sum = 0;
  for (const Shell& shell : report.shells) sum += shell.area;
  return sum;
}

std::string lost(const PassageCounts& counts) {
  return fmt::format("{} of {}", grouped(counts.lost), grouped(counts.all));
}
std::string width(double mm) { return mm > 0 ? measured(mm) : "none"; }

}  // namespace

std::vector<ComparisonRow> comparison_rows(const Comparison& comparison) {
  std::vector<ComparisonRow> rows;
  const auto add = [&](const char* what, const std::function<std::string(const ComparedMethod&)>& value) {
    ComparisonRow row{what, {}};
    for (const ComparedMethod& method : comparison.methods) row.values.push_back(value(method));
    rows.push_back(std::move(row));
  };
  using Method = const ComparedMethod&;
  add("triangles", [](Method m) { return grouped(m.report.triangles); });
  add("closed oriented manifold", [](Method m) { return m.report.closed_oriented_manifold() ? "yes" : "no"; });
  add("boundary edges (cracks)", [](Method m) { return grouped(m.report.boundary_edges); });
  add("misoriented edges", [](Method m) { return grouped(m.report.misoriented_edges); });
  add("non-manifold edges", [](Method m) { return grouped(m.report.nonmanifold_edges); });
  add("non-manifold vertices", [](Method m) { return grouped(m.report.nonmanifold_vertices); });
  add("degenerate triangles", [](Method m) { return grouped(m.report.degenerate_triangles); });
  add("external surfaces", [](Method m) { return grouped(shells_of(m.report, Shell::Kind::external)); });
  add("cavities", [](Method m) { return grouped(shells_of(m.report, Shell::Kind::cavity)); });
  add("open surfaces", [](Method m) { return grouped(shells_of(m.report, Shell::Kind::open)); });
  add("genus, all together", [](Method m) { return genus(m.report); });
  add("structures whose topology is implied",
      [](Method m) { return fmt::format("{} of {}", m.topology.as_implied, m.topology.known); });
  add("area, mm^2", [](Method m) { return measured(area(m.report)); });
  add("smallest angle, degrees: median", [](Method m) { return measured(m.report.smallest_angle_deg.median); });
  add("smallest angle, degrees: least", [](Method m) { return measured(m.report.smallest_angle_deg.min); });
  add("aspect ratio: median", [](Method m) { return measured(m.report.aspect_ratio.median); });
  add("aspect ratio: largest", [](Method m) { return measured(m.report.aspect_ratio.max); });
  add("contours to surface, mm: mean / most", [](Method m) { return distance(m.fit.contours_to_surface); });
  add("section to contours, mm: mean / most", [](Method m) { return distance(m.fit.section_to_contours); });
  add("holes (canals) lost in their slice", [](Method m) { return lost(m.fit.holes); });
  add("thinnest hole that survives, mm", [](Method m) { return width(m.fit.holes.thinnest_kept); });
  add("widest hole that is lost, mm", [](Method m) { return width(m.fit.holes.widest_lost); });
  add("solid sections lost in their slice", [](Method m) { return lost(m.fit.solids); });
  add("thinnest solid that survives, mm", [](Method m) { return width(m.fit.solids.thinnest_kept); });
  const auto& methods = comparison.methods;
  if (std::any_of(methods.begin(), methods.end(), [](Method m) { return m.seen_through.has_value(); })) {
    add("seen through, back faces culled, %",
        [](Method m) { return m.seen_through ? measured(100 * m.seen_through->culled) : std::string("not known"); });
    add("seen through, two-sided, %",
        [](Method m) { return m.seen_through ? measured(100 * m.seen_through->two_sided) : std::string("not known"); });
  }
  add("seconds", [](Method m) { return measured(m.seconds); });
  add("peak memory, MiB", [](Method m) {
    return m.peak_memory ? fmt::format("{:.0f}", static_cast<double>(*m.peak_memory) / (1024.0 * 1024.0))
                         : std::string("not known");
  });
  return rows;
}

}  // namespace odontoscope
