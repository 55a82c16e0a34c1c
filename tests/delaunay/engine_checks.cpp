#include "tests/delaunay/engine_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "tests/support/shrink.h"
#include "tests/support/stack_text.h"

namespace odontoscope::test {
namespace {

template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  static_assert(std::is_trivially_copyable_v<T>);
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same(const ReconstructCounts& a, const ReconstructCounts& b) {
  return a.slices == b.slices && a.contours == b.contours && a.points == b.points &&
         a.steiner_points == b.steiner_points && a.kept == b.kept && a.restored == b.restored &&
         a.lifted_points == b.lifted_points && a.trimmed == b.trimmed && a.isolated_regions == b.isolated_regions &&
         a.largest_sideways == b.largest_sideways;
}

/// Enough of a message to tell one kind of failure from another, without its numbers.
std::string sort_of(const std::string& failure) {
  std::string letters;
  for (char c : failure)
    if (letters.size() < 40 && (std::isalpha(static_cast<unsigned char>(c)) || c == ' ')) letters += c;
  return letters;
}

}  // namespace

Outcome outcome_of(const ContourStack& stack, const ReconstructOptions& options, OracleOptions oracle) {
  try {
    const Reconstruction result = reconstruct(stack, options);
    std::string words;
    for (const std::string& fault : faults_of(result, stack, oracle)) words += fault + "\n";
    return {words, topology_of(result)};
  } catch (const std::exception& error) {
    return {std::string("thrown: ") + error.what(), {}};
  }
}

Reconstruction certified(const ContourStack& stack, const ReconstructOptions& options, OracleOptions oracle) {
  Reconstruction result = reconstruct(stack, options);
  for (const std::string& fault : faults_of(result, stack, oracle)) ADD_FAILURE() << fault;
  return result;
}

std::vector<std::string> shells(std::vector<std::string> lines) {
  std::sort(lines.begin(), lines.end());
  return lines;
}

std::string difference(const Reconstruction& a, const Reconstruction& b) {
  if (a.solids.size() != b.solids.size()) return "number of solids";
  for (std::size_t s = 0; s < a.solids.size(); ++s) {
    const Solid &x = a.solids[s], &y = b.solids[s];
    if (x.structure != y.structure) return "structure";
    if (!same(x.tetrahedra.points, y.tetrahedra.points)) return "points";
    if (!same(x.tetrahedra.tetrahedra, y.tetrahedra.tetrahedra)) return "tetrahedra";
    if (!same(x.tetrahedra.labels, y.tetrahedra.labels)) return "labels";
    if (!same(x.surface.points, y.surface.points)) return "points of the surface";
    if (!same(x.surface.triangles, y.surface.triangles)) return "triangles";
    if (!same(x.report.shell_of, y.report.shell_of)) return "shells";
  }
  if (a.links.size() != b.links.size()) return "number of links";
  for (std::size_t i = 0; i < a.links.size(); ++i)
    if (!(a.links[i].link == b.links[i].link) || a.links[i].criterion != b.links[i].criterion) return "links";
  if (!same(a.counts, b.counts)) return "counts";
  if (a.slices_checked != b.slices_checked) return "slices checked";
  return {};
}

std::string smallest_failing(const ContourStack& stack,
                             const std::function<std::string(const ContourStack&)>& failure) {
  const std::string sort = sort_of(failure(stack));
  if (sort.empty()) return "(it does not fail again: not deterministic)";
  return to_text(shrunk(stack, [&](const ContourStack& candidate) { return sort_of(failure(candidate)) == sort; }));
}

ContourStack sorted(ContourStack stack) {
  std::sort(stack.slices.begin(), stack.slices.end(), [](const Slice& a, const Slice& b) { return a.z < b.z; });
  return stack;
}

}  // namespace odontoscope::test
