#include "recon/delaunay/correspond.h"

#include <algorithm>
#include <map>

#include "recon/core/union_find.h"
#include "recon/delaunay/witnesses.h"

namespace odontoscope::delaunay {

std::vector<RegionLink> witnessed_links(const SlabTetrahedra& tetrahedra, const Planar& lower, const Planar& upper,
                                        Correspondence widest) {
  Witnesses witnesses;
  const SlabNumbers numbers(lower);
  for (const SlabTetrahedron& tet : tetrahedra) {
    const std::uint32_t below = lower.region_of[numbers.own(tet.v[0])], above = upper.region_of[numbers.own(tet.v[3])];
    if (tet.lower_count == 2 && tet.lower_edge == EdgeKind::internal && tet.upper_edge == EdgeKind::internal)
      witnesses.add(below, above, LinkCriterion::reverse);
    else if (tet.lower_count != 2 && tet.dual_in_lower && tet.dual_in_upper && widest >= Correspondence::medial)
      witnesses.add(below, above, LinkCriterion::medial);
    else if (tet.lower_count == 2 && tet.dual_in_lower && tet.dual_in_upper && widest >= Correspondence::overlap)
      witnesses.add(below, above, LinkCriterion::overlap);
  }
  return witnesses.links();
}

Correspondences correspond(const std::vector<RegionLink>& witnessed, const Choices& choices,
                           std::uint32_t lower_regions, std::uint32_t upper_regions, const Place& place) {
  UnionFind families(lower_regions + upper_regions);  // upper regions after the lower
  for (const auto& [a, b] : choices.joined) families.join(a, lower_regions + b);
  const auto broken = [&](UnionFind& now) {
    return std::any_of(choices.apart.begin(), choices.apart.end(),
                       [&](const auto& pair) { return now.find(pair.first) == now.find(lower_regions + pair.second); });
  };
  if (broken(families))
    throw InputError("link-contradiction", place,
                     "the links join two regions, directly or through others, that they also keep apart",
                     "Drop one of these links");
  Correspondences result;
  for (const auto& [a, b] : choices.joined) result.links.push_back({a, b, LinkCriterion::user});
  for (const RegionLink& link : witnessed) {
    if (std::find(choices.joined.begin(), choices.joined.end(), std::pair{link.lower, link.upper}) !=
        choices.joined.end())
      continue;
    if (choices.apart.empty()) {
      families.join(link.lower, lower_regions + link.upper);
    } else {
      UnionFind then = families;
      then.join(link.lower, lower_regions + link.upper);
      if (broken(then)) continue;
      families = std::move(then);
    }
    result.links.push_back(link);
  }
  std::sort(result.links.begin(), result.links.end(), [](const RegionLink& a, const RegionLink& b) {
    return std::pair(a.lower, a.upper) < std::pair(b.lower, b.upper);
  });

  std::map<std::uint32_t, Component> by_head;
  for (std::uint32_t r = 0; r < lower_regions; ++r) by_head[families.find(r)].lower.push_back(r);
  for (std::uint32_t r = 0; r < upper_regions; ++r) by_head[families.find(lower_regions + r)].upper.push_back(r);
  for (auto& [head, component] : by_head)
    if (!component.lower.empty() && !component.upper.empty()) result.components.push_back(std::move(component));
  return result;
}

bool joins_apart(const Component& component, const Choices& choices) {
  return std::any_of(choices.apart.begin(), choices.apart.end(), [&](const auto& pair) {
    return std::binary_search(component.lower.begin(), component.lower.end(), pair.first) &&
           std::binary_search(component.upper.begin(), component.upper.end(), pair.second);
  });
}

}  // namespace odontoscope::delaunay
