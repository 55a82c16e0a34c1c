#include "recon/partition/partition_topology.h"

#include "recon/delaunay/solve_stack.h"

namespace odontoscope::partition {

using delaunay::RegionLink;

ImpliedTopology implied_topology(const OrderedStack& stack, const std::string& structure, tbb::task_arena& arena,
                                 const Progress& progress) {
  const delaunay::SurveyedStructure survey = delaunay::survey_stack({stack, structure, {}}, arena, progress);
  const auto outer = [&](std::size_t k, std::uint32_t region) {
    return survey.slices[k].contour_number[survey.slices[k].outer_contour[region]];
  };
  const auto hole = [&](std::size_t k, std::uint32_t number) -> std::optional<std::size_t> {
    if (number == delaunay::outside) return std::nullopt;
    return survey.slices[k].contour_number[survey.voids[k].hole_contour[number - 1]];
  };
  ImpliedTopology implied;
  implied.of_slab = survey.implied;
  implied.doubts = survey.doubts;
  for (std::size_t k = 0; k < survey.links.size(); ++k) {
    for (const RegionLink& link : survey.links[k])
      implied.links.push_back({{structure, k, outer(k, link.lower), outer(k + 1, link.upper), true}, link.criterion});
    for (const RegionLink& link : survey.surveys[k].voids)
      implied.void_links.push_back({structure, k, hole(k, link.lower), hole(k + 1, link.upper), link.criterion});
  }
  return implied;
}

}  // namespace odontoscope::partition
