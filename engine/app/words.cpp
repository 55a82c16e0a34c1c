#include "engine/app/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "recon/core/grouped.h"
#include "recon/input/validate.h"

namespace odontoscope::app {
std::string counted(std::size_t count, std::string_view singular, std::string_view plural) {
  const std::string many = plural.empty() ? fmt::format("{}s", singular) : std::string(plural);
  return fmt::format("{} {}", grouped(count), count == 1 ? std::string(singular) : many);
}

std::string measured(double value) {
  constexpr double whole_numbers_from = 1000, plain_down_to = 1e-3;
  const double size = std::abs(value);
  if (size >= whole_numbers_from && size < 1e15) {
    return (value < 0 ? "-" : "") + grouped(static_cast<std::uint64_t>(std::llround(size)));
  }
  if (size == 0 || size >= plain_down_to) return fmt::format("{:.3g}", value);
  return fmt::format("{:.2e}", value);
}

std::string stack_in_words(const ContourStack& stack) {
  std::size_t contours = 0, points = 0;
  double low = 0, high = 0;
  for (const Slice& slice : stack.slices) {
    const bool first = &slice == &stack.slices.front();
    low = first ? slice.z : std::min(low, slice.z);
    high = first ? slice.z : std::max(high, slice.z);
    contours += slice.contours.size();
    for (const Contour& contour : slice.contours) points += contour.points.size();
  }
  return fmt::format("{} from z = {} to {} mm, {}, {}; {}: {}", counted(stack.slices.size(), "slice"), measured(low),
                     measured(high), counted(contours, "contour"), counted(points, "point"),
                     structures_of(stack).size() == 1 ? "structure" : "structures",
                     fmt::join(structures_of(stack), ", "));
}

std::string shell_in_words(const Shell& shell) {
  if (shell.kind == Shell::Kind::open) {
    return fmt::format("open surface, {}, area {} mm^2", counted(shell.triangles, "triangle"), measured(shell.area));
  }
  return fmt::format("{} of genus {}, {}, volume {} mm^3",
                     shell.kind == Shell::Kind::external ? "external surface" : "cavity", shell.genus,
                     counted(shell.triangles, "triangle"), measured(std::abs(shell.volume)));
}

std::vector<std::string> defects_in_words(const SurfaceReport& report) {
  std::vector<std::string> defects;
  const auto add = [&defects](std::size_t count, std::string_view singular, std::string_view plural) {
    if (count > 0) defects.push_back(counted(count, singular, plural));
  };
  add(report.boundary_edges, "boundary edge", "boundary edges");
  add(report.nonmanifold_edges, "non-manifold edge", "non-manifold edges");
  add(report.misoriented_edges, "misoriented edge", "misoriented edges");
  add(report.nonmanifold_vertices, "non-manifold vertex", "non-manifold vertices");
  add(report.degenerate_triangles, "degenerate triangle", "degenerate triangles");
  return defects;
}

}  // namespace odontoscope::app
