#include "recon/elements/end_heights.h"

#include <algorithm>
#include <map>
#include <utility>

namespace odontoscope::elements {

std::vector<double> end_heights(const InterfaceWeb& web) {
  std::map<Label, std::pair<double, double>> ends;
  for (const InterfaceTriangle& face : web.faces()) {
    for (const Label label : {face.inner, face.outer}) {
      if (label == void_label) continue;
      for (const PointIndex v : face.triangle) {
        const double z = web.points()[v].z;
        const auto [at, first] = ends.emplace(label, std::pair(z, z));
        at->second = {std::min(at->second.first, z), std::max(at->second.second, z)};
      }
    }
  }
  std::vector<double> heights;
  for (const auto& [label, span] : ends) heights.insert(heights.end(), {span.first, span.second});
  return heights;
}

bool is_level(const InterfaceWeb& web, std::uint32_t face, const std::vector<double>& heights) {
  const Triangle& t = web.faces()[face].triangle;
  const double z = web.points()[t[0]].z;
  return web.points()[t[1]].z == z && web.points()[t[2]].z == z &&
         std::find(heights.begin(), heights.end(), z) != heights.end();
}

}  // namespace odontoscope::elements
