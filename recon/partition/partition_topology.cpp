#include "recon/partition/partition_topology.h"

#include "recon/core/parallel.h"
#include "recon/delaunay/difference_place.h"
#include "recon/delaunay/face_table.h"
#include "recon/delaunay/ring.h"
#include "recon/delaunay/solve_stack.h"
#include "recon/delaunay/topology.h"

namespace odontoscope::partition {
namespace {

using namespace delaunay;

std::vector<Ring> holes_beside(const ContourStack& stack, std::size_t slab, const std::string& structure) {
  std::vector<Ring> holes;
  for (const std::size_t k : {slab, slab + 1})
    for (const Contour& contour : stack.slices[k].contours)
      if (contour.structure == structure && signed_area(contour.points) < 0) holes.push_back(contour.points);
  return holes;
}

void tell_links(const SurveyedStructure& survey, const std::string& structure, std::vector<MadeLink>& links, std::vector<MadeVoidLink>& void_links) {
  const auto outer = [&](std::size_t k, std::uint32_t region) { return survey.slices[k].contour_number[survey.slices[k].outer_contour[region]]; };
  const auto hole = [&](std::size_t k, std::uint32_t number) -> std::optional<std::size_t> {
    if (number == 0) return std::nullopt;
    return survey.slices[k].contour_number[survey.voids[k].hole_contour[number - 1]];
  };
  for (std::size_t k = 0; k < survey.links.size(); ++k) {
    for (const RegionLink& link : survey.links[k])
      links.push_back({{structure, k, outer(k, link.lower), outer(k + 1, link.upper), true}, link.criterion});
    for (const RegionLink& link : survey.surveys[k].voids)
      void_links.push_back({structure, k, hole(k, link.lower), hole(k + 1, link.upper), link.criterion});
  }
}

}  // namespace

std::vector<SlabTopology> count_topology(const OrderedStack& effective, const std::string& structure, Label label, const LabelledComplex& complex,
                                         const std::vector<std::size_t>& first, std::vector<MadeLink>& links, std::vector<MadeVoidLink>& void_links,
                                         tbb::task_arena& arena, const Progress& progress) {
  const SurveyedStructure survey = survey_stack({effective, structure, {}}, false, arena, progress);
  tell_links(survey, structure, links, void_links);
  const std::size_t slabs = first.size() - 1;
  std::vector<SlabTopology> counted(slabs);
  for_each(slabs, arena, "certify", progress, [&](std::size_t k) {
    counted[k] = {structure, k, survey.implied[k], {}, 0, false, {}, {}};
    std::vector<Tetrahedron> tetrahedra;
    for (std::size_t t = first[k]; t < first[k + 1]; ++t)
      if (complex.mesh.labels[t] == label) tetrahedra.push_back(complex.mesh.tetrahedra[t]);
    std::vector<Triangle> boundary;
    each_outer_face(tetrahedra, [&](const Triangle& face) { boundary.push_back(face); });
    counted[k].found = counted_topology_of_pinched(tetrahedra, boundary);
    if (counted[k].as_implied() || tetrahedra.empty()) return;
    counted[k].place = place_of_difference({complex.mesh.points, tetrahedra, boundary, holes_beside(effective.stack, k, structure)}, counted[k].implied,
                                           counted[k].found);
  });
  return counted;
}

}  // namespace odontoscope::partition
