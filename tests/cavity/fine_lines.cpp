#include "tests/cavity/fine_lines.h"

#include <algorithm>
#include <map>

#include "recon/cavity/cavity.h"
#include "recon/core/error.h"
#include "recon/distance/db_reconstruction.h"

namespace odontoscope::test {

const CentreLines& fine_lines(ToothKind kind) {
  static std::map<ToothKind, CentreLines> known;
  if (known.contains(kind)) return known.at(kind);
  ContourStack stack = sample_tooth(kind, {.slice_spacing = 0.1});
  for (Slice& slice : stack.slices)
    std::erase_if(slice.contours, [](const Contour& contour) { return contour.structure != "dentine"; });
  std::erase_if(stack.slices, [](const Slice& slice) { return slice.contours.empty(); });
  DbOptions options;
  options.grid.columns = options.grid.rows = 120;
  options.cases = CaseTable::consistent;
  const DbReconstruction made = reconstruct_by_distance(stack, options);
  return known[kind] =
             centre_lines(cavities_of("dentine", made.surfaces.at(0).surface, made.surfaces.at(0).report).at(0));
}

const CentreLine& ending_at(const std::vector<CentreLine>& canals, const Point3& end) {
  return *std::min_element(canals.begin(), canals.end(), [&](const CentreLine& a, const CentreLine& b) {
    return length(a.end - end) < length(b.end - end);
  });
}

double length_down_to(const CentreLine& line, double z) {
  double sum = 0;
  for (std::size_t i = line.orifice + 1; i < line.points.size() && line.points[i - 1].at.z > z; ++i) {
    const Point3 &above = line.points[i - 1].at, &below = line.points[i].at;
    const double share = below.z >= z ? 1 : (above.z - z) / (above.z - below.z);
    sum += share * length(below - above);
  }
  return sum;
}

}  // namespace odontoscope::test
